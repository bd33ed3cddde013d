// Fig. 2: a plate that is fine on one side and coarse on the other, against the same plate with a symmetric mesh.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"
#include "bench/paper/shape_measures.h"

namespace holdfast::paper {
namespace {

constexpr const char* kFineAndCoarse = "data/plate_unsymmetric.off";
constexpr double kRise = 25;

/// The plate of 100 x 100 as `cells` x `cells` squares, each cut into four triangles by its middle: as symmetric as a
/// square.
Mesh symmetricPlate(Index cells)
{
  const double side = 100.0 / static_cast<double>(cells);
  const Index corners = (cells + 1) * (cells + 1);
  Mesh mesh{Positions(corners + cells * cells, 3), {}};
  for (Index y = 0; y <= cells; ++y)
    for (Index x = 0; x <= cells; ++x)
      mesh.positions.row(y * (cells + 1) + x) << side * static_cast<double>(x), side * static_cast<double>(y), 0;
  for (Index y = 0; y < cells; ++y)
    for (Index x = 0; x < cells; ++x) {
      const Index middle = corners + y * cells + x;
      const Index low = y * (cells + 1) + x;
      const Index high = low + cells + 1;
      mesh.positions.row(middle) << side * (static_cast<double>(x) + 0.5), side * (static_cast<double>(y) + 0.5), 0;
      mesh.faces.add({low, low + 1, middle});
      mesh.faces.add({low + 1, high + 1, middle});
      mesh.faces.add({high + 1, high, middle});
      mesh.faces.add({high, low, middle});
    }
  return mesh;
}

/// The border stays; nine places on a circle and in its middle rise. They are the same places on any mesh.
ConstraintList constraints()
{
  constexpr int kCorners = 8;
  const InBox inside{{0.5, 0.5, -1}, {99.5, 99.5, 1}};
  const Selection border{NotIn{std::make_shared<Selection>(Selection{inside})}};
  ConstraintList list{"mm", {{"border", true, FixedConstraint{border}}}};
  const auto raise = [&](const std::string& name, double x, double y) {
    list.constraints.push_back({name, true, PointConstraint{AtNear{{x, y, 0}}, Move{{0, 0, kRise}}}});
  };
  raise("middle", 50, 50);
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    raise(fmt::format("circle {}", k + 1), 50 + 8 * std::cos(angle), 50 + 8 * std::sin(angle));
  }
  return list;
}

void addPicture(Section& section, const Workbench& bench, const std::string& symmetric, const std::string& list)
{
  const Deformed uniform = deformed(kFineAndCoarse, list, {.weights = Weights::Uniform, .solver = {}});
  const Deformed cotangent = deformed(kFineAndCoarse, list);
  const Deformed even = deformed(symmetric, list);
  const auto panel = [](const char* label, const Deformed& shown) {
    return Panel{label, &shown, ColorBy::None, MeshEdges::All, RestGhost::Hidden, {}};
  };
  drawPanels(bench.picture("figure_02.png"),
             {panel("(a) uniform", uniform), panel("(b) cotangent", cotangent), panel("(c) symmetric mesh", even)},
             {.back = {0, -3, 1}, .up = {0, 0, 1}, .panel = {360, 190}, .columns = 3});
  section.pictures = {
      {"figure_02.png", "The plate with uniform and with cotangent weights, and a symmetric one", true}};
}

}  // namespace

Section unsymmetricSubdivision(const Workbench& bench)
{
  const std::string symmetric = bench.write("plate_symmetric.obj", symmetricPlate(48));
  const std::string list = bench.write("figure_02.constraints.json", constraints());
  const Model plate = makeModel(readMesh(kFineAndCoarse).mesh, kFineAndCoarse);
  const Model even = makeModel(readMesh(symmetric).mesh, symmetric);
  Section section;
  section.paper =
      "a mesh that is subdivided unsymmetrically, deformed symmetrically: with uniform weights the shape follows the "
      "mesh, with cotangent weights it is symmetric.";
  section.method = fmt::format(
      "the plate of `data/`, fine on one side, with its border fixed and nine points about its middle raised by {:g}. "
      "Each vertex is compared with the same point of a plate with a symmetric mesh of {} vertices.",
      kRise, even.mesh.vertexCount());
  const BatchRun truth = bench.deform("figure_02_symmetric", symmetric, list);
  Table table{{"weights", "distance, RMS", "largest", "of the rise"}, {}};
  for (const std::string weights : {"uniform", "cotangent"}) {
    const BatchRun run = bench.deform("figure_02_" + weights, kFineAndCoarse, list, {"--weights", weights});
    const Spread distance = distanceBetween(plate, run.mesh.positions, allVertices(plate), even, truth.mesh.positions);
    section.commands.push_back(run.command);
    section.numbers[weights + " rms"] = distance.rms;
    section.numbers[weights + " largest"] = distance.largest;
    table.rows.push_back({weights, fmt::format("{:.3f}", distance.rms), fmt::format("{:.3f}", distance.largest),
                          fmt::format("{:.1f} %", 100 * distance.largest / kRise)});
  }
  section.commands.push_back(truth.command);
  section.tables = {table};
  section.result = fmt::format("Cotangent weights come {:.1f} times as near to the symmetric shape.",
                               section.numbers["uniform rms"] / section.numbers["cotangent rms"]);
  addPicture(section, bench, symmetric, list);
  return section;
}

}  // namespace holdfast::paper
