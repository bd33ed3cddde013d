// Fig. 11: two constraints that contradict one another: the conflict, the compromise and the resolution.

#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/surface_locator.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"

namespace holdfast::paper {
namespace {

constexpr const char* kPulledPlate = "data/plate_unsymmetric.off";
const Vector3 kMiddle(50, 50, 0);

/// The border stays, and the point in the middle is to be at two heights, 10 and 30.
ConstraintList twoHeights()
{
  const InBox inside{{0.5, 0.5, -1}, {99.5, 99.5, 1}};
  const Selection border{NotIn{std::make_shared<Selection>(Selection{inside})}};
  return {"mm",
          {{"border", true, FixedConstraint{border}},
           {"low", true, PointConstraint{AtNear{kMiddle}, Target{{50, 50, 10}}}},
           {"high", true, PointConstraint{AtNear{kMiddle}, Target{{50, 50, 30}}}}}};
}

double heightOfMiddle(const Model& plate, const Positions& shape)
{
  return positionOf(plate.locator().closestTo(kMiddle).point, shape).z();
}

struct Step {
  std::string name;
  std::string file;
  DeformOptions options;
  std::vector<std::string> arguments;
};

}  // namespace

Section conflictingPoints(const Workbench& bench)
{
  const Model plate = makeModel(readMesh(kPulledPlate).mesh, kPulledPlate);
  ConstraintList list = twoHeights();
  const std::string both = bench.write("figure_11.constraints.json", list);
  const BatchRun conflict = bench.deform("figure_11_conflict", kPulledPlate, both);
  const nlohmann::json& clash = conflict.constraint("high").at("clashes").at(0);
  const std::string disabled = clash.at("repair").at("disable").get<std::string>();
  for (Constraint& constraint : list.constraints) constraint.isEnabled = constraint.name != disabled;
  const std::string resolved = bench.write("figure_11_resolved.constraints.json", list);
  const SolverOptions soft{.kind = SolverKind::Soft, .softWeight = 1e6};
  const std::vector<Step> steps{{"conflict", both, {}, {}},
                                {"compromise", both, {.solver = soft}, {"--solver", "soft", "--soft-weight", "1e6"}},
                                {"resolution", resolved, {}, {}}};
  Section section;
  section.paper = "constraints that conflict: soft constraints compromise, the conflict is found, and removed.";
  section.method = "the plate with its border fixed, and one point that is to be at the heights 10 and 30.";
  section.tables = {{{"", "exit code", "status", "height of the point"}, {}}};
  std::vector<Deformed> shown;
  for (const Step& step : steps) {
    const BatchRun run = bench.deform("figure_11_" + step.name, kPulledPlate, step.file, step.arguments);
    section.commands.push_back(run.command);
    section.numbers[step.name + " height"] = heightOfMiddle(plate, run.mesh.positions);
    section.numbers[step.name + " exit code"] = run.exitCode;
    section.tables[0].rows.push_back({step.name, fmt::format("{}", run.exitCode),
                                      run.solve().at("status").get<std::string>(),
                                      fmt::format("{:.6f}", section.numbers[step.name + " height"])});
    shown.push_back(deformed(kPulledPlate, step.file, step.options));
  }
  section.numbers["gap"] = clash.at("gap").at(2).get<double>();
  section.result = fmt::format(
      "Hard constraints leave out \"high\", which comes later, and report the gap of {:g} and that \"{}\" is to be "
      "disabled. Soft constraints put the point between the two. With \"{}\" disabled everything is met.",
      section.numbers["gap"], disabled, disabled);
  std::vector<Panel> panels;
  const std::vector<std::string> labels{"(a) conflict: high left out", "(b) compromise", "(c) resolution"};
  for (std::size_t k = 0; k < shown.size(); ++k) panels.push_back({labels[k], &shown[k], ColorBy::DisplacementZ});
  for (Panel& panel : panels) panel.range = FixedRange{0, 30};
  drawPanels(bench.picture("figure_11.png"), panels,
             {.back = {0, -3, 1}, .up = {0, 0, 1}, .panel = {360, 190}, .columns = 3});
  section.pictures = {{"figure_11.png", "A conflict, its compromise by soft constraints, and its resolution", true}};
  return section;
}

}  // namespace holdfast::paper
