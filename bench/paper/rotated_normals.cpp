// Fig. 4 and 5: a plate with bumps, bent with its detail rotated, and with detail that keeps its direction.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/mesh/vertex_normals.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"
#include "bench/paper/shape_measures.h"

namespace holdfast::paper {
namespace {

constexpr double kLength = 100;
constexpr double kWidth = 40;
constexpr double kHeld = 10;  // at either end

/// A sheet in squares of 1 with rows of bumps between its ends.
Mesh bumpySheet()
{
  const Index across = static_cast<Index>(kWidth) + 1;
  const Index along = static_cast<Index>(kLength) + 1;
  Mesh mesh{Positions(across * along, 3), {}};
  for (Index i = 0; i < along; ++i)
    for (Index j = 0; j < across; ++j) {
      const double x = static_cast<double>(i);
      const double y = static_cast<double>(j);
      const bool isHeld = x <= kHeld || x >= kLength - kHeld;
      const double wave = std::sin(std::numbers::pi * (x - kHeld) / 10) * std::sin(std::numbers::pi * y / 10);
      mesh.positions.row(i * across + j) << x, y, isHeld ? 0 : 4 * wave * wave;
    }
  for (Index i = 0; i + 1 < along; ++i)
    for (Index j = 0; j + 1 < across; ++j) {
      const Index v = i * across + j;
      mesh.faces.add({v, v + across, v + across + 1});
      mesh.faces.add({v, v + across + 1, v + 1});
    }
  return mesh;
}

/// One end stays, the other goes a quarter of a circle about y, down. Its vertices hand on `degrees`.
ConstraintList bent(const Model& sheet, double degrees)
{
  const double radius = (kLength - 2 * kHeld) / (std::numbers::pi / 2);
  const std::vector<Index> end = verticesOf(sheet, {InHalfSpace{{kLength - kHeld, 0, 0}, {1, 0, 0}}});
  const Vector3 center(kHeld, 0, -radius);
  const Vector3 moved(kHeld + radius, 0, -radius);  // where the start of the held end goes
  HandleConstraint handle{{VertexIds{end}},
                          AxisRotation{Vector3::UnitY(), 90, Vector3(kLength - kHeld, 0, 0)},
                          moved - Vector3(kLength - kHeld, 0, 0),
                          std::vector<AxisAngle>(end.size(), AxisAngle{Vector3::UnitY(), degrees})};
  return {"mm", {{"start", true, FixedConstraint{{InHalfSpace{{kHeld, 0, 0}, {-1, 0, 0}}}}}, {"end", true, handle}}};
}

Positions normalsOf(const Mesh& mesh, const Positions& positions)
{
  return areaWeightedNormals(positions, mesh.faces, mesh.faces.corners(), positions.rows());
}

/// The normals at rest, each rotated as the field rotates the detail there.
Positions carriedNormals(const Deformed& shown)
{
  Positions normals = normalsOf(shown.model->mesh, shown.model->mesh.positions);
  for (Index v = 0; v < normals.rows(); ++v) {
    const Vector3 q = shown.result.rotations.row(shown.model->solverMesh.weld.unknownOf[v]);
    normals.row(v) = (rotationMatrix(q) * normals.row(v).transpose()).transpose();
  }
  return normals;
}

/// Between the normals of the deformed surface and those that were carried there, in degrees, at each vertex.
std::vector<double> anglesOf(const Deformed& shown, const Positions& carried)
{
  const Positions normals = normalsOf(shown.model->mesh, shown.result.positions);
  std::vector<double> angles;
  for (Index v = 0; v < normals.rows(); ++v) {
    const Vector3 a = normals.row(v);
    const Vector3 b = carried.row(v);
    angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
  }
  return angles;
}

/// Some of the carried normals, as lines of 6 mm.
Lines normalLines(const Deformed& shown, const Positions& carried)
{
  Lines lines;
  for (Index v = 0; v < carried.rows(); ++v) {
    const Vector3 rest = shown.model->mesh.positions.row(v);
    if (std::fmod(rest.x(), 5) != 0 || std::fmod(rest.y(), 10) != 5) continue;
    const Vector3 foot = shown.result.positions.row(v);
    lines.segments.push_back({foot, Vector3(foot + 6 * carried.row(v).transpose())});
  }
  return lines;
}

Panel panelWithNormals(const char* label, const Deformed& shown)
{
  return {
      label, &shown, ColorBy::None, MeshEdges::None, RestGhost::Hidden, {normalLines(shown, carriedNormals(shown))}};
}

/// Deforms the sheet `path` under `list`, and measures angles and edges.
std::vector<std::string> measuredRow(Section& section, const Workbench& bench, const std::string& name,
                                     const std::string& path, const std::string& list)
{
  const BatchRun run = bench.deform("figure_04_" + name, path, list);
  const Deformed shown = deformed(path, list);
  const Spread angles = spreadOf(anglesOf(shown, carriedNormals(shown)));
  const Spread edges = stretchOf(*shown.model, run.mesh.positions, allVertices(*shown.model));
  section.commands.push_back(run.command);
  section.numbers[name + " angle"] = angles.rms;
  section.numbers[name + " edges"] = edges.rms;
  section.numbers["program and library differ"] =
      std::max(section.numbers["program and library differ"],
               (run.mesh.positions - shown.result.positions).cwiseAbs().maxCoeff());
  return {name, fmt::format("{:.1f}", angles.rms), fmt::format("{:.1f}", angles.largest),
          fmt::format("{:.1f} %", 100 * edges.rms)};
}

void drawNormals(const Workbench& bench, const std::string& path, const std::string& without, const std::string& with)
{
  const Deformed none = deformed(path, without);
  const Deformed rotated = deformed(path, with);
  drawPanels(bench.picture("figure_04.png"),
             {panelWithNormals("(a) no rotations", none), panelWithNormals("(b) rotated", rotated)},
             {.back = {0.5, -2, 0.9}, .up = {0, 0, 1}, .panel = {560, 420}, .columns = 2});
}

}  // namespace

Section rotatedNormals(const Workbench& bench)
{
  const std::string path = bench.write("sheet.obj", bumpySheet());
  const Model sheet = makeModel(readMesh(path).mesh, path);
  const std::string without = bench.write("figure_04.constraints.json", bent(sheet, 0));
  const std::string with = bench.write("figure_05.constraints.json", bent(sheet, 90));
  Section section;
  section.paper =
      "the detail keeps its direction where normals are not rotated, and follows the surface where they are.";
  section.method =
      "a sheet with bumps 4 mm high, bent to a quarter of a circle. The handle moves in the same way in both; it hands "
      "on no rotation, or its own. Compared are the normals at rest, rotated by the rotation field, with those of the "
      "deformed surface.";
  Table table{{"rotations", "angle between normals, RMS, degrees", "largest, degrees", "edges, RMS"}, {}};
  for (const auto& [name, list] : {std::pair{std::string("none"), without}, {std::string("rotated"), with}}) {
    table.rows.push_back(measuredRow(section, bench, name, path, list));
  }
  section.tables = {table};
  section.result = fmt::format(
      "Rotated normals lie {:.1f} degrees beside those of the surface (RMS), the others {:.0f}. Edges stretch {:.0f} "
      "times as much without rotations.",
      section.numbers["rotated angle"], section.numbers["none angle"],
      section.numbers["none edges"] / section.numbers["rotated edges"]);
  drawNormals(bench, path, without, with);
  section.pictures = {{"figure_04.png", "The bent sheet with its carried normals: not rotated, and rotated", true}};
  return section;
}

}  // namespace holdfast::paper
