#include "holdfast/deform/rotation_stage.h"

#include <algorithm>
#include <utility>

#include <holdfast/rotation/edge_weights.h>
#include <holdfast/rotation/rotation_log.h>

namespace holdfast {
namespace {

bool asksForRotation(const ConstraintSystem& system)
{
  return std::any_of(system.rotations.begin(), system.rotations.end(),
                     [](const GivenRotation& given) { return !given.q.isZero(0); });
}

RotationProblem problemOf(const ConstraintSystem& system, const SolverMesh& mesh, Weights weights)
{
  RotationProblem problem{mesh.unknownCount(), rotationEdgeWeights(mesh, weights), {}, system.bodies};
  for (const GivenRotation& given : system.rotations) problem.prescribed.push_back(given.unknown);
  return problem;
}

Columns3 valuesOf(const ConstraintSystem& system)
{
  Columns3 values(static_cast<Index>(system.rotations.size()), 3);
  for (std::size_t k = 0; k < system.rotations.size(); ++k) values.row(k) = system.rotations[k].q;
  return values;
}

}  // namespace

RotationStage::RotationStage(const SolverMesh& mesh, Weights weights, Backend backend)
    : mesh_(mesh), weights_(weights), backend_(backend)
{
}

Rotations RotationStage::solve(const ConstraintSystem& system)
{
  if (!asksForRotation(system)) return {Columns3::Zero(mesh_.unknownCount(), 3), 0, {}};
  if (field_.solver == nullptr) field_ = decomposeRotations(problemOf(system, mesh_, weights_), backend_);
  if (field_.solver == nullptr) return {{}, 0, field_.failure};
  RotationField field = field_.solver->solve(valuesOf(system));
  return {std::move(field.q), field.accuracy, {}};
}

Columns3 turnedDetail(const Operators& operators, const Columns3& q, double diagonal)
{
  Columns3 f = Columns3::Zero(q.rows(), 3);
  for (Index i = 0; i < q.rows(); ++i) {
    if (q.row(i).isZero(0)) continue;
    const Vector3 delta = operators.delta.row(i);
    f.row(i) = diagonal * operators.rowWeights[i] * (rotationMatrix(Vector3(q.row(i))) * delta - delta);
  }
  return f;
}

}  // namespace holdfast
