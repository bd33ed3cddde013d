#pragma once
/// Faces of a deformed surface that cross others and did not at rest.

#include <optional>
#include <vector>

#include <holdfast/surface/triangle_tree.h>
#include <holdfast/threads/progress.h>
#include <holdfast/verdict/shape_change.h>

namespace holdfast {

/// Tells whether an edge of one triangle runs through the inside of the other, by more than `touch` on both sides of
/// it. Triangles that share a vertex may cross elsewhere. Triangles that share an edge, or lie in one plane, do not
/// cross.
[[nodiscard]] bool areCrossing(const Triangle& a, const Triangle& b, const Positions& positions, double touch);

struct CrossingTriangles {
  std::vector<int> triangles;  ///< ascending
  bool areAll = true;          ///< false where so many boxes meet that the search was given up
};

/// Finds crossing triangles of one surface again and again. The tree is that of the surface at rest.
class CrossingSearch {
 public:
  /// `rest` and `atRest` must stay alive as long as this. O(T log T).
  CrossingSearch(const RestSurface& rest, const Positions& atRest);

  /// Returns the triangles that cross others. It leaves out those that cross others at rest, with their neighbours:
  /// where a surface passes through itself already, that says nothing of the deformation. O(T log T), over all cores.
  /// It looks at only a part of surfaces that are crumpled all over. Throws what `progress` throws.
  [[nodiscard]] CrossingTriangles find(const Positions& now, Progress& progress = noProgress());

 private:
  struct Pairs {
    std::vector<std::pair<int, int>> crossing;
    bool areAll = true;
  };
  [[nodiscard]] Pairs pairsAt(const Positions& places, Progress& progress) const;
  void markCrossedAtRest(Progress& progress);

  const RestSurface& rest_;
  const Positions& atRest_;
  TriangleTree tree_;
  std::optional<std::vector<bool>> isCrossedAtRest_;  // vertices of such triangles; made when it is first needed
};

}  // namespace holdfast
