#include "holdfast/operators/operators.h"

#include <algorithm>
#include <cmath>

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

void setStiffness(Operators& operators, const SolverMesh& mesh, const std::vector<EdgeWeight>& weights)
{
  operators.S = std::make_shared<const SparseMatrix>(stiffness(mesh.unknownCount(), weights));
}

void makeUniform(Operators& operators, const SolverMesh& mesh)
{
  setStiffness(operators, mesh, unitEdgeWeights(mesh.triangles));
  operators.rowFactors = reciprocal(operators.S->diagonal());
  operators.rowWeights.setOnes(mesh.unknownCount());
}

/// L = (2 M)^-1 S with M the mixed areas; rows weighted by sqrt(M), so that the energy is a quarter of S M^-1 S.
void makeCotangent(Operators& operators, const SolverMesh& mesh, const Positions& rest)
{
  std::vector<CornerCotangents> cotangents = cornerCotangents(rest, mesh.triangles);
  operators.clampedCotangents = guardAll(cotangents, mesh.triangles);
  Eigen::VectorXd areas = mixedVoronoiAreas(rest, mesh.triangles);
  operators.flooredAreas = floorAreas(areas, mesh.componentOf);
  setStiffness(operators, mesh, cotangentEdgeWeights(mesh.triangles, cotangents));
  operators.rowFactors = reciprocal(2 * areas);
  operators.rowWeights = areas.cwiseSqrt();
}

void makeCotangentPaper(Operators& operators, const SolverMesh& mesh, const Positions& rest)
{
  const std::vector<CornerCotangents> cotangents = cornerCotangents(rest, mesh.triangles);
  setStiffness(operators, mesh, cotangentEdgeWeights(mesh.triangles, cotangents));
  const Eigen::VectorXd areas = literalVoronoiAreas(rest, mesh.triangles);
  for (Index i = 0; i < areas.size(); ++i)
    if (mesh.componentOf[i] >= 0 && (!std::isfinite(operators.S->coeff(i, i)) || !std::isfinite(1 / areas[i])))
      operators.undefinedRows.push_back(i);
  operators.rowFactors = reciprocal(2 * areas);
  operators.rowWeights.setOnes(mesh.unknownCount());
}

/// L p by differences along edges, whose rounding is that of edges and not of places.
Columns3 deltaOf(const Operators& operators, const Positions& p)
{
  Columns3 delta(p.rows(), 3);
  parallelBlocks(p.rows(), [&](Index i) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (SparseMatrix::InnerIterator entry(*operators.S, i); entry; ++entry)
      if (entry.row() != i) sum += entry.value() * (p.row(entry.row()) - p.row(i));
    delta.row(i) = operators.rowFactors[i] * sum;
  });
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
  operators.delta = deltaOf(operators, rest);
  return operators;
}

EnergyMatrix weightedRows(const Operators& operators)
{
  return {operators.rowWeights.cwiseProduct(operators.rowFactors), operators.S};
}

}  // namespace holdfast
