#include "holdfast/deform/deform.h"

#include <holdfast/deform/deformer.h>
#include <holdfast/deform/messages.h>
#include <holdfast/deform/place_findings.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/deform/tolerant_points.h>
#include <holdfast/memory/available_memory.h>
#include <holdfast/rotation/decided_rotations.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/verdict/result_check.h>

namespace holdfast {
namespace {

/// What targets say together, which needs no solution.
void addTargets(Report& report, const Model& model, const ConstraintSystem& system, RotationSource rotations)
{
  Findings findings;
  addTargetFindings(findings, model.solverMesh, system, rotations);
  for (Finding& finding : findings) {
    report.result.warnings.push_back(finding.kind);
    report.mesh.findings.push_back(std::move(finding));
  }
  report.result.targetMotions = targetMotionsOf(wholeMotions(system, model.solverMesh));
}

}  // namespace

DeformResult deform(const Model& model, const ConstraintList& constraints, const std::string& source,
                    const DeformOptions& options, Progress& progress)
{
  const LeastMemory memory;
  // A pointer that owns nothing: the deformer is gone before the caller's model.
  Deformer deformer(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model), options,
                    DeformerMode::OneCall);
  DeformResult result = deformer.deform(constraints, source, progress);
  result.report = deformer.examined(result, progress);
  return result;
}

namespace {

/// The diagnosis of `system`, whose rows it rotates by `q`: given rotations, or those from which others are found.
Diagnosis rotatedDiagnosis(const EliminatedByAxes& eliminated, ConstraintSystem& system, const SolverMesh& mesh,
                           RotationSource source, Columns3 q)
{
  DecidedRotations decided(eliminated.inAllDirections(), system, mesh);
  if (source != RotationSource::Given) decided.settle(system, q);
  system = decided.withTurnedVectors(rotated(std::move(system), q));
  Contradictions contradictions;
  if (!system.tolerant.empty())
    contradictions = chooseTargets(system, {eliminated, looseStiffness(system, eliminated), mesh.diagonal},
                                   Columns3::Zero(static_cast<Index>(system.rows.size()), 3))
                         .contradictions;
  Diagnosis diagnosis = diagnose(eliminated, system, mesh);
  diagnosis.reasons = std::move(contradictions);
  if (source == RotationSource::Given)
    diagnosis.metIfFound = closedWhereFound(eliminated.inAllDirections(), system, mesh, diagnosis, std::move(q));
  else
    diagnosis.reasons.merge(decided.reasons());
  return diagnosis;
}

}  // namespace

Report diagnoseConstraints(const Model& model, const ConstraintList& constraints, const std::string& source,
                           const DeformOptions& options)
{
  Report report;
  report.mesh = describeMesh(model);
  report.solve.weights = options.weights;
  report.solve.options = options.solver;
  report.solve.rotations = options.rotations.source;
  ConstraintSystem system = makeConstraintSystem(constraints, model.mesh, model.solverMesh, model.locator(), source);
  PlaceFindings placeFindings;
  placeFindings.update(system.nearPlaces, model.locator(), options.nearLimit * model.solverMesh.diagonal);
  if (options.rotations.source != RotationSource::Given) system = withStatedRotations(std::move(system));
  const EliminatedByAxes eliminated(system, model.solverMesh, kRankTolerance);
  std::shared_ptr<const Operators> operators;
  if (asksForRotation(system))
    operators = std::make_shared<const Operators>(makeOperators(model.solverMesh, options.weights));
  Rotations rotations =
      RotationFactorization(model.solverMesh, std::move(operators), options.solver.backend).solve(system, noProgress());
  takeOver(rotations, report);
  DeformDetails details;
  if (rotations.failure.empty()) {
    details.diagnosis =
        rotatedDiagnosis(eliminated, system, model.solverMesh, options.rotations.source, std::move(rotations.q));
  } else {
    report.solve.status = SolveStatus::Failed;
    report.solve.message = failureMessage(options, rotations.failure);
    details.diagnosis = diagnose(eliminated, system, model.solverMesh);
  }
  details.system = std::move(system);
  details.labels = labelsOf(constraints, nullptr);
  details.sensitivities = std::make_shared<const std::vector<double>>(eliminated.sensitivities());
  report.constraints = outcomes(details, {});
  for (Finding& finding : constraintFindings(model, eliminated, details))
    report.mesh.findings.push_back(std::move(finding));
  if (std::optional<Finding> crowd = crowdedFinding(details)) report.mesh.findings.push_back(*std::move(crowd));
  placeFindings.addTo(report.mesh.findings);
  addTargets(report, model, details.system, options.rotations.source);
  return report;
}

const Columns3& DeformResult::multipliers() const
{
  static const Columns3 kEmpty;
  return details != nullptr && details->multipliers.valid() ? details->multipliers.get().atUnknowns : kEmpty;
}

MeshReport describeMesh(const Model& model)
{
  return {model.mesh.vertexCount(), model.mesh.faces.size(), model.solverMesh.componentCount, model.solverMesh.diagonal,
          model.findings};
}

}  // namespace holdfast
