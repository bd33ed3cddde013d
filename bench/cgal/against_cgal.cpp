// Rotations that are found, beside those that are given and beside the three methods of CGAL's
// Surface_mesh_deformation, on tasks like those of the survey of Botsch and Sorkine (2008). Arguments: the last change
// of both, as a share of the diagonal; files of meshes, whose upper ends are bent.

#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <set>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <fmt/format.h>

#include <holdfast/holdfast.h>

namespace {

using namespace holdfast;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;
using Ids = std::vector<Index>;

struct Task {
  std::string name;
  Positions rest = {};
  Triangles triangles = {};
  Ids fixed = {};
  Ids handle = {};
  AxisRotation rotation = {};
  Vector3 translation = Vector3::Zero();

  [[nodiscard]] Positions targets() const
  {
    const Vector3 center = rotation.center.value_or(Vector3::Zero());
    const Eigen::AngleAxisd turn(rotation.degrees * std::numbers::pi / 180, rotation.axis.normalized());
    Positions result = rest;
    for (const Index v : handle) {
      const Vector3 p = rest.row(v);
      result.row(v) = turn * (p - center) + center + translation;
    }
    return result;
  }
  [[nodiscard]] double diagonal() const { return (rest.colwise().maxCoeff() - rest.colwise().minCoeff()).norm(); }
};

struct Outcome {
  std::string method;
  Positions positions;
  int iterations = 0;
  double seconds = 0;
};

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Meshes

using Cell = std::array<int, 3>;

/// The surface of a set of unit cubes, as triangles over lattice points. No two cubes touch in an edge alone.
void addSurface(Task& task, const Cell& size, const std::function<bool(const Cell&)>& isIn)
{
  std::map<Cell, int> idOf;
  std::vector<std::array<int, 3>> triangles;
  const auto isFilled = [&](const Cell& c) {
    for (int k = 0; k < 3; ++k)
      if (c[k] < 0 || c[k] >= size[k]) return false;
    return isIn(c);
  };
  const auto id = [&](const Cell& c) { return idOf.try_emplace(c, static_cast<int>(idOf.size())).first->second; };
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x)
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            const Cell c{x, y, z};
            Cell beside = c;
            beside[axis] += side == 0 ? -1 : 1;
            if (!isFilled(c) || isFilled(beside)) continue;
            std::array<int, 4> corners{};
            for (int k = 0; k < 4; ++k) {
              Cell corner = c;
              corner[axis] += side;
              corner[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
              corner[(axis + 2) % 3] += k >= 2 ? 1 : 0;
              corners[side == 1 ? k : 3 - k] = id(corner);
            }
            const int first = (x + y + z + side) % 2;
            for (const int k : {0, 2})
              triangles.push_back({corners[first + k == 0 ? 0 : (first + k) % 4], corners[(first + k + 1) % 4],
                                   corners[(first + k + 2) % 4]});
          }
  task.rest.resize(static_cast<Index>(idOf.size()), 3);
  for (const auto& [c, i] : idOf) task.rest.row(i) << c[0], c[1], c[2];
  task.triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    task.triangles.row(static_cast<Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
}

/// Each vertex goes to the mean of its neighbours, so many times.
void smooth(Task& task, int times)
{
  std::vector<std::set<int>> neighbours(static_cast<std::size_t>(task.rest.rows()));
  for (Index t = 0; t < task.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (k != l) neighbours[task.triangles(t, k)].insert(static_cast<int>(task.triangles(t, l)));
  for (int time = 0; time < times; ++time) {
    Positions next = Positions::Zero(task.rest.rows(), 3);
    for (Index v = 0; v < next.rows(); ++v) {
      for (const int w : neighbours[v]) next.row(v) += task.rest.row(w);
      next.row(v) /= static_cast<double>(neighbours[v].size());
    }
    task.rest = next;
  }
}

/// Holds what is below `low` and moves what is above `high`, by height.
void hold(Task& task, double low, double high)
{
  for (Index v = 0; v < task.rest.rows(); ++v) {
    if (task.rest(v, 2) <= low) task.fixed.push_back(v);
    if (task.rest(v, 2) >= high) task.handle.push_back(v);
  }
}

/// Bends the part between the heights into an arc about the y axis that keeps the length of its middle line.
void bend(Task& task, double low, double high, double degrees)
{
  hold(task, low, high);
  const double angle = degrees * std::numbers::pi / 180;
  const Eigen::RowVector3d middle = task.rest.colwise().mean();
  const double radius = (high - low) / angle;
  task.rotation = {Vector3::UnitY(), degrees, Vector3(middle.x(), middle.y(), high)};
  task.translation = Vector3(radius * (1 - std::cos(angle)), 0, radius * std::sin(angle) - (high - low));
}

Task bentBar()
{
  Task task{"bar, bent by 135"};
  addSurface(task, {10, 10, 90}, [](const Cell&) { return true; });
  bend(task, 10, 80, 135);
  return task;
}

Task bentCactus()
{
  Task task{"cactus, bent by 70"};
  addSurface(task, {44, 10, 80}, [](const Cell& c) {
    const bool isTrunk = c[0] >= 17 && c[0] < 27;
    const bool isLeft = c[0] < 27 && c[2] >= 30 && c[2] < 38 && c[1] >= 1 && c[1] < 9;
    const bool isLeftArm = c[0] < 8 && c[2] >= 30 && c[2] < 60 && c[1] >= 1 && c[1] < 9;
    const bool isRight = c[0] >= 17 && c[2] >= 44 && c[2] < 52 && c[1] >= 1 && c[1] < 9;
    const bool isRightArm = c[0] >= 36 && c[2] >= 44 && c[2] < 70 && c[1] >= 1 && c[1] < 9;
    return isTrunk || isLeft || isLeftArm || isRight || isRightArm;
  });
  smooth(task, 30);
  hold(task, 5, 1e9);
  for (Index v = 0; v < task.rest.rows(); ++v)
    if (task.rest(v, 2) >= 72) task.handle.push_back(v);
  const double angle = 70 * std::numbers::pi / 180;
  const double length = 67;
  task.rotation = {Vector3::UnitY(), 70, Vector3(22, 5, 72)};
  task.translation = Vector3(length / angle * (1 - std::cos(angle)), 0, length / angle * std::sin(angle) - length);
  return task;
}

Task twistedCylinder()
{
  Task task{"cylinder, twisted by 120"};
  addSurface(task, {16, 16, 70}, [](const Cell&) { return true; });
  for (Index v = 0; v < task.rest.rows(); ++v) {  // squares to circles
    const Eigen::Vector2d p(task.rest(v, 0) - 8, task.rest(v, 1) - 8);
    const double size = p.cwiseAbs().maxCoeff();
    if (size > 0) task.rest.row(v).head<2>() = p * (size * 4 / std::numbers::pi / p.norm());
  }
  hold(task, 5, 65);
  task.rotation = {Vector3::UnitZ(), 120, Vector3::Zero()};
  return task;
}

Task liftedPlane()
{
  Task task{"bumpy plane, lifted"};
  constexpr int kSide = 100;
  task.rest.resize((kSide + 1) * (kSide + 1), 3);
  task.triangles.resize(2 * kSide * kSide, 3);
  const auto id = [](int x, int y) { return y * (kSide + 1) + x; };
  for (int y = 0; y <= kSide; ++y)
    for (int x = 0; x <= kSide; ++x) {
      task.rest.row(id(x, y)) << x, y, 1.5 * std::sin(0.5 * x) * std::sin(0.5 * y);
      const double distance = std::max(std::abs(x - kSide / 2), std::abs(y - kSide / 2));
      if (distance >= 45) task.fixed.push_back(id(x, y));
      if (distance <= 10) task.handle.push_back(id(x, y));
      if (x == kSide || y == kSide) continue;
      const int t = 2 * (y * kSide + x);
      task.triangles.row(t) << id(x, y), id(x + 1, y), id(x + 1, y + 1);
      task.triangles.row(t + 1) << id(x, y), id(x + 1, y + 1), id(x, y + 1);
    }
  task.translation = Vector3(0, 0, 25);
  return task;
}

/// The mesh of a file: the tenth at the lower end of its longest side is held, the one at the upper end bent by 60.
Task bentFile(const std::string& path)
{
  Task task{path.substr(path.rfind('/') + 1) + ", bent by 60"};
  const Model model = makeModel(readMesh(path).mesh, path);
  const SolverMesh& mesh = model.solverMesh;
  int longest = 0;
  (mesh.rest.colwise().maxCoeff() - mesh.rest.colwise().minCoeff()).maxCoeff(&longest);
  task.rest.resize(mesh.rest.rows(), 3);
  for (int k = 0; k < 3; ++k) task.rest.col((k + 2) % 3) = mesh.rest.col((k + longest) % 3);
  task.triangles.resize(static_cast<Index>(mesh.triangles.size()), 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) task.triangles(static_cast<Index>(t), k) = mesh.triangles[t][k];
  const double low = task.rest.col(2).minCoeff();
  const double height = task.rest.col(2).maxCoeff() - low;
  bend(task, low + 0.1 * height, low + 0.9 * height, 60);
  return task;
}

// Methods

Outcome byHoldfast(const Task& task, const std::string& name, RotationSource source, bool turns, double change)
{
  ConstraintList list;
  list.constraints.push_back({"fixed", true, FixedConstraint{{VertexIds{task.fixed}}}});
  HandleConstraint handle;
  handle.select = {VertexIds{task.handle}};
  handle.translate = task.translation;
  if (task.rotation.degrees != 0) handle.motion = task.rotation;
  if (!turns) {
    const Positions targets = task.targets();
    VertexTargets places;
    for (const Index v : task.handle) places.places.emplace_back(targets.row(v));
    handle = {{VertexIds{task.handle}}, places, Vector3::Zero(), {}};
    handle.rotations.assign(task.handle.size(), AxisAngle{Vector3::UnitZ(), 0});
  }
  list.constraints.push_back({"handle", true, handle});
  const Model model = makeModel({task.rest, Polygons(task.triangles)});
  DeformOptions options;
  options.rotations.source = source;
  options.rotations.change = change;
  const auto start = std::chrono::steady_clock::now();
  DeformResult result = deform(model, list, "constraints", options);
  const double seconds = secondsSince(start);
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
Outcome byCgal(const Task& task, const std::string& name, double change)
{
  constexpr int kMostIterations = 3000;
  CgalMesh mesh;
  for (Index v = 0; v < task.rest.rows(); ++v)
    mesh.add_vertex(Point(task.rest(v, 0), task.rest(v, 1), task.rest(v, 2)));
  const auto vertex = [](Index v) { return CgalMesh::Vertex_index(static_cast<unsigned>(v)); };
  for (Index t = 0; t < task.triangles.rows(); ++t)
    mesh.add_face(vertex(task.triangles(t, 0)), vertex(task.triangles(t, 1)), vertex(task.triangles(t, 2)));
  const Positions targets = task.targets();
  const auto start = std::chrono::steady_clock::now();
  CGAL::Surface_mesh_deformation<CgalMesh, CGAL::Default, CGAL::Default, kTag> deformation(mesh);
  for (const auto v : mesh.vertices()) deformation.insert_roi_vertex(v);
  for (const Ids* ids : {&task.fixed, &task.handle})
    for (const Index v : *ids) deformation.insert_control_vertex(vertex(v));
  if (!deformation.preprocess()) std::cerr << name << ": preprocessing failed\n";
  for (const Index v : task.handle)
    deformation.set_target_position(vertex(v), Point(targets(v, 0), targets(v, 1), targets(v, 2)));
  Outcome outcome{name, positionsOf(mesh)};
  double last = 1;
  while (last > change && outcome.iterations < kMostIterations) {
    deformation.deform(1, 0);
    Positions next = positionsOf(mesh);
    last = (next - outcome.positions).rowwise().norm().maxCoeff() / task.diagonal();
    outcome.positions = std::move(next);
    ++outcome.iterations;
  }
  outcome.seconds = secondsSince(start);
  if (last > change) std::cerr << fmt::format("{}: last change {:.1e}\n", name, last);
  return outcome;
}

// Measures

double edgeError(const Task& task, const Positions& p)
{
  double squares = 0;
  for (Index t = 0; t < task.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = task.triangles(t, k);
      const Index b = task.triangles(t, (k + 1) % 3);
      const double change = (p.row(a) - p.row(b)).norm() / (task.rest.row(a) - task.rest.row(b)).norm() - 1;
      squares += change * change;
    }
  return std::sqrt(squares / static_cast<double>(3 * task.triangles.rows()));
}

/// By how many degrees the angle between the normals of two neighbours changes at most.
double normalJump(const Task& task, const Positions& p)
{
  std::map<std::pair<Index, Index>, Index> across;
  double largest = 0;
  const auto angle = [&](const Positions& at, Index s, Index t) {
    const auto normal = [&](Index f) -> Vector3 {
      const Vector3 a = at.row(task.triangles(f, 0));
      const Vector3 b = at.row(task.triangles(f, 1));
      const Vector3 c = at.row(task.triangles(f, 2));
      return (b - a).cross(c - a);
    };
    return std::atan2(normal(s).cross(normal(t)).norm(), normal(s).dot(normal(t)));
  };
  for (Index t = 0; t < task.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = task.triangles(t, k);
      const Index b = task.triangles(t, (k + 1) % 3);
      const auto [entry, isNew] = across.try_emplace({std::min(a, b), std::max(a, b)}, t);
      if (!isNew)
        largest = std::max(largest, std::abs(angle(p, entry->second, t) - angle(task.rest, entry->second, t)));
    }
  return largest * 180 / std::numbers::pi;
}

double residual(const Task& task, const Positions& p)
{
  const Positions targets = task.targets();
  double largest = 0;
  for (const Ids* ids : {&task.fixed, &task.handle})
    for (const Index v : *ids) largest = std::max(largest, (p.row(v) - targets.row(v)).norm());
  return largest / task.diagonal();
}

void print(const Task& task, const Outcome& outcome)
{
  fmt::print("| {} | {} | {:.4f} | {:.2f} | {:.1e} | {} | {:.2f} |\n", task.name, outcome.method,
             edgeError(task, outcome.positions), normalJump(task, outcome.positions), residual(task, outcome.positions),
             outcome.iterations, outcome.seconds);
  std::cout.flush();
}

/// The methods whose names have `part` in them.
void compare(const Task& task, double change, const std::string& part)
{
  using Method = std::function<Outcome(const std::string&)>;
  const auto ours = [&](RotationSource source, bool turns) -> Method {
    return [&task, change, source, turns](const auto& name) { return byHoldfast(task, name, source, turns, change); };
  };
  const std::vector<std::pair<std::string, Method>> methods{
      {"none", ours(RotationSource::Given, false)},
      {"given", ours(RotationSource::Given, true)},
      {"found", ours(RotationSource::Found, true)},
      {"found-smooth", ours(RotationSource::FoundSmooth, true)},
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
    for (const auto& make : {bentBar, bentCactus, twistedCylinder, liftedPlane}) compare(make(), change, part);
  return 0;
}
