#pragma once
/// \file
/// Triangle connectivity that can be edited: flip, split, collapse.

#include <array>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast::generate {

using Triangle = std::array<Index, 3>;

/// An oriented manifold triangle mesh as half-edges. Face f owns the half-edges 3f, 3f + 1, 3f + 2 in its order of
/// turning. `kNone` stands for what is not there: the twin of a border edge, the corners of a removed face.
class HalfEdges {
 public:
  static constexpr Index kNone = -1;

  HalfEdges() = default;
  /// Every vertex id in `triangles` is below `vertexCount`. Throws std::logic_error where two faces share a half-edge.
  HalfEdges(const std::vector<Triangle>& triangles, Index vertexCount);

  [[nodiscard]] Index halfEdgeCount() const { return static_cast<Index>(origin_.size()); }
  [[nodiscard]] Index faceCount() const { return halfEdgeCount() / 3; }
  [[nodiscard]] Index vertexCount() const { return static_cast<Index>(outgoing_.size()); }
  [[nodiscard]] static Index next(Index halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
  [[nodiscard]] static Index previous(Index halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }
  [[nodiscard]] Index origin(Index halfEdge) const { return origin_[halfEdge]; }
  [[nodiscard]] Index target(Index halfEdge) const { return origin_[next(halfEdge)]; }
  /// The corner that `halfEdge` looks at across its face.
  [[nodiscard]] Index apex(Index halfEdge) const { return origin_[previous(halfEdge)]; }
  [[nodiscard]] Index twin(Index halfEdge) const { return twin_[halfEdge]; }
  [[nodiscard]] bool isRemoved(Index halfEdge) const { return origin_[halfEdge] == kNone; }
  [[nodiscard]] Triangle corners(Index face) const
  {
    return {origin_[3 * face], origin_[3 * face + 1], origin_[3 * face + 2]};
  }

  /// The half-edges that leave an inner vertex, in clockwise order.
  [[nodiscard]] std::vector<Index> outgoing(Index vertex) const;

  Index addVertex();
  /// Turns the inner edge of `halfEdge` in the quadrilateral of its two faces; afterwards it joins their apexes.
  void flip(Index halfEdge);
  /// Puts `vertex` into `face`, which becomes three.
  void splitFace(Index face, Index vertex);
  /// Puts `vertex` on the inner edge of `halfEdge`; its two faces become four.
  void splitEdge(Index halfEdge, Index vertex);
  /// Whether the surface is still a manifold once the inner edge of `halfEdge` is collapsed.
  [[nodiscard]] bool canCollapse(Index halfEdge) const;
  /// Merges the target of `halfEdge` into its origin. Precondition: `canCollapse(halfEdge)`.
  void collapse(Index halfEdge);

 private:
  void link(Index halfEdge, Index twin);
  void setOrigin(Index halfEdge, Index vertex);
  Index addFace();
  void closeGap(Index halfEdge);

  std::vector<Index> origin_;
  std::vector<Index> twin_;
  std::vector<Index> outgoing_;
};

}  // namespace holdfast::generate
