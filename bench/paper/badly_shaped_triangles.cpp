// Fig. 3 and 9: a shaft as programs for CAD tessellate it, with triangles down to half a degree.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/operators/cotangents.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"
#include "bench/paper/shape_measures.h"

namespace holdfast::paper {
namespace {

constexpr const char* kShaft = "data/shaft_slivers.off";
constexpr const char* kBend = "data/shaft_slivers.constraints.json";
// mm: what is below and above is held.
constexpr double kFlange = 8;
constexpr double kEnd = 97;

/// The profile of data/sources/shaft_slivers.geo above the flange, with a rim of the flange: radius and height.
std::vector<Eigen::Vector2d> profileOfShaft()
{
  return {{14, 8}, {10, 8}, {10, 50}, {9.9, 50.1}, {9.9, 52}, {6, 52}, {6, 98}, {5.9, 98.1}, {4, 98.1}};
}

/// The profile with a point at least every `step`.
std::vector<Eigen::Vector2d> resampled(const std::vector<Eigen::Vector2d>& profile, double step)
{
  std::vector<Eigen::Vector2d> points{profile.front()};
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const int parts = std::max(1, static_cast<int>(std::round((profile[k] - profile[k - 1]).norm() / step)));
    for (int part = 1; part <= parts; ++part)
      points.emplace_back(profile[k - 1] + (profile[k] - profile[k - 1]) * part / parts);
  }
  return points;
}

/// The profile turned about the z axis, in `around` parts, every other ring by half a part: triangles of even shape.
Mesh revolved(const std::vector<Eigen::Vector2d>& profile, Index around)
{
  const Index rings = static_cast<Index>(profile.size());
  Mesh mesh{Positions(rings * around, 3), {}};
  for (Index ring = 0; ring < rings; ++ring)
    for (Index k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.5 * static_cast<double>(ring % 2)) /
                           static_cast<double>(around);
      mesh.positions.row(ring * around + k) << profile[ring].x() * std::cos(angle), profile[ring].x() * std::sin(angle),
          profile[ring].y();
    }
  for (Index ring = 0; ring + 1 < rings; ++ring)
    for (Index k = 0; k < around; ++k) {
      const Index low = ring * around;
      const Index high = low + around;
      const Index next = (k + 1) % around;
      const Index across = ring % 2 == 0 ? k : next;  // the vertex above the side from k to the next
      mesh.faces.add({low + k, low + next, high + across});
      mesh.faces.add({high + across, high + (ring % 2 == 0 ? next : k), low + (ring % 2 == 0 ? next : k)});
    }
  return mesh;
}

/// Degrees.
std::vector<double> smallestAngles(const Model& model)
{
  std::vector<double> angles;
  for (const Triangle& triangle : model.triangulation.triangles) {
    double smallest = std::numbers::pi;
    for (const double cotangent : cornerCotangents(model.mesh.positions, triangle))
      smallest = std::min(smallest, std::atan2(1, cotangent));
    angles.push_back(smallest * 180 / std::numbers::pi);
  }
  return angles;
}

/// The vertices between the flange and the end, which both are held.
std::vector<Index> freeVertices(const Model& shaft)
{
  const Selection above{InHalfSpace{{0, 0, kFlange + 1e-6}, {0, 0, 1}}};
  const Selection below{InHalfSpace{{0, 0, kEnd - 1e-6}, {0, 0, -1}}};
  return verticesOf(shaft, {AllOf{{above, below}}});
}

Panel shaftPanel(const char* label, const Deformed& shown)
{
  return {label, &shown, ColorBy::None, MeshEdges::All, RestGhost::Hidden, {}};
}

std::string meshLine(const Model& shaft)
{
  std::vector<double> angles = smallestAngles(shaft);
  std::ranges::sort(angles);
  const auto below = std::ranges::lower_bound(angles, 5) - angles.begin();
  return fmt::format(
      "a stepped shaft of {} vertices, tessellated by a script for Gmsh (`data/sources`), with angles "
      "down to {:.2f} degrees, {:.0f} % of its triangles below 5. The flange stays, the end is bent by "
      "60 degrees.",
      shaft.mesh.vertexCount(), angles.front(),
      100.0 * static_cast<double>(below) / static_cast<double>(angles.size()));
}

}  // namespace

