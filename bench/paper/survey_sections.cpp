// Rotation methods side by side on tasks like those of the survey, and on large meshes.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>

#include "bench/bumpy_mesh.h"
#include "bench/paper/experiments.h"
#include "bench/paper/rotation_methods.h"

namespace holdfast::paper {
namespace {

constexpr const char* kSurvey =
    "nothing of the kind; the survey of Botsch and Sorkine (2008) compares linear methods on such tasks.";

std::string taskCell(const RotationOutcome& outcome)
{
  return fmt::format("{:.4f}, {:.1f}, {}, {:.2f}{}", outcome.edges, outcome.dihedral.largest, outcome.iterations,
                     outcome.seconds, outcome.isConverged ? "" : " *");
}

void noteNumbers(Section& section, const std::string& name, const RotationOutcome& outcome)
{
  section.numbers[name + " edges"] = outcome.edges;
  section.numbers[name + " jump"] = outcome.dihedral.largest;
  section.numbers[name + " residual"] = outcome.residual;
}

/// Of a number of two methods, over all tasks.
struct Ratios {
  double least;
  double largest;
};

Ratios ratiosOf(const Section& section, const std::string& above, const std::string& below)
{
  std::vector<double> ratios;
  for (const auto& row : section.tables.front().rows)
    ratios.push_back(section.numbers.at(row.front() + ": " + above) / section.numbers.at(row.front() + ": " + below));
  const auto [least, largest] = std::ranges::minmax(ratios);
  return {least, largest};
}

double largestResidual(const Section& section)
{
  double largest = 0;
  for (const auto& [name, value] : section.numbers)
    if (name.ends_with("residual")) largest = std::max(largest, value);
  return largest;
}

struct SizedTask {
  SurveyTask (*at)(double size);  ///< the handle moved by so much
  double size;                    ///< degrees, or a length

