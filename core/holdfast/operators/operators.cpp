#include "holdfast/operators/operators.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <holdfast/base/sparse_products.h>
#include <holdfast/operators/laplacian.h>

namespace holdfast {
namespace {

/// 1 / x, and 0 for 0: the row of an unknown without area stays empty.
Eigen::VectorXd reciprocal(const Eigen::VectorXd& x)
{
  return x.unaryExpr([](double value) { return value == 0 ? 0.0 : 1 / value; });
}

/// Raises areas below the floor; returns the unknowns where that happened. Unknowns in no part keep their zero.
std::vector<Index> floorAreas(Eigen::VectorXd& areas, const std::vector<int>& componentOf)
{
  const auto used =
      static_cast<double>(std::count_if(componentOf.begin(), componentOf.end(), [](Index c) { return c >= 0; }));
  const double floor = areas.sum() > 0 ? kAreaFloor * areas.sum() / used : 1.0;
  std::vector<Index> touched;
  for (Index i = 0; i < areas.size(); ++i)
    if (componentOf[i] >= 0 && areas[i] < floor) {
      areas[i] = floor;
      touched.push_back(i);
    }
  return touched;
}

void makeUniform(Operators& operators, const SolverMesh& mesh)
{
  SparseMatrix S = stiffness(mesh.unknownCount(), unitEdgeWeights(mesh.triangles));
  const Eigen::VectorXd diagonal = S.diagonal();
  operators.L = scaledRows(reciprocal(diagonal), std::move(S));
  operators.rowWeights.setOnes(mesh.unknownCount());
}

/// L = (2 M)^-1 S with M the mixed areas; rows weighted by sqrt(M), so that the energy is a quarter of S M^-1 S.
void makeCotangent(Operators& operators, const SolverMesh& mesh, const Positions& rest)
{
  std::vector<CornerCotangents> cotangents = cornerCotangents(rest, mesh.triangles);
  operators.clampedCotangents = guardAll(cotangents, mesh.triangles);
  Eigen::VectorXd areas = mixedVoronoiAreas(rest, mesh.triangles);
  operators.flooredAreas = floorAreas(areas, mesh.componentOf);
  SparseMatrix S = stiffness(mesh.unknownCount(), cotangentEdgeWeights(mesh.triangles, cotangents));
  operators.L = scaledRows(reciprocal(2 * areas), std::move(S));
  operators.rowWeights = areas.cwiseSqrt();
}

void makeCotangentPaper(Operators& operators, const SolverMesh& mesh, const Positions& rest)
{
  const std::vector<CornerCotangents> cotangents = cornerCotangents(rest, mesh.triangles);
  SparseMatrix S = stiffness(mesh.unknownCount(), cotangentEdgeWeights(mesh.triangles, cotangents));
  const Eigen::VectorXd areas = literalVoronoiAreas(rest, mesh.triangles);
  for (Index i = 0; i < areas.size(); ++i)
    if (mesh.componentOf[i] >= 0 && (!std::isfinite(S.coeff(i, i)) || !std::isfinite(1 / areas[i])))
      operators.undefinedRows.push_back(i);
  operators.L = scaledRows(reciprocal(2 * areas), std::move(S));
  operators.rowWeights.setOnes(mesh.unknownCount());
}

/// L p by differences along edges, whose rounding is that of edges and not of places.
Columns3 deltaOf(const SparseMatrix& L, const Positions& p)
{
  Columns3 delta = Columns3::Zero(L.rows(), 3);
  for (int j = 0; j < L.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(L, j); entry; ++entry)
      if (entry.row() != j) delta.row(entry.row()) += entry.value() * (p.row(j) - p.row(entry.row()));
  return delta;
}

}  // namespace

std::string_view name(Weights weights)
{
  constexpr std::array kNames{"cotangent", "cotangent-paper", "uniform"};
  return kNames[static_cast<std::size_t>(weights)];
}

Operators makeOperators(const SolverMesh& mesh, Weights weights)
{
  // About a vertex of the mesh, because rows of L sum to zero only up to rounding, which a faraway mesh would multiply.
  const Positions rest = restInDiagonals(mesh);
  Operators operators;
  operators.weights = weights;
  if (weights == Weights::Cotangent) makeCotangent(operators, mesh, rest);
  if (weights == Weights::CotangentPaper) makeCotangentPaper(operators, mesh, rest);
  if (weights == Weights::Uniform) makeUniform(operators, mesh);
  operators.delta = deltaOf(operators.L, rest);
  return operators;
}

SparseMatrix weightedRows(const Operators& operators)
{
  return scaledRows(operators.rowWeights, operators.L);
}

}  // namespace holdfast
