#include "bench/paper/rotation_methods.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "bench/measure.h"

namespace holdfast::paper {
namespace {

RotationOutcome outcomeOf(const SurveyTask& task, RotationSource source, HandleRotation handle, double change)
{
  const Model model = makeModel({task.rest, Polygons(task.triangles)});
  const ConstraintList list = constraintsOf(task, handle);
  DeformOptions options;
  options.rotations.source = source;
  options.rotations.change = change;
  DeformResult result;
  const double seconds = bench::secondsOf([&] { result = deform(model, list, task.name, options); });
  const SolveReport& report = result.report.solve;
  if (report.status != SolveStatus::Ok) throw std::runtime_error(task.name + ": " + report.message);
  if (report.iterations && !report.iterations->isConverged)
    throw std::runtime_error(
        fmt::format("{}: rotations are not found after {} iterations", task.name, report.iterations->count));
  RotationOutcome outcome = measured(task, result.positions);
  outcome.iterations = report.iterations ? report.iterations->count : 0;
  outcome.seconds = seconds;
  return outcome;
}

RotationMethod ownMethod(std::string name, RotationSource source, HandleRotation handle)
{
  return {std::move(name), [=](const Motion& motion, double change) {
            std::vector<RotationOutcome> outcomes;
            for (const SurveyTask& task : motion) outcomes.push_back(outcomeOf(task, source, handle, change));
            return outcomes;
          }};
}

}  // namespace

RotationOutcome measured(const SurveyTask& task, const Positions& deformed)
{
  RotationOutcome outcome;
  outcome.edges = edgeError(task, deformed);
  outcome.volume = volumeError(task, deformed);
  outcome.dihedral = dihedralError(task, deformed);
  outcome.residual = residual(task, deformed);
  return outcome;
}

std::vector<RotationMethod> ownMethods()
{
  return {ownMethod("none", RotationSource::Given, HandleRotation::None),
          ownMethod("given", RotationSource::Given, HandleRotation::Stated),
          ownMethod("found", RotationSource::Found, HandleRotation::Stated),
          ownMethod("found-smooth", RotationSource::FoundSmooth, HandleRotation::Stated)};
}

std::vector<RotationMethod> allRotationMethods()
{
  std::vector<RotationMethod> methods = ownMethods();
  for (RotationMethod& method : cgalMethods()) methods.push_back(std::move(method));
  return methods;
}

}  // namespace holdfast::paper
