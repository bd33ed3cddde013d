#pragma once
/// What the solver minimises: L, the weights of its rows, and delta, equations (1) to (3), with uniform weights (9) or
/// cotangent weights (10).

#include <vector>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/energy_matrix.h>
#include <holdfast/operators/weights.h>

namespace holdfast {

/// L and delta in units of the bounding box's diagonal (lengths divided by it), so that nothing here depends on the
/// scale of the model.
struct Operators {
  Weights weights = Weights::Cotangent;
  /// n x n, symmetric: each edge with the negative of its weight, rows of sum zero; empty rows for unknowns that no
  /// triangle uses.
  std::shared_ptr<const SparseMatrix> S;
  Eigen::VectorXd rowFactors;  ///< n: L = diag(rowFactors) S
  Eigen::VectorXd rowWeights;  ///< n: minimised is the sum of (rowWeights_i |(L p)_i - delta_i|)^2
  Columns3 delta;              ///< n x 3, L p at rest

  /// L u, and L itself. O(entries).
  [[nodiscard]] Columns3 laplacianOf(const Columns3& u) const { return EnergyMatrix(rowFactors, S).times(u); }
  [[nodiscard]] SparseMatrix L() const { return EnergyMatrix(rowFactors, S).matrix(); }

  /// Unknowns of triangles where a guard of `Weights::Cotangent` acted, ascending.
  std::vector<Index> clampedCotangents;
  std::vector<Index> flooredAreas;
  /// Unknowns whose row is not finite (`Weights::CotangentPaper` at triangles without area), ascending. Nothing can be
  /// solved with them.
  std::vector<Index> undefinedRows;
};

/// Builds the operators. O(T log T).
[[nodiscard]] Operators makeOperators(const SolverMesh& mesh, Weights weights);

/// A = diag(rowWeights) L, n x n.
[[nodiscard]] EnergyMatrix weightedRows(const Operators& operators);

}  // namespace holdfast