  [[nodiscard]] SurveyTask whole() const { return at(size); }
};
constexpr std::array kTasks{SizedTask{bentBar, 135}, SizedTask{bentCactus, 70}, SizedTask{twistedCylinder, 120},
                            SizedTask{liftedPlane, 25}};

constexpr int kLedSteps = 5;

Motion inSteps(const SizedTask& task)
{
  Motion motion;
  for (int k = 1; k <= kLedSteps; ++k) motion.push_back(task.at(task.size * k / kLedSteps));
  return motion;
}

/// CGAL's methods, led to the place of the handle.
void addLedTasks(Section& section)
{
  Table table{{"task, in steps"}, {}};
  for (const RotationMethod& method : cgalMethods()) table.columns.push_back(method.name);
  for (const SizedTask& task : kTasks) {
    const std::string name = task.whole().name;
    table.rows.push_back({name});
    for (const RotationMethod& method : cgalMethods()) {
      const RotationOutcome outcome = method.run(inSteps(task), kFoundChange).back();
      table.rows.back().push_back(taskCell(outcome));
      noteNumbers(section, fmt::format("{}: {} in steps", name, method.name), outcome);
    }
  }
  section.tables.push_back(table);
}

std::string resultOfTasks(const Section& section)
{
  const Ratios atOnce = ratiosOf(section, "found edges", "ORIGINAL_ARAP edges");
  const Ratios led = ratiosOf(section, "found edges", "ORIGINAL_ARAP in steps edges");
  double jump = 0;
  for (const RotationMethod& method : cgalMethods())
    for (const char* way : {"", " in steps"})
      jump = std::max(jump, ratiosOf(section, "found-smooth jump", method.name + way + " jump").largest);
  return fmt::format(
      "Of ours, found rotations keep edges best in all four tasks. Smooth ones keep them better than given ones, "
      "with smaller jumps than those found over edges, and with jumps of at most {:.2f} times those of any method of "
      "CGAL {}. Edges by found rotations change {:.3f} to {:.3f} times as much as by ORIGINAL_ARAP in steps, whose "
      "energy is the same, and {:.3f} to {:.3f} times as much as by the same at once. On the bar that one ends in a "
      "minimum where faces are folded over (a jump by {:.0f} degrees), with shorter edges. Constraints are missed by "
      "{:.0e} of the diagonal at most.",
      jump, cgalVersion(), led.least, led.largest, atOnce.least, atOnce.largest,
      section.numbers.at("bar, bent by 135: ORIGINAL_ARAP jump"), largestResidual(section));
}

/// Ten times that of other tasks: CGAL takes minutes to it.
constexpr double kChangeOfLarge = 1e-4;

void addLargeTask(Section& section, const SurveyTask& task)
{
  Table& table = section.tables.front();
  std::vector<RotationOutcome> outcomes;
  for (const RotationMethod& method : allRotationMethods())
    if (method.name == "found" || method.name == "ORIGINAL_ARAP")
      outcomes.push_back(method.run({task}, kChangeOfLarge).front());
  const RotationOutcome& ours = outcomes.front();
  const RotationOutcome& theirs = outcomes.back();
  const double ratio = theirs.seconds / ours.seconds;
  table.rows.push_back({task.name, fmt::format("{}", task.rest.rows()),
                        fmt::format("{:.2f}, {}", ours.seconds, ours.iterations),
                        fmt::format("{:.2f}, {}", theirs.seconds, theirs.iterations), fmt::format("{:.1f}", ratio),
                        fmt::format("{:.3f}, {:.3f}", ours.edges, theirs.edges)});
  auto& least = section.numbers.try_emplace("least ratio", ratio).first->second;
  least = std::min(least, ratio);
}

}  // namespace

Section tasksBy(const std::vector<RotationMethod>& methods)
{
  Section section;
  Table table{{"task"}, {}};
  for (const RotationMethod& method : methods) table.columns.push_back(method.name);
  for (const SizedTask& task : kTasks) {
    table.rows.push_back({task.whole().name});
    for (const RotationMethod& method : methods) {
      const RotationOutcome outcome = method.run({task.whole()}, kFoundChange).front();
      table.rows.back().push_back(taskCell(outcome));
      noteNumbers(section, task.whole().name + ": " + method.name, outcome);
    }
  }
  section.tables = {table};
  return section;
}

Section surveyTasks(const Workbench& /*bench*/)
{
  Section section = tasksBy(allRotationMethods());
  addLedTasks(section);
  section.paper = kSurvey;
  section.method = fmt::format(
      "tasks like those of the survey on meshes of our own. A cell has the root of the mean square of relative "
      "changes of edges, the largest change of the angle between neighbouring normals in degrees, iterations, and "
      "seconds. All methods that iterate end where no vertex moves by more than {:g} of the diagonal (* where they "
      "do not). In the first table the handle goes to its place at once. What CGAL finds depends on the way there, as "
      "it starts from the shape that it has; so in the second table it follows the handle in {} equal steps, as in a "
      "drag. Ours start from the rotations that the handle states, and take no steps.",
      kFoundChange, kLedSteps);
  section.result = resultOfTasks(section);
  return section;
}

Section surveyScans(const Workbench& bench)
{
  Section section;
  section.paper = kSurvey;
  section.method = fmt::format(
      "one end of a large mesh is held, the other one bent by 60 degrees, by rotations found over edges and by CGAL "
      "{}, which solves on one thread. Both end where no vertex moves by more than {:g} of the diagonal. Cells have "
      "seconds from mesh to result and iterations, or edges: the root of the mean square of relative changes, ours "
      "and CGAL's.",
      cgalVersion(), kChangeOfLarge);
  section.tables = {{{"mesh", "vertices", "found", "ORIGINAL_ARAP", "ratio of seconds", "edges"}, {}}};
  addLargeTask(section, bentAtItsEnd("bunny.ply", readMesh(bench.model("bunny.ply")).mesh));
  addLargeTask(section, bentAtItsEnd("generated, 173k", bench::bumpyMesh(173000)));
  section.result = fmt::format("Found rotations take less than 1 / {:.1f} of the time.",
                               std::floor(10 * section.numbers.at("least ratio")) / 10);
  return section;
}

}  // namespace holdfast::paper
