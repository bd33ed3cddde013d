// Rotations that are found, beside those that are given and beside the three methods of CGAL's
// Surface_mesh_deformation, on tasks like those of the survey of Botsch and Sorkine (2008). Arguments: the last change
// of both, as a share of the diagonal; a part of the names of methods; files of meshes, whose upper ends are bent.

#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <fmt/format.h>

#include <holdfast/holdfast.h>

#include "bench/measure.h"
#include "bench/paper/survey_tasks.h"
#include "bench/paper/task_measures.h"

namespace {

using namespace holdfast;
using namespace holdfast::paper;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;

struct Outcome {
  std::string method;
  Positions positions;
  int iterations = 0;
  double seconds = 0;
};

Outcome byHoldfast(const SurveyTask& task, const std::string& name, RotationSource source, HandleRotation rotation,
                   double change)
{
  const Model model = makeModel({task.rest, Polygons(task.triangles)});
  DeformOptions options;
  options.rotations.source = source;
  options.rotations.change = change;
  DeformResult result;
  const double seconds =
      bench::secondsOf([&] { result = deform(model, constraintsOf(task, rotation), "constraints", options); });
  if (result.report.solve.status != SolveStatus::Ok) std::cerr << name << ": " << result.report.solve.message << '\n';
  const int iterations = result.report.solve.iterations ? result.report.solve.iterations->count : 0;
  return {name, std::move(result.positions), iterations, seconds};
}

Positions positionsOf(const CgalMesh& mesh)
{
  Positions result(static_cast<Index>(mesh.number_of_vertices()), 3);
  for (const auto v : mesh.vertices()) result.row(v.idx()) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  return result;
}

template <CGAL::Deformation_algorithm_tag kTag>
Outcome byCgal(const SurveyTask& task, const std::string& name, double change)
{
  constexpr int kMostIterations = 3000;
  CgalMesh mesh;
  for (Index v = 0; v < task.rest.rows(); ++v)
    mesh.add_vertex(Point(task.rest(v, 0), task.rest(v, 1), task.rest(v, 2)));
  const auto vertex = [](Index v) { return CgalMesh::Vertex_index(static_cast<unsigned>(v)); };
  for (Index t = 0; t < task.triangles.rows(); ++t)
    mesh.add_face(vertex(task.triangles(t, 0)), vertex(task.triangles(t, 1)), vertex(task.triangles(t, 2)));
  const Positions targets = task.targets();
  Outcome outcome{name, positionsOf(mesh)};
  double last = 1;
  outcome.seconds = bench::secondsOf([&] {
    CGAL::Surface_mesh_deformation<CgalMesh, CGAL::Default, CGAL::Default, kTag> deformation(mesh);
    for (const auto v : mesh.vertices()) deformation.insert_roi_vertex(v);
    for (const auto* ids : {&task.fixed, &task.handle})
      for (const Index v : *ids) deformation.insert_control_vertex(vertex(v));
    if (!deformation.preprocess()) std::cerr << name << ": preprocessing failed\n";
    for (const Index v : task.handle)
      deformation.set_target_position(vertex(v), Point(targets(v, 0), targets(v, 1), targets(v, 2)));
    while (last > change && outcome.iterations < kMostIterations) {
      deformation.deform(1, 0);
      Positions next = positionsOf(mesh);
      last = (next - outcome.positions).rowwise().norm().maxCoeff() / task.diagonal();
      outcome.positions = std::move(next);
      ++outcome.iterations;
    }
  });
  if (last > change) std::cerr << fmt::format("{}: last change {:.1e}\n", name, last);
  return outcome;
}

void print(const SurveyTask& task, const Outcome& outcome)
{
  fmt::print("| {} | {} | {:.4f} | {:.2f} | {:.1e} | {} | {:.2f} |\n", task.name, outcome.method,
             edgeError(task, outcome.positions), dihedralError(task, outcome.positions).largest,
             residual(task, outcome.positions), outcome.iterations, outcome.seconds);
  std::cout.flush();
}

/// The methods whose names have `part` in them.
void compare(const SurveyTask& task, double change, const std::string& part)
{
  using Method = std::function<Outcome(const std::string&)>;
  const auto ours = [&](RotationSource source, HandleRotation rotation) -> Method {
    return [&task, change, source, rotation](const auto& name) {
      return byHoldfast(task, name, source, rotation, change);
    };
  };
  const std::vector<std::pair<std::string, Method>> methods{
      {"none", ours(RotationSource::Given, HandleRotation::None)},
      {"given", ours(RotationSource::Given, HandleRotation::Stated)},
      {"found", ours(RotationSource::Found, HandleRotation::Stated)},
      {"found-smooth", ours(RotationSource::FoundSmooth, HandleRotation::Stated)},
      {"ORIGINAL_ARAP", [&](const auto& name) { return byCgal<CGAL::ORIGINAL_ARAP>(task, name, change); }},
      {"SPOKES_AND_RIMS", [&](const auto& name) { return byCgal<CGAL::SPOKES_AND_RIMS>(task, name, change); }},
      {"SRE_ARAP", [&](const auto& name) { return byCgal<CGAL::SRE_ARAP>(task, name, change); }}};
  for (const auto& [name, method] : methods)
    if (name.find(part) != std::string::npos) print(task, method(name));
}

}  // namespace

int main(int argc, char** argv)
{
  const double change = argc > 1 ? std::stod(argv[1]) : kFoundChange;
  const std::string part = argc > 2 ? argv[2] : "";
  fmt::print("| task | method | edges, RMS | largest normal jump, degrees | residual | iterations | seconds |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (int k = 3; k < argc; ++k) compare(bentFile(argv[k]), change, part);
  if (argc <= 3)
    for (const SurveyTask& task : {bentBar(), bentCactus(), twistedCylinder(), liftedPlane()})
      compare(task, change, part);
  return 0;
}
