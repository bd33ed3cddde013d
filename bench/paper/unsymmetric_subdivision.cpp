// Fig. 2: a plate that is fine on one side and coarse on the other, against the same plate with a symmetric mesh.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/surface_locator.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"

namespace holdfast::paper {
namespace {

constexpr const char* kPlate = "data/plate_unsymmetric.off";
constexpr const char* kConstraints = "data/plate_unsymmetric.constraints.json";
constexpr double kRise = 25;  // of the disc in the middle

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

struct Distance {
  double rms = 0;
  double largest = 0;
};

/// From each vertex of `shape`, whose rest is `rest`, to where the same point of `other` went.
Distance distanceBetween(const Positions& rest, const Positions& shape, const Model& other, const Positions& otherShape)
{
  Distance distance;
  for (Index v = 0; v < rest.rows(); ++v) {
    const SurfacePoint point = other.locator().closestTo(rest.row(v)).point;
    const double away = (positionOf(point, otherShape) - shape.row(v).transpose()).norm();
    distance.rms += away * away / static_cast<double>(rest.rows());
    distance.largest = std::max(distance.largest, away);
  }
  distance.rms = std::sqrt(distance.rms);
  return distance;
}

void addPicture(Section& section, const Workbench& bench, const std::string& symmetric)
{
  const Deformed uniform = deformed(kPlate, kConstraints, {.weights = Weights::Uniform, .solver = {}});
  const Deformed cotangent = deformed(kPlate, kConstraints);
  const Deformed even = deformed(symmetric, kConstraints);
  const auto panel = [](const char* label, const Deformed& shown) {
    return Panel{label, &shown, ColorBy::None, MeshEdges::All, RestGhost::Hidden, {}};
  };
  drawPanels(bench.picture("figure_02.png"),
             {panel("(a) uniform", uniform), panel("(b) cotangent", cotangent), panel("(c) symmetric mesh", even)},
             {.back = {0, -3, 1}, .up = {0, 0, 1}, .panel = {400, 260}, .columns = 3});
  section.pictures = {
      {"figure_02.png", "The plate with uniform and with cotangent weights, and a symmetric one", true}};
}

}  // namespace

Section unsymmetricSubdivision(const Workbench& bench)
{
  const std::string symmetric = bench.write("plate_symmetric.obj", symmetricPlate(48));
  const Mesh rest = readMesh(kPlate).mesh;
  const Model even = makeModel(readMesh(symmetric).mesh, symmetric);
  Section section;
  section.paper =
      "a mesh that is subdivided unsymmetrically, deformed symmetrically: with uniform weights the shape follows the "
      "mesh, with cotangent weights it is symmetric.";
  section.method = fmt::format(
      "the plate of `data/`, fine on one side, with its border fixed and a disc in its middle raised by {:g}. Each "
      "vertex is compared with the same point of a plate with a symmetric mesh of {} vertices.",
      kRise, even.mesh.vertexCount());
  const BatchRun truth = bench.deform("figure_02_symmetric", symmetric, kConstraints);
  Table table{{"weights", "distance, RMS", "largest", "of the rise"}, {}};
  for (const std::string weights : {"uniform", "cotangent"}) {
    const BatchRun run = bench.deform("figure_02_" + weights, kPlate, kConstraints, {"--weights", weights});
    const Distance distance = distanceBetween(rest.positions, run.mesh.positions, even, truth.mesh.positions);
    section.commands.push_back(run.command);
    section.numbers[weights + " rms"] = distance.rms;
    section.numbers[weights + " largest"] = distance.largest;
    table.rows.push_back({weights, fmt::format("{:.3f}", distance.rms), fmt::format("{:.3f}", distance.largest),
                          fmt::format("{:.1f} %", 100 * distance.largest / kRise)});
  }
  section.commands.push_back(truth.command);
  section.tables = {table};
  section.result = fmt::format("Cotangent weights come {:.0f} times as near to the symmetric shape.",
                               section.numbers["uniform rms"] / section.numbers["cotangent rms"]);
  addPicture(section, bench, symmetric);
  return section;
}

}  // namespace holdfast::paper
