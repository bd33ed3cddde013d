// Rotation methods side by side: bends and twists of a bar from 30 to 360 degrees, and tasks like those of the survey.

#include "bench/paper/rotation_methods.h"

#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "bench/measure.h"
#include "bench/paper/charts.h"
#include "bench/paper/experiments.h"

namespace holdfast::paper {
namespace {

/// A motion by any angle, and a curve a method.
struct Sweep {
  const char* name;
  SurveyTask (*task)(double degrees);
};
constexpr Sweep kBending{"bend", bentBar};
constexpr Sweep kTwisting{"twist", twistedBar};

struct Measure {
  const char* name;
  const char* label;
  Scale scale;
  double (*of)(const RotationOutcome&);
};

const std::vector<Measure>& measures()
{
  static const std::vector<Measure> kAll{
      {"edges", "edges, RMS of relative change", Scale::Log, [](const RotationOutcome& o) { return o.edges; }},
      {"volume", "volume, relative change", Scale::Log, [](const RotationOutcome& o) { return std::abs(o.volume); }},
      {"dihedral", "angles between normals, RMS of change, degrees", Scale::Linear,
       [](const RotationOutcome& o) { return o.dihedral.rms; }},
      {"seconds", "seconds from mesh to result", Scale::Log, [](const RotationOutcome& o) { return o.seconds; }}};
  return kAll;
}

/// By angle, then method.
using SweepOutcomes = std::map<double, std::vector<RotationOutcome>>;

SweepOutcomes outcomesOf(const Sweep& sweep, double step)
{
  SweepOutcomes outcomes;
  for (double degrees = step; degrees <= 360; degrees += step)
    for (const RotationMethod& method : rotationMethods())
      outcomes[degrees].push_back(outcomeOf(sweep.task(degrees), method));
  return outcomes;
}

std::vector<Curve> curvesOf(const SweepOutcomes& outcomes, const Measure& measure)
{
  std::vector<Curve> curves;
  for (std::size_t m = 0; m < rotationMethods().size(); ++m) {
    curves.push_back({rotationMethods()[m].name, {}});
    for (const auto& [degrees, row] : outcomes) curves.back().points.emplace_back(degrees, measure.of(row[m]));
  }
  return curves;
}

/// Largest of a measure of a method over all angles, by name.
void noteNumbers(Section& section, const Sweep& sweep, const SweepOutcomes& outcomes)
{
  for (std::size_t m = 0; m < rotationMethods().size(); ++m) {
    double residual = 0;
    for (const auto& [degrees, row] : outcomes) {
      const std::string name = fmt::format("{} {} {}", sweep.name, degrees, rotationMethods()[m].name);
      for (const Measure& measure : measures())
        section.numbers[fmt::format("{} {}", name, measure.name)] = measure.of(row[m]);
      residual = std::max(residual, row[m].residual);
    }
    section.numbers[fmt::format("{} {} residual", sweep.name, rotationMethods()[m].name)] = residual;
  }
}

std::string cellOf(const RotationOutcome& outcome)
{
  return fmt::format("{:.3f}, {:.2f}, {:.1f}", outcome.edges, outcome.volume, outcome.dihedral.rms);
}

void addSweep(Section& section, const Workbench& bench, const Sweep& sweep, double step)
{
  const SweepOutcomes outcomes = outcomesOf(sweep, step);
  noteNumbers(section, sweep, outcomes);
  Table table{{fmt::format("{}, degrees", sweep.name)}, {}};
  for (const RotationMethod& method : rotationMethods()) table.columns.emplace_back(method.name);
  for (const auto& [degrees, row] : outcomes) {
    table.rows.push_back({fmt::format("{:g}", degrees)});
    for (const RotationOutcome& outcome : row) table.rows.back().push_back(cellOf(outcome));
  }
  section.tables.push_back(std::move(table));
  for (const Measure& measure : measures()) {
    const std::string file = fmt::format("rotations_{}_{}.svg", sweep.name, measure.name);
    writeFile(bench.picture(file), curveChart(fmt::format("Bar, {}", sweep.name), {"degrees", Scale::Linear},
                                              {measure.label, measure.scale}, curvesOf(outcomes, measure)));
    section.pictures.push_back({file, fmt::format("{} of a bar: {}", sweep.name, measure.label), true});
  }
}

Section sweeps(const Workbench& bench, double step)
{
  Section section;
  section.paper =
      "rotations that handles give, carried into the surface by the rotation field, (25) to (29). It has none that are "
      "found.";
  section.method = fmt::format(
      "a bar of 10 x 10 x 90 units, one end held, the other one bent along an arc that keeps the length of its middle "
      "line, or twisted, in steps of {:g} degrees. A cell has the root of the mean square of relative changes of "
      "edges, "
      "the relative change of the volume, and the root of the mean square of changes of angles between neighbouring "
      "normals, in degrees.",
      step);
  addSweep(section, bench, kBending, step);
  addSweep(section, bench, kTwisting, step);
  const auto at = [&](const char* name) { return section.numbers.at(name); };
  section.result = fmt::format(
      "Without rotations a bend by 180 degrees changes edges by {:.2f}, with given ones by {:.2f}, with found ones by "
      "{:.2f}. A full twist takes {:.0f} % of the volume with given rotations and {:.0f} % with found ones.",
      at("bend 180 none edges"), at("bend 180 given edges"), at("bend 180 found edges"),
      100 * at("twist 360 given volume"), 100 * at("twist 360 found volume"));
  return section;
}

}  // namespace

const std::vector<RotationMethod>& rotationMethods()
{
  static const std::vector<RotationMethod> kAll{
      {"none", RotationSource::Given, HandleRotation::None},
      {"given", RotationSource::Given, HandleRotation::Stated},
      {"found", RotationSource::Found, HandleRotation::Stated},
      {"found-smooth", RotationSource::FoundSmooth, HandleRotation::Stated},
  };
  return kAll;
}

RotationOutcome outcomeOf(const SurveyTask& task, const RotationMethod& method, double change)
{
  const Model model = makeModel({task.rest, Polygons(task.triangles)});
  const ConstraintList list = constraintsOf(task, method.handle);
  DeformOptions options;
  options.rotations.source = method.source;
  options.rotations.change = change;
  DeformResult result;
  const double seconds = bench::secondsOf([&] { result = deform(model, list, task.name, options); });
  const SolveReport& report = result.report.solve;
  if (report.status != SolveStatus::Ok) throw std::runtime_error(task.name + ": " + report.message);
  if (report.iterations && !report.iterations->isConverged)
    throw std::runtime_error(
        fmt::format("{}: rotations are not found after {} iterations", task.name, report.iterations->count));
  const Positions& p = result.positions;
  return {edgeError(task, p),
          volumeError(task, p),
          dihedralError(task, p),
          residual(task, p),
          report.iterations ? report.iterations->count : 0,
          seconds};
}

Section bendsAndTwists(const Workbench& bench)
{
  return sweeps(bench, 30);
}

Section surveyTasks(const Workbench& /*bench*/)
{
  Section section;
  section.paper = "nothing of the kind; the survey of Botsch and Sorkine (2008) compares linear methods on such tasks.";
  section.method =
      "tasks like those of the survey on meshes of our own. A cell has the root of the mean square of relative changes "
      "of edges, the largest change of the angle between neighbouring normals in degrees, and seconds.";
  Table table{{"task"}, {}};
  for (const RotationMethod& method : rotationMethods()) table.columns.emplace_back(method.name);
  double residual = 0;
  for (const SurveyTask& task : {bentBar(), bentCactus(), twistedCylinder(), liftedPlane()}) {
    table.rows.push_back({task.name});
    for (const RotationMethod& method : rotationMethods()) {
      const RotationOutcome outcome = outcomeOf(task, method);
      table.rows.back().push_back(
          fmt::format("{:.4f}, {:.1f}, {:.2f}", outcome.edges, outcome.dihedral.largest, outcome.seconds));
      section.numbers[fmt::format("{}: {} edges", task.name, method.name)] = outcome.edges;
      section.numbers[fmt::format("{}: {} jump", task.name, method.name)] = outcome.dihedral.largest;
      residual = std::max(residual, outcome.residual);
    }
  }
  section.numbers["residual"] = residual;
  section.tables = {table};
  section.result = fmt::format(
      "Found rotations keep edges best in all four tasks. Smooth ones keep them better than given ones, with smaller "
      "jumps "
      "than those found over edges. Constraints are missed by {:.0e} of the diagonal at most.",
      residual);
  return section;
}

}  // namespace holdfast::paper
