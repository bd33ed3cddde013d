#pragma once
/// Which triangles meet at each vertex.

#include <span>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// The triangles at each vertex, side by side in memory.
class VertexTriangles {
 public:
  /// Vertices are numbered below `vertexCount`. O(T + N).
  VertexTriangles(const std::vector<Triangle>& triangles, Index vertexCount);

  /// Ascending, each once.
  [[nodiscard]] std::span<const Index> of(Index vertex) const
  {
    const auto first = triangles_.begin() + starts_[vertex];
    return {first, triangles_.begin() + starts_[vertex + 1]};
  }

 private:
  std::vector<Index> starts_;  // of each vertex in what follows, and the end
  std::vector<Index> triangles_;
};

}  // namespace holdfast
