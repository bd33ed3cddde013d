#pragma once
/// Operators are what the solver minimises: L, the weights of its rows, and delta, equations (1) to (3). They have
/// uniform weights (9) or cotangent weights (10).

#include <vector>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/energy_matrix.h>
#include <holdfast/operators/weights.h>

namespace holdfast {

/// L and delta are in units of the bounding box's diagonal (lengths divided by it). So nothing here depends on the
/// scale of the model.
struct Operators {
  Weights weights = Weights::Cotangent;
  /// S is n x n and symmetric. It has each edge with the negative of its weight, and rows of sum zero. Rows are empty
  /// for unknowns that no triangle uses.
  std::shared_ptr<const SparseMatrix> S;
  Eigen::VectorXd rowFactors;  ///< n: L = diag(rowFactors) S
  Eigen::VectorXd rowWeights;  ///< n: minimised is the sum of (rowWeights_i |(L p)_i - delta_i|)^2
  Columns3 delta;              ///< n x 3, L p at rest

  /// Returns L u. `L` returns L itself. O(entries).
  [[nodiscard]] Columns3 laplacianOf(const Columns3& u) const { return EnergyMatrix(rowFactors, S).times(u); }
  [[nodiscard]] SparseMatrix L() const { return EnergyMatrix(rowFactors, S).matrix(); }

  /// These unknowns, ascending, are of triangles where a guard of `Weights::Cotangent` acted.
  std::vector<Index> clampedCotangents;
  std::vector<Index> flooredAreas;
  /// These unknowns, ascending, have a row that is not finite (`Weights::CotangentPaper` at triangles without area).
  /// Nothing can be solved with them.
  std::vector<Index> undefinedRows;
};

/// Builds the operators. O(T log T).
[[nodiscard]] Operators makeOperators(const SolverMesh& mesh, Weights weights);

/// Returns A = diag(rowWeights) L, n x n.
[[nodiscard]] EnergyMatrix weightedRows(const Operators& operators);

}  // namespace holdfast
