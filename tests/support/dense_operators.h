#pragma once
/// \file
/// The operators and the rows of constraints written down a second time, densely and straight from the definitions, for
/// comparison with the engine. Meshes without coinciding vertices, on which no guard of the engine acts: there is none
/// here.

#include <Eigen/Core>

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/triangulation.h>
#include <holdfast/operators/operators.h>

namespace holdfast::test {

/// The Laplacian of equations (1) to (3) with uniform weights (9) or cotangent weights (10), n x n, for lengths in
/// units of `unit`.
[[nodiscard]] Eigen::MatrixXd denseL(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights,
                                     double unit);

/// The weights of its rows.
[[nodiscard]] Eigen::VectorXd denseRowWeights(const Mesh& mesh, const std::vector<Triangle>& triangles, Weights weights,
                                              double unit);

/// Rows of the points of a list (no `near`), one a constraint, and what each asks of the displacement.
struct DenseRows {
  Eigen::MatrixXd B;
  Eigen::MatrixX3d shifts;
};
[[nodiscard]] DenseRows denseRows(const ConstraintList& list, const Mesh& mesh);

/// Minimise |A u| under B u = d.
struct DenseProblem {
  Eigen::MatrixXd A;
  Eigen::MatrixXd B;
  Eigen::MatrixX3d d;
};
[[nodiscard]] DenseProblem denseProblem(const Mesh& mesh, const ConstraintList& list, Weights weights);

}  // namespace holdfast::test
