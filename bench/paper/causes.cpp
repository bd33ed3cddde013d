#include "bench/paper/causes.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/UmfPackSupport>

#include <holdfast/threads/one_thread_internal.h>

#include "bench/measure.h"
#include "bench/paper/intrinsic_delaunay.h"

namespace holdfast::paper {
namespace {

/// Of one triangle, by its corners, an eighth of (cot a + cot b) |p_i - p_j|^2 over the two sides at each.
std::array<double, 3> printedParts(const std::array<double, 3>& lengths, const CornerCotangents& cotangents)
{
  std::array<double, 3> parts{};
  for (int k = 0; k < 3; ++k) {
    const int previous = (k + 2) % 3;
    parts[k] = (lengths[k] * lengths[k] * cotangents[previous] +
                lengths[previous] * lengths[previous] * cotangents[(k + 1) % 3]) /
               8;
  }
  return parts;
}

/// Mixed areas (Meyer, Desbrun, Schroeder, Barr, 2003): see `mixedVoronoiAreas`.
std::array<double, 3> mixedParts(const std::array<double, 3>& lengths, const CornerCotangents& cotangents)
{
  const auto obtuse = std::ranges::find_if(cotangents, [](double cotangent) { return cotangent < 0; });
  if (obtuse == cotangents.end()) return printedParts(lengths, cotangents);
  const double whole = area(lengths);
  std::array<double, 3> parts{whole / 4, whole / 4, whole / 4};
  parts[obtuse - cotangents.begin()] = whole / 2;
  return parts;
}

struct Parts {
  Eigen::VectorXd areas;
  SparseMatrix S;
};

Parts partsOf(const IntrinsicTriangles& mesh, Index n, const Recipe& recipe)
{
  Parts parts{Eigen::VectorXd::Zero(n), SparseMatrix(n, n)};
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const CornerCotangents plain = cotangents(mesh.lengths[t]);
    const CornerCotangents used = recipe.cotangents == Recipe::Cotangents::Guarded ? guarded(plain) : plain;
    const auto areas =
        recipe.areas == Recipe::Areas::Mixed ? mixedParts(mesh.lengths[t], plain) : printedParts(mesh.lengths[t], used);
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<int>(mesh.triangles[t][k]);
      const auto j = static_cast<int>(mesh.triangles[t][(k + 1) % 3]);
      const double weight = used[(k + 2) % 3];
      entries.insert(entries.end(), {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
      parts.areas[i] += areas[k];
    }
  }
  parts.S.setFromTriplets(entries.begin(), entries.end());
  return parts;
}

/// M of [I, M; M^T, 0] [r; x] = [b; 0].
std::optional<Columns3> augmentedSolution(const SparseMatrix& M, const Columns3& b)
{
  const Index rows = M.rows();
  const Index columns = M.cols();
  const SparseMatrix MT = M.transpose();
  const auto K = assembled<SparseMatrix>(rows + columns, rows + columns, [&](Index j, ColumnSum& sum) {
    if (j >= rows) return sum.addColumn(M, j - rows);
    sum.add(static_cast<int>(j), 1);
    sum.addColumn(MT, j, rows);
  });
  const OneThread libraries;
  Eigen::UmfPackLU<Eigen::SparseMatrix<double>> factor;
  factor.umfpackControl()[UMFPACK_IRSTEP] = 0;
  factor.compute(K);
  if (factor.info() != Eigen::Success) return std::nullopt;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(K.rows(), 3);
  right.topRows(rows) = b;
  return Columns3(Eigen::MatrixX3d(factor.solve(right)).bottomRows(columns));
}

Outcome solvedAugmented(const BentMesh& bent, const BentProblem& problem, const Columns3& reference)
{
  const Elimination& elimination = bent.eliminated->elimination;
  Columns3 u = elimination.particular(problem.d);
  std::optional<Columns3> z;
  const double seconds = bench::secondsOf(
      [&] { z = augmentedSolution(product(*problem.A, elimination.Q2()), problem.A->residual(problem.f, u)); });
  if (!z) return {"fails", 0, 0, seconds};
  u += elimination.Q2() * *z;
  return judged(problem, u, reference, seconds);
}

}  // namespace

const std::vector<Recipe>& allRecipes()
{
  using R = Recipe;
  static const std::vector<Recipe> kAll{
      {"as printed"},
      {"intrinsic Delaunay", R::Edges::IntrinsicDelaunay},
      {"guarded cotangents", R::Edges::OfMesh, R::Cotangents::Guarded},
      {"mixed areas", R::Edges::OfMesh, R::Cotangents::Plain, R::Areas::Mixed},
      {"rows by area", R::Edges::OfMesh, R::Cotangents::Plain, R::Areas::Printed, R::Rows::RootOfArea},
      {"mixed areas, rows by area", R::Edges::OfMesh, R::Cotangents::Plain, R::Areas::Mixed, R::Rows::RootOfArea},
      {"default", R::Edges::OfMesh, R::Cotangents::Guarded, R::Areas::Mixed, R::Rows::RootOfArea},
      {"default without guard, intrinsic Delaunay", R::Edges::IntrinsicDelaunay, R::Cotangents::Plain, R::Areas::Mixed,
       R::Rows::RootOfArea},
      {"default, intrinsic Delaunay", R::Edges::IntrinsicDelaunay, R::Cotangents::Guarded, R::Areas::Mixed,
       R::Rows::RootOfArea}};
  return kAll;
}

SparseMatrix laplacianRows(const SolverMesh& mesh, const Recipe& recipe)
{
  IntrinsicTriangles triangles = intrinsicTriangles(restInDiagonals(mesh), mesh.triangles);
  if (recipe.edges == Recipe::Edges::IntrinsicDelaunay) triangles = delaunay(std::move(triangles));
  auto [areas, S] = partsOf(triangles, mesh.unknownCount(), recipe);
  if (recipe.areas == Recipe::Areas::Mixed) areas = areas.cwiseMax(kAreaFloor * areas.mean()).eval();
  Eigen::VectorXd factors = (2 * areas).cwiseInverse();
  if (recipe.rows == Recipe::Rows::RootOfArea) factors.array() *= areas.array().abs().sqrt();
  return factors.asDiagonal() * S;
}

CauseOutcome outcomeOf(const BentMesh& bent, const Recipe& recipe)
{
  const BentProblem problem = bentProblem(bent, laplacianRows(bent.model.solverMesh, recipe));
  const Method hard{SolverKind::Hard};
  CauseOutcome outcome;
  Reference reference{Columns3::Constant(problem.f.rows(), 3, std::numeric_limits<double>::quiet_NaN())};
  if (const Result<ReducedProblem> reduced = reducedProblem(bent, problem, hard)) {
    reference = quadrupleSolution(bent, problem, reduced.value, hard);
    outcome.condition = conditionOf(reduced.value);
  }
  outcome.printed = solvedInDouble(bent, problem, hard, reference.u);
  outcome.corrected = solvedByProduct(bent, problem, hard, reference.u);
  outcome.augmented = solvedAugmented(bent, problem, reference.u);
  outcome.u = reference.u;
  return outcome;
}

}  // namespace holdfast::paper
