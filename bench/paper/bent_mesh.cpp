#include "bench/paper/bent_mesh.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <holdfast/deform/deform.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/operators/operators.h>
#include <holdfast/ordering/elimination_order.h>

#include "bench/scenes.h"

namespace holdfast::paper {
namespace {

constexpr double kBentBy = 60;  // degrees

Mesh inDiagonals(Mesh mesh)
{
  const double diagonal = (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
  mesh.positions = ((mesh.positions.rowwise() - mesh.positions.row(0).eval()) / diagonal).eval();
  return mesh;
}

/// Without the rows that follow from others.
ConstraintSystem independentSystem(ConstraintSystem system, const SolverMesh& mesh)
{
  const EliminatedConstraints all = eliminate(system, mesh);
  std::vector<ConstraintRow> rows;
  for (const Index row : independentRows(all.dependencies, all.rows.size()))
    if (!all.rows[row].empty()) rows.push_back(system.rows[row]);
  system.rows = std::move(rows);
  return system;
}

/// Under the first `count` constraints of the scene.
BentMesh bentUnder(Mesh mesh, std::size_t count)
{
  BentMesh bent;
  bent.model = makeModel(inDiagonals(std::move(mesh)));
  ConstraintList list = bench::scene(bent.model.mesh);
  bench::turnHandle(list, kBentBy);
  list.constraints.resize(std::min(count, list.constraints.size()));
  const SolverMesh& solverMesh = bent.model.solverMesh;
  bent.system = independentSystem(
      makeConstraintSystem(list, bent.model.mesh, solverMesh, bent.model.locator(), "scene"), solverMesh);
  bent.eliminated = std::make_shared<const EliminatedConstraints>(eliminate(bent.system, solverMesh));
  bent.q = deform(bent.model, list, "scene").rotations;
  bent.ranks = eliminationRanks(solverMesh.unknownCount(), solverMesh.triangles);
  return bent;
}

}  // namespace

BentMesh bentMesh(Mesh mesh)
{
  return bentUnder(std::move(mesh), std::numeric_limits<std::size_t>::max());
}

BentMesh bentByEnds(Mesh mesh)
{
  return bentUnder(std::move(mesh), bench::kEnds);
}

BentProblem bentProblem(const BentMesh& bent, Weights weights)
{
  return bentProblem(bent, weightedRows(makeOperators(bent.model.solverMesh, weights)).matrix());
}

BentProblem bentProblem(const BentMesh& bent, SparseMatrix A)
{
  const SolverMesh& mesh = bent.model.solverMesh;
  BentProblem problem;
  Columns3 detail = Columns3::Zero(A.rows(), 3);  // by differences along edges, whose rounding is that of edges
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
      detail.row(entry.row()) += entry.value() * (mesh.rest.row(j) - mesh.rest.row(entry.row()));
  problem.f.resize(A.rows(), 3);
  for (Index i = 0; i < A.rows(); ++i)
    problem.f.row(i) = rotationMatrix(Vector3(bent.q.row(i))) * detail.row(i).transpose() - detail.row(i).transpose();
  problem.A = std::make_shared<const EnergyMatrix>(std::move(A));
  problem.B = constraintMatrix(bent.eliminated->rows, mesh.unknownCount());
  problem.d = shiftsOf(bent.system);
  return problem;
}

SparseMatrix freeColumns(const BentMesh& bent)
{
  const Index unknowns = bent.model.solverMesh.unknownCount();
  return orderedColumns(Elimination({}, {}, unknowns, bent.eliminated->isHeld).Q2(), bent.ranks);
}

ConstrainedProblem constrainedProblem(const BentMesh& bent, const BentProblem& problem)
{
  const Positions& rest = bent.model.solverMesh.rest;
  return {problem.A, bent.eliminated, rest.rowwise() - rest.colwise().mean(), bent.ranks};
}

}  // namespace holdfast::paper
