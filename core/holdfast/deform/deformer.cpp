#include "holdfast/deform/deformer.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <holdfast/deform/factor_store.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/place_findings.h>
#include <holdfast/deform/solved_frame.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/threads/stopwatch.h>
#include <holdfast/verdict/result_check.h>
#include <holdfast/words/error.h>

namespace holdfast {

/// A list becomes rows, rows find a factorization that serves them, and both make a frame. What the next list may have
/// in common with this one is kept.
struct Deformer::State {
  State(std::shared_ptr<const Model> itsModel, const DeformOptions& itsOptions, DeformerMode itsMode)
      : model(std::move(itsModel)), options(itsOptions), mode(itsMode), factors(model, options, mode)
  {
  }

  [[nodiscard]] DeformResult deform(const ConstraintList& list, const std::string& source, bool goesOn,
                                    Progress& progress)
  {
    const Stopwatch setup;
    factors.orderUnknowns(progress);
    ConstraintSystem system = systemOf(list, source);
    labels = labelsOf(list, std::move(labels));
    const ModelOperators& operators = factors.operators(progress);
    const double setupSeconds = setup.seconds();

    const Stopwatch elimination;
    ConstraintFactorization& by = factors.serving(system, progress);
    const double eliminationSeconds = elimination.seconds();

    const FrameProblem problem{*model, options, operators, labels, goesOn ? &lastRotations : nullptr};
    DeformResult result = solved(problem, std::move(system), by, progress);
    factors.makeNext(progress);
    if (isFound() && result.report.solve.status != SolveStatus::Failed) lastRotations = result.rotations;
    placeFindings.addTo(result.report.mesh.findings);
    result.report.solve.seconds.setup = setupSeconds;
    result.report.solve.seconds.factorization += eliminationSeconds;
    return result;
  }

  [[nodiscard]] bool isFound() const { return options.rotations.source != RotationSource::Given; }

  /// The rows of `list`, with findings about their places in `placeFindings`.
  [[nodiscard]] ConstraintSystem systemOf(const ConstraintList& list, const std::string& source)
  {
    // The index of the surface is worth its memory where somebody asks again.
    const SurfaceLocator locator =
        mode == DeformerMode::OneCall ? SurfaceLocator(model->mesh, model->triangulation) : model->locator();
    ConstraintSystem system = makeConstraintSystem(list, model->mesh, model->solverMesh, locator, source, places);
    placeFindings.update(system.nearPlaces, locator, options.nearLimit * model->solverMesh.diagonal);
    return isFound() ? withStatedRotations(std::move(system)) : system;
  }

  /// By the factorization at hand; where it does not do, without its border, and where rows that nearly depend on
  /// others keep all from being met, with fewer rows.
  [[nodiscard]] DeformResult solved(const FrameProblem& problem, ConstraintSystem system, ConstraintFactorization& by,
                                    Progress& progress)
  {
    ConstraintSystem again;
    if (by.isBordered || by.mayHaveFewerRows) again = system;
    SolvedFrame frame = solveFrame(problem, std::move(system), by, progress);
    if (by.isBordered && frame.result.report.solve.status == SolveStatus::Failed)
      frame = solveFrame(problem, again, factors.unbordered(), progress);
    while (ConstraintFactorization* fewer = factors.withFewerRows(again, frame.neededDistance, progress))
      frame = solveFrame(problem, again, *fewer, progress);
    return std::move(frame.result);
  }

  [[nodiscard]] ResultCheck& check()
  {
    if (!checkOfResults) checkOfResults.emplace(model->solverMesh, model->mesh.positions);
    return *checkOfResults;
  }

  std::shared_ptr<const Model> model;
  DeformOptions options;
  DeformerMode mode;
  FactorStore factors;
  ConstraintList constraints;
  KnownPlaces places;
  PlaceFindings placeFindings;                     // of the last list
  std::shared_ptr<const ConstraintLabels> labels;  // of the last list
  Columns3 lastRotations;
  std::optional<ResultCheck> checkOfResults;
};

Deformer::Deformer(Model model, const DeformOptions& options, DeformerMode mode)
    : Deformer(std::make_shared<const Model>(std::move(model)), options, mode)
{
}

Deformer::Deformer(std::shared_ptr<const Model> model, const DeformOptions& options, DeformerMode mode)
    : state_(std::make_unique<State>(std::move(model), options, mode))
{
}

Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;
Deformer::~Deformer() = default;

const Model& Deformer::model() const noexcept
{
  return *state_->model;
}

DeformResult Deformer::deform(const ConstraintList& constraints, const std::string& source, Progress& progress)
{
  return state_->deform(constraints, source, false, progress);
}

DeformResult Deformer::deformFrame(const ConstraintList& constraints, const std::string& source, Progress& progress)
{
  return state_->deform(constraints, source, true, progress);
}

DeformResult Deformer::deform(Progress& progress)
{
  return deform(state_->constraints, "constraints", progress);
}

Report Deformer::checked(const DeformResult& result)
{
  Report report = result.report;
  if (report.solve.status == SolveStatus::Failed) return report;
  CheckedResult checked = state_->check().ofFrame(result.positions, result.details->system);
  report.result = std::move(checked.verdict);
  std::ranges::move(checked.findings, std::back_inserter(report.mesh.findings));
  return report;
}

Report Deformer::examined(const DeformResult& result, Progress& progress)
{
  progress.step("looking at the result");
  Report report = checked(result);
  if (report.solve.status == SolveStatus::Failed) return report;
  std::ranges::move(state_->check().addRest(report.result, result.positions, result.details->system,
                                            report.solve.rotations, progress),
                    std::back_inserter(report.mesh.findings));
  return report;
}

void Deformer::setConstraints(ConstraintList constraints)
{
  state_->constraints = std::move(constraints);
}

Constraint& Deformer::constraint(std::string_view name)
{
  std::vector<Constraint>& constraints = state_->constraints.constraints;
  const auto found = std::ranges::find(constraints, name, &Constraint::name);
  if (found == constraints.end())
    throw InputError({"constraints", 0, {}}, fmt::format("there is no constraint \"{}\"", name));
  return *found;
}

void Deformer::setTarget(std::string_view name, const Vector3& place)
{
  auto* point = std::get_if<PointConstraint>(&constraint(name).what);
  if (point == nullptr)
    throw InputError({"constraints", 0, std::string(name)},
                     "it is no point, so it has no target; give the name of a point");
  point->to = Target{place};
}

}  // namespace holdfast
