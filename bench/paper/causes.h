#pragma once
/// \file
/// Causes of instability one by one, and what cures them.

#include <vector>

#include "bench/paper/bad_plates.h"
#include "bench/paper/printed_solver.h"

namespace holdfast::paper {

/// What rows of the Laplacian are made of.
struct Recipe {
  enum class Edges { OfMesh, IntrinsicDelaunay };
  enum class Cotangents { Plain, Guarded };
  enum class Areas { Printed, Mixed };      ///< by the formula of (10), cotangent weights; mixed, with the floor
  enum class Rows { Printed, RootOfArea };  ///< as they are; times the root of the size of the area

  const char* name = "";
  Edges edges = Edges::OfMesh;
  Cotangents cotangents = Cotangents::Plain;
  Areas areas = Areas::Printed;
  Rows rows = Rows::Printed;
};

/// Returns cotangent weights as printed in (10), with one cure each and with two; the product's default; and that
/// default on intrinsic Delaunay edges, without guarded cotangents and with them.
[[nodiscard]] const std::vector<Recipe>& allRecipes();

/// The rows, n x n, weighted. They may be infinite or NaN.
[[nodiscard]] SparseMatrix laplacianRows(const SolverMesh& mesh, const Recipe& recipe);

/// One plate by one recipe.
struct CauseOutcome {
  double condition = 0;  ///< of the normal equations; 0 where there is no factor
  Columns3 u;            ///< `Reference::u`; NaN where there is none
  Outcome printed;       ///< plain normal equations in double precision
  Outcome corrected;     ///< as the product solves: scaled columns, corrections, sparse QR where they do not serve
  Outcome augmented;     ///< [I, C; C^T, 0] [r; z] = [f; 0] by LU with pivoting, no correction
};

[[nodiscard]] CauseOutcome outcomeOf(const BentMesh& bent, const Recipe& recipe);

}  // namespace holdfast::paper
