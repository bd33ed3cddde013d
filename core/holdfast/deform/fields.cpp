#include "holdfast/deform/fields.h"

#include <cmath>
#include <limits>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

/// The numbers `ofUnknown(u)` at the vertices of the file.
template <class OfUnknown>
Field scalarField(const char* name, const Weld& weld, const OfUnknown& ofUnknown)
{
  Field field{name, 1, {}};
  field.values.reserve(weld.unknownOf.size());
  for (const Index unknown : weld.unknownOf) field.values.push_back(ofUnknown(unknown));
  return field;
}

Field residualField(const Model& model, const DeformResult& deformation)
{
  std::vector<double> largest(static_cast<std::size_t>(model.solverMesh.unknownCount()),
                              std::numeric_limits<double>::quiet_NaN());
  const std::vector<double>& residuals = deformation.details->residuals;
  for (std::size_t r = 0; r < residuals.size(); ++r)
    for (const Term& term : deformation.details->system.rows[r].terms)
      largest[term.index] = std::fmax(largest[term.index], residuals[r]);
  return scalarField("constraint_residual", model.solverMesh.weld, [&](Index u) { return largest[u]; });
}

Field statusField(const Model& model, const DeformResult& deformation)
{
  constexpr std::array<double, 6> kCodes{0, 1, 2, 3, 4, 0};  // in the order of `ConstraintStatus`
  std::vector<double> gravest(static_cast<std::size_t>(model.solverMesh.unknownCount()), 0);
  for (const ConstraintRow& row : deformation.details->system.rows) {
    const ConstraintStatus status = deformation.report.constraints[row.constraint].status;
    for (const Term& term : row.terms)
      gravest[term.index] = std::max(gravest[term.index], kCodes[static_cast<std::size_t>(status)]);
  }
  return scalarField("constraint_status", model.solverMesh.weld, [&](Index u) { return gravest[u]; });
}

Field displacementField(const Model& model, const DeformResult& deformation)
{
  const Positions displacement = deformation.positions - model.mesh.positions;
  return {"displacement", 3, {displacement.data(), displacement.data() + displacement.size()}};
}

Field rotationField(const Model& model, const DeformResult& deformation)
{
  Field field{"rotation_log", 3, {}};
  field.values.reserve(3 * model.solverMesh.weld.unknownOf.size());
  for (const Index unknown : model.solverMesh.weld.unknownOf)
    for (const double q : deformation.rotations.row(unknown)) field.values.push_back(q);
  return field;
}

Field angleField(const Model& model, const DeformResult& deformation)
{
  return scalarField("rotation_angle_degrees", model.solverMesh.weld,
                     [&](Index u) { return angleDegrees(deformation.rotations.row(u).transpose()); });
}

Field multiplierField(const Model& model, const DeformResult& deformation)
{
  std::vector<double> lengths(static_cast<std::size_t>(model.solverMesh.unknownCount()),
                              std::numeric_limits<double>::quiet_NaN());
  const Columns3& multipliers = deformation.multipliers();
  if (multipliers.rows() > 0)
    for (const ConstraintRow& row : deformation.details->system.rows)
      for (const Term& term : row.terms) lengths[term.index] = multipliers.row(term.index).stableNorm();
  return scalarField("constraint_force", model.solverMesh.weld, [&](Index u) { return lengths[u]; });
}

Field detailField(const Model& model, const DeformResult& deformation)
{
  const SolverMesh& mesh = model.solverMesh;
  const Operators& operators = *deformation.details->operators;
  const Positions moved = deformation.positions - model.mesh.positions;
  const Columns3 u = moved(mesh.weld.firstVertexOf, Eigen::all) / mesh.diagonal;  // as L and delta are
  const Columns3 missed = operators.laplacianOf(u) - rotationOfDelta(operators.delta, deformation.rotations);
  // L of cotangents is one over a squared length.
  const double unit = operators.weights == Weights::Uniform ? mesh.diagonal : 1 / mesh.diagonal;
  return scalarField("detail_residual", mesh.weld, [&](Index k) { return unit * missed.row(k).stableNorm(); });
}

// In the order of `FieldKind`.
constexpr std::array kFields{residualField, statusField,     displacementField, rotationField,
                             angleField,    multiplierField, detailField};
static_assert(kFields.size() == static_cast<std::size_t>(FieldKind::DetailResidual) + 1);

}  // namespace

Field fieldOf(const Model& model, const DeformResult& deformation, FieldKind kind)
{
  return kFields[static_cast<std::size_t>(kind)](model, deformation);
}

std::vector<Field> fieldsOf(const Model& model, const DeformResult& deformation)
{
  std::vector<Field> fields;
  fields.reserve(kFields.size());
  for (const auto field : kFields) fields.push_back(field(model, deformation));
  return fields;
}

}  // namespace holdfast
