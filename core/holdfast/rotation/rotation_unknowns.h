#pragma once
/// \file
/// Which rotations of a mesh are given, which are equal, and which are left to find.

#include <vector>

#include <holdfast/operators/laplacian.h>

namespace holdfast {

/// The rotation field that minimises the sum of w_ij |q_i - q_j|^2 with q given at some unknowns and equal inside rigid
/// regions.
struct RotationProblem {
  Index unknownCount = 0;
  std::vector<EdgeWeight> weights;               ///< each edge once
  std::vector<Index> prescribed;                 ///< unknowns whose q is given, in the order of precedence
  std::vector<std::vector<Index>> rigidRegions;  ///< unknowns of each rigid region; regions that overlap are one
};

/// Each unknown is one of three: given (`givenOf`), free (`columnOf`), or out of reach of everything given (neither).
struct RotationUnknowns {
  std::vector<Index> givenOf;      ///< of each unknown: place in `prescribed` of the value that it has; -1
  std::vector<Index> columnOf;     ///< of each unknown: its column, that of all free unknowns of one region; -1
  std::vector<Index> leaderOf;     ///< of each place in `prescribed`: the first place of the same region
  std::vector<Index> referenceOf;  ///< of each column: the first place in `prescribed` that edges and regions tie it to

  [[nodiscard]] Index columnCount() const noexcept { return static_cast<Index>(referenceOf.size()); }
};

/// In a region where several unknowns are given, each keeps its own value, and all others have that of the first. Of an
/// unknown that is given twice the first stands. Edges of weight 0 tie nothing. Ids are in range. Nearly O(n + edges).
[[nodiscard]] RotationUnknowns rotationUnknowns(const RotationProblem& problem);

}  // namespace holdfast
