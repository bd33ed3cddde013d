#pragma once
/// Vertices that stand out of a deformed surface by far more than the constraints near them ask for: points that nearly
/// contradict one another are met all the same, at the expense of the vertices that they hang on.

#include <optional>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/verdict/shape_change.h>

namespace holdfast {

/// The center of a face whose other two corners are held moves the third by three times as much. Where a vertex stands
/// out by more than this factor of what is asked for near it, targets are enlarged more than any single place explains.
inline constexpr double kOvershootLimit = 4;

struct Overshoot {
  double largest = 0;           ///< how far a vertex stands out at most, beyond how it does at rest; model units
  double asked = 0;             ///< the largest difference that constraints near one of `vertices` ask for; model units
  std::vector<Index> vertices;  ///< of the file, those beyond the limit, ascending
  std::vector<Index> constraints;  ///< places in the list of those whose points hang on them, ascending
};

/// Whether the row says where a point is, or lies to another, that hangs on several vertices.
[[nodiscard]] bool hangsOnSeveral(const ConstraintRow& row);

/// Measures the vertices on which points inside of faces and edges hang. A vertex stands out by the distance from the
/// mean of its neighbours, which no rotation changes. What is asked for near it: how much the shifts of rows differ
/// that hang on it or on its neighbours, from one another and from the mean of the part. O(rows times neighbours); more
/// where something is found.
class OvershootSearch {
 public:
  explicit OvershootSearch(const RestSurface& rest, Index vertexCount);

  [[nodiscard]] Overshoot find(const DeformedSurface& surface, const ConstraintSystem& system) const;

 private:
  [[nodiscard]] double standsOut(const DeformedSurface& surface, Index vertex) const;
  void addVertices(Overshoot& result, const SolverMesh& mesh, const ConstraintSystem& system,
                   const std::vector<Index>& vertices, const std::vector<double>& out) const;

  IndexLists neighbours_;
};

}  // namespace holdfast
