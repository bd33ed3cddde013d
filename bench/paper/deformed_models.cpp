// Fig. 10: models of the project, and fetched ones, deformed.

#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/io/mesh_file.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"
#include "bench/scenes.h"

namespace holdfast::paper {
namespace {

constexpr const char* kAllMet = "Every constraint is met within 1e-12 of the diagonal.";
constexpr double kPromise = 1e-12;

struct Task {
  std::string name;
  std::string mesh;
  std::string constraints;
};

Table modelTable()
{
  return {{"model", "vertices", "constraints", "rows", "largest residual / diagonal", "accuracy", "set-up, s",
           "decomposition, s", "solution, s"},
          {}};
}

/// Deforms the model of `task`, and adds it to the section and its first table.
void addModel(Section& section, const Workbench& bench, const Task& task)
{
  const BatchRun run = bench.deform("figure_10", task.mesh, task.constraints);
  const nlohmann::json& solve = run.solve();
  const double residual = solve.at("max_residual_relative").get<double>();
  if (run.exitCode != 0 || residual > kPromise) throw std::runtime_error(run.command + "\nleft constraints unmet");
  Index rows = 0;
  for (const nlohmann::json& constraint : run.report.at("constraints")) rows += constraint.at("rows").get<Index>();
  const auto seconds = [&](const char* step) {
    return fmt::format("{:.3f}", solve.at("seconds").at(step).get<double>());
  };
  section.commands.push_back(run.command);
  section.numbers[task.name + " residual"] = residual;
  section.tables[0].rows.push_back({task.name, fmt::format("{}", run.mesh.vertexCount()),
                                    fmt::format("{}", run.report.at("constraints").size()), fmt::format("{}", rows),
                                    fmt::format("{:.1e}", residual),
                                    fmt::format("{:.1e}", solve.at("accuracy").get<double>()), seconds("setup"),
                                    seconds("decomposition"), seconds("solution")});
}

/// The feet of a model whose y is up stay, and its top rotates by 40 degrees to the side.
ConstraintList leaning(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = boundingBox(mesh.positions);
  const auto at = [&](double share) { return Vector3(box.min() + share * box.sizes().y() * Vector3::UnitY()); };
  const Vector3 center(box.center().x(), at(0.3).y(), box.center().z());
  const HandleConstraint top{
      {InHalfSpace{at(0.8), {0, 1, 0}}}, AxisRotation{Vector3::UnitZ(), 40, center}, Vector3::Zero(), {}};
  return {"", {{"feet", true, FixedConstraint{{InHalfSpace{at(0.15), {0, -1, 0}}}}}, {"top", true, top}}};
}

}  // namespace

Section deformedModels(const Workbench& bench)
{
  const std::vector<Task> tasks{
      {"bracket", "data/bracket.obj", "data/bracket.constraints.json"},
      {"bar", "data/bar.obj", "data/bar.twist_360.constraints.json"},
      {"head", "data/head.ply", "data/head.rigid_eyes.constraints.json"},
      {"plate", "data/plate_unsymmetric.off", "data/plate_unsymmetric.three_handles.constraints.json"}};
  Section section;
  section.paper = "models of several kinds, deformed.";
  section.method = "meshes of the project with their constraint files.";
  section.tables = {modelTable()};
  section.result = kAllMet;
  std::vector<Picture> tiles;
  for (const Task& task : tasks) {
    addModel(section, bench, task);
    const Deformed shown = deformed(task.mesh, task.constraints);
    const Panel panel{task.name, &shown, ColorBy::Displacement, MeshEdges::Sharp, RestGhost::Edges};
    tiles.push_back(drawnPanels({panel}, {.back = {1, -2, 0.8}, .up = {0, 0, 1}, .panel = {420, 380}}).front());
  }
  const std::string path = bench.picture("figure_10.png");
  writeFile(path, toPng(tiled(tiles, 2), path));
  section.pictures = {
      {"figure_10.png", "Models of the project, deformed, with edges at rest, coloured by displacement", true}};
  return section;
}

Section deformedScans(const Workbench& bench)
{
  Section section;
  section.paper = "scanned models, deformed.";
  section.method =
      "Armadillo, Bunny and Dragon, twice each. *Points*: one end stays, the other is moved and rotated by a handle, "
      "and "
      "up to 900 points on vertices, on edges and in faces move in between. *Leaning*: the feet stay, and the top "
      "rotates "
      "by 40 degrees. The Dragon has no picture: its terms ask that it is not shown deformed.";
  section.tables = {modelTable()};
  section.result = kAllMet;
  for (const std::string file : {"armadillo.off", "bunny.ply", "dragon.ply"}) {
    const std::string path = bench.model(file);
    const std::string name = file.substr(0, file.find('.'));
    const Mesh mesh = readMesh(path).mesh;
    addModel(section, bench, {name + ", points", path, bench.write(name + "_points.json", bench::scene(mesh))});
    const std::string lean = bench.write(name + "_leaning.json", leaning(mesh));
    addModel(section, bench, {name + ", leaning", path, lean});
    if (name == "dragon") continue;
    const Deformed shown = deformed(path, lean);
    const std::string picture = bench.out("figure_10_" + name + ".png");
    drawPanels(picture, {{name, &shown, ColorBy::Displacement}}, {.back = {0, 0, 1}, .up = {0, 1, 0}, .columns = 1});
    section.pictures.push_back({picture, "the leaning model, coloured by displacement.", false});
  }
  return section;
}

}  // namespace holdfast::paper
