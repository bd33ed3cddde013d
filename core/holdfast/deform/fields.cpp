#include <algorithm>
#include <cmath>
#include <limits>

#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>

namespace holdfast {
namespace {

/// Values of unknowns at the vertices of the file.
std::vector<double> spread(const std::vector<double>& ofUnknowns, const Weld& weld)
{
  std::vector<double> values;
  values.reserve(weld.unknownOf.size());
  for (const Index unknown : weld.unknownOf) values.push_back(ofUnknowns[unknown]);
  return values;
}

Field residualField(const Model& model, const Deformation& deformation)
{
  std::vector<double> largest(static_cast<std::size_t>(model.solverMesh.unknownCount()),
                              std::numeric_limits<double>::quiet_NaN());
  const std::vector<double> residuals = rowResiduals(deformation.system, model.solverMesh.weld, deformation.positions);
  for (std::size_t r = 0; r < residuals.size(); ++r)
    for (const PointTerm& term : deformation.system.rows[r].terms)
      largest[term.vertex] = std::fmax(largest[term.vertex], residuals[r]);
  return {"constraint_residual", 1, spread(largest, model.solverMesh.weld)};
}

double statusCode(ConstraintStatus status)
{
  switch (status) {
    case ConstraintStatus::Met:
      return 1;
    case ConstraintStatus::Redundant:
      return 2;
    case ConstraintStatus::Conflicting:
      return 3;
    case ConstraintStatus::Missed:
      return 4;
    case ConstraintStatus::Independent:
    case ConstraintStatus::Disabled:
      return 0;
  }
  return 0;
}

Field statusField(const Model& model, const Deformation& deformation)
{
  std::vector<double> gravest(static_cast<std::size_t>(model.solverMesh.unknownCount()), 0);
  for (const ConstraintRow& row : deformation.system.rows)
    for (const PointTerm& term : row.terms)
      gravest[term.vertex] =
          std::max(gravest[term.vertex], statusCode(deformation.report.constraints[row.constraint].status));
  return {"constraint_status", 1, spread(gravest, model.solverMesh.weld)};
}

Field displacementField(const Model& model, const Deformation& deformation)
{
  const Positions displacement = deformation.positions - model.mesh.positions;
  return {"displacement", 3, {displacement.data(), displacement.data() + displacement.size()}};
}

Field detailField(const Model& model, const Deformation& deformation)
{
  const SolverMesh& mesh = model.solverMesh;
  Columns3 u(mesh.unknownCount(), 3);
  for (Index k = 0; k < u.rows(); ++k) {
    const Index v = mesh.weld.firstVertexOf[k];
    u.row(k) = deformation.positions.row(v) - model.mesh.positions.row(v);
  }
  // L was made of lengths in units of the diagonal; that of cotangents is one over a squared length.
  const bool isUniform = deformation.operators.weights == Weights::Uniform;
  const double scale = isUniform ? 1 : 1 / (mesh.diagonal * mesh.diagonal);
  const Eigen::VectorXd lengths = scale * (deformation.operators.L * u).rowwise().norm();
  return {"detail_residual", 1, spread({lengths.begin(), lengths.end()}, mesh.weld)};
}

}  // namespace

std::vector<Field> fieldsOf(const Model& model, const Deformation& deformation)
{
  return {residualField(model, deformation), statusField(model, deformation), displacementField(model, deformation),
          detailField(model, deformation)};
}

}  // namespace holdfast