Section badlyShapedTriangles(const Workbench& bench)
{
  const Model shaft = makeModel(readMesh(kShaft).mesh, kShaft);
  const std::string evenPath = bench.write("shaft_even.obj", revolved(resampled(profileOfShaft(), 0.5), 96));
  const Model even = makeModel(readMesh(evenPath).mesh, evenPath);
  Section section;
  section.paper = "badly shaped triangles of a CAD model, deformed with uniform and with cotangent weights.";
  section.method = meshLine(shaft) + fmt::format(
                                         " Each vertex of the shaft is compared with the same point of a shaft "
                                         "of {} vertices with triangles of even shape.",
                                         even.mesh.vertexCount());
  const BatchRun truth = bench.deform("figure_03_even", evenPath, kBend);
  Table table{{"weights", "distance, RMS, mm", "largest, mm"}, {}};
  for (const std::string weights : {"uniform", "cotangent-paper", "cotangent"}) {
    const BatchRun run = bench.deform("figure_03_" + weights, kShaft, kBend, {"--weights", weights});
    const Spread distance = distanceBetween(shaft, run.mesh.positions, freeVertices(shaft), even, truth.mesh.positions);
    section.commands.push_back(run.command);
    section.numbers[weights] = distance.rms;
    table.rows.push_back({weights, fmt::format("{:.3f}", distance.rms), fmt::format("{:.3f}", distance.largest)});
  }
  section.commands.push_back(truth.command);
  section.tables = {table};
  section.result = fmt::format(
      "With uniform weights the shaft is pressed in at its step, where triangles are small on one side; cotangent "
      "weights "
      "come {:.1f} times as near to the even mesh.",
      section.numbers["uniform"] / section.numbers["cotangent"]);
  const Deformed uniform = deformed(kShaft, kBend, {.weights = Weights::Uniform, .solver = {}});
  const Deformed cotangent = deformed(kShaft, kBend);
  const Deformed reference = deformed(evenPath, kBend);
  Panel last = shaftPanel("(c) even mesh", reference);
  last.edges = MeshEdges::Sharp;  // its own are too dense for a picture
  drawPanels(bench.picture("figure_03.png"),
             {shaftPanel("(a) uniform", uniform), shaftPanel("(b) cotangent", cotangent), last},
             {.back = {0.35, -2, 0.5}, .up = {0, 0, 1}, .panel = {400, 400}, .columns = 3});
  section.pictures = {
      {"figure_03.png", "The bent shaft: uniform and cotangent weights, and triangles of even shape", true}};
  return section;
}

Section solversOnBadTriangles(const Workbench& bench)
{
  const Model shaft = makeModel(readMesh(kShaft).mesh, kShaft);
  Section section;
  section.paper = "badly shaped triangles, where soft constraints and cotangent weights do not go together.";
  section.method = meshLine(shaft) +
                   " Every solver with every weighting, as the product solves: Table 1 has plain "
                   "factorisations.";
  Table table{{"weights", "solver", "outcome", "largest residual / diagonal", "accuracy"}, {}};
  for (const std::string weights : {"uniform", "cotangent", "cotangent-paper"})
    for (const std::string solver : {"soft", "lagrange", "hard"}) {
      const BatchRun run = bench.deform("figure_09", kShaft, kBend, {"--weights", weights, "--solver", solver});
      const double residual = run.solve().at("max_residual_relative").get<double>();
      section.commands.push_back(run.command);
      section.numbers[weights + ' ' + solver] = residual;
      table.rows.push_back({weights, solver, run.solve().at("status").get<std::string>(),
                            fmt::format("{:.1e}", residual),
                            fmt::format("{:.1e}", run.solve().at("accuracy").get<double>())});
    }
  section.tables = {table};
  section.result = fmt::format(
      "Rows of L as printed in (10), cotangent weights, grow with the inverse of an area, so that a soft constraint of "
      "weight 5 means nothing beside them: it is missed by {:.0f} % of the diagonal. Hard constraints are met exactly "
      "with any weights.",
      100 * section.numbers["cotangent-paper soft"]);
  const Deformed soft =
      deformed(kShaft, kBend, {.weights = Weights::CotangentPaper, .solver = {.kind = SolverKind::Soft}});
  const Deformed hard = deformed(kShaft, kBend, {.weights = Weights::CotangentPaper, .solver = {}});
  drawPanels(bench.picture("figure_09.png"), {shaftPanel("(a) soft, weight 5", soft), shaftPanel("(b) hard", hard)},
             {.back = {0.35, -2, 0.5}, .up = {0, 0, 1}, .panel = {400, 400}, .columns = 2});
  section.pictures = {{"figure_09.png", "Cotangent weights as printed with soft and with hard constraints", true}};
  return section;
}

}  // namespace holdfast::paper
