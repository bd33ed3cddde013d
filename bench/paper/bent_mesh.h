#pragma once
/// \file
/// The deformation on which solvers are compared: one end of a mesh fixed, the other one moved and turned, and points
/// between them moved (`scene`), in units of the diagonal of the bounding box.

#include <memory>
#include <vector>

#include <holdfast/deform/model.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/weights.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast::paper {

/// What does not depend on the weights of the Laplacian.
struct BentMesh {
  Model model;              ///< of diagonal 1, about its first vertex
  ConstraintSystem system;  ///< its independent rows
  std::shared_ptr<const EliminatedConstraints> eliminated;
  Columns3 q;              ///< of each unknown: the rotation of its detail, as the product finds it
  std::vector<int> ranks;  ///< an order of elimination that leaves little to compute
};

/// Bends `mesh`, which is of triangles, by 60 degrees. Throws what `makeModel` throws.
[[nodiscard]] BentMesh bentMesh(Mesh mesh);

/// The same without points between the ends.
[[nodiscard]] BentMesh bentByEnds(Mesh mesh);

/// Minimise |A u - f| under B u = d, u being the displacement.
struct BentProblem {
  std::shared_ptr<const EnergyMatrix> A;
  Columns3 f;
  SparseRows B;
  Columns3 d;
};

/// With the rows of `weights` and the detail turned. Rows may be infinite or NaN for `Weights::CotangentPaper`, where
/// (10), cotangent weights as printed, is not defined: see `Operators::undefinedRows`.
[[nodiscard]] BentProblem bentProblem(const BentMesh& bent, Weights weights);

/// The same for any rows, of which each has the detail of its unknown.
[[nodiscard]] BentProblem bentProblem(const BentMesh& bent, SparseMatrix A);

/// n x k: an identity column for each unknown that constraints place, in the order of elimination.
[[nodiscard]] SparseMatrix freeColumns(const BentMesh& bent);

/// Returns the problem as the product's solvers take it.
[[nodiscard]] ConstrainedProblem constrainedProblem(const BentMesh& bent, const BentProblem& problem);

}  // namespace holdfast::paper
