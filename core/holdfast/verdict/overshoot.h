#pragma once
/// Vertices that stand out of a deformed surface by far more than the constraints near them ask for. Points that nearly
/// contradict one another are met all the same, at the expense of the vertices that they hang on.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/verdict/shape_change.h>

namespace holdfast {

/// Where the other two corners of a face are held, its centre moves the third by three times as much. A vertex may
/// stand out by more than this factor of what is asked for near it. Then targets are enlarged more than any single
/// place explains.
inline constexpr double kOvershootLimit = 4;

struct Overshoot {
  double largest = 0;           ///< how far a vertex stands out at most, beyond how it does at rest; model units
  double asked = 0;             ///< the largest difference that constraints near one of `vertices` ask for; model units
  std::vector<Index> vertices;  ///< of the file, those beyond the limit, ascending
  std::vector<Index> constraints;  ///< list places of those whose points hang on them, ascending
};

/// Tells whether the row says where a point is that hangs on several vertices, or how it lies to another.
[[nodiscard]] bool hangsOnSeveral(const ConstraintRow& row);

/// Measures the vertices on which points inside faces and edges hang. A vertex stands out by its distance from the mean
/// of its neighbours, which no rotation changes. What is asked for near it comes from the rows that hang on it or on
/// its neighbours. It is how much their shifts differ, from one another and from the mean of the part. O(rows times
/// neighbours); more where something is found.
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
