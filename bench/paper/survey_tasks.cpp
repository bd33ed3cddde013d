#include "bench/paper/survey_tasks.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <holdfast/geometry/rotation_log.h>

namespace holdfast::paper {
namespace {

using Cell = std::array<int, 3>;

/// The surface of a set of unit cubes, as triangles over lattice points. No two cubes touch in an edge alone.
void addSurface(SurveyTask& task, const Cell& size, const std::function<bool(const Cell&)>& isIn)
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
void smooth(SurveyTask& task, int times)
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
void hold(SurveyTask& task, double low, double high)
{
  for (Index v = 0; v < task.rest.rows(); ++v) {
    if (task.rest(v, 2) <= low) task.fixed.push_back(v);
    if (task.rest(v, 2) >= high) task.handle.push_back(v);
  }
}

/// Bends the part between the heights into an arc about the y axis that keeps the length of its middle line.
void bend(SurveyTask& task, double low, double high, double degrees)
{
  hold(task, low, high);
  const double angle = degrees * std::numbers::pi / 180;
  const Eigen::RowVector3d middle = task.rest.colwise().mean();
  const double radius = (high - low) / angle;
  task.rotation = {Vector3::UnitY(), degrees, Vector3(middle.x(), middle.y(), high)};
  task.translation = Vector3(radius * (1 - std::cos(angle)), 0, radius * std::sin(angle) - (high - low));
}

/// 10 x 10 x 90 units.
SurveyTask bar(std::string name)
{
  SurveyTask task{std::move(name)};
  addSurface(task, {10, 10, 90}, [](const Cell&) { return true; });
  return task;
}

HandleConstraint handleOf(const SurveyTask& task, HandleRotation rotation)
{
  const Selection select{VertexIds{task.handle}};
  if (rotation == HandleRotation::None) {
    const Positions targets = task.targets();
    VertexTargets places;
    for (const Index v : task.handle) places.places.emplace_back(targets.row(v));
    return {select, places, Vector3::Zero(), std::vector<AxisAngle>(task.handle.size())};
  }
  if (task.rotation.degrees == 0) return {select, {}, task.translation, {}};
  return {select, task.rotation, task.translation, {}};
}

}  // namespace

Positions SurveyTask::targets() const
{
  const Vector3 center = rotation.center.value_or(Vector3::Zero());
  const Eigen::Matrix3d R = rotationMatrix(rotation.axis, rotation.degrees);
  Positions result = rest;
  for (const Index v : handle) result.row(v) = R * (Vector3(rest.row(v)) - center) + center + translation;
  return result;
}

double SurveyTask::diagonal() const
{
  return (rest.colwise().maxCoeff() - rest.colwise().minCoeff()).norm();
}

SurveyTask bentBar(double degrees)
{
  SurveyTask task = bar(fmt::format("bar, bent by {}", degrees));
  bend(task, 10, 80, degrees);
  return task;
}

SurveyTask twistedBar(double degrees)
{
  SurveyTask task = bar(fmt::format("bar, twisted by {}", degrees));
  hold(task, 10, 80);
  task.rotation = {Vector3::UnitZ(), degrees, Vector3(5, 5, 0)};
  return task;
}

SurveyTask bentCactus(double degrees)
{
  SurveyTask task{fmt::format("cactus, bent by {}", degrees)};
  addSurface(task, {44, 10, 80}, [](const Cell& c) {
    const bool isTrunk = c[0] >= 17 && c[0] < 27;
    const bool isLeft = c[0] < 27 && c[2] >= 30 && c[2] < 38 && c[1] >= 1 && c[1] < 9;
    const bool isLeftArm = c[0] < 8 && c[2] >= 30 && c[2] < 60 && c[1] >= 1 && c[1] < 9;
    const bool isRight = c[0] >= 17 && c[2] >= 44 && c[2] < 52 && c[1] >= 1 && c[1] < 9;
    const bool isRightArm = c[0] >= 36 && c[2] >= 44 && c[2] < 70 && c[1] >= 1 && c[1] < 9;
    return isTrunk || isLeft || isLeftArm || isRight || isRightArm;
  });
  smooth(task, 30);
  hold(task, 5, 72);
  const double angle = degrees * std::numbers::pi / 180;
  const double length = 67;
  task.rotation = {Vector3::UnitY(), degrees, Vector3(22, 5, 72)};
  task.translation = Vector3(length / angle * (1 - std::cos(angle)), 0, length / angle * std::sin(angle) - length);
  return task;
}

SurveyTask twistedCylinder(double degrees)
{
  SurveyTask task{fmt::format("cylinder, twisted by {}", degrees)};
  addSurface(task, {16, 16, 70}, [](const Cell&) { return true; });
  for (Index v = 0; v < task.rest.rows(); ++v) {  // squares to circles
    const Eigen::Vector2d p(task.rest(v, 0) - 8, task.rest(v, 1) - 8);
    const double size = p.cwiseAbs().maxCoeff();
    if (size > 0) task.rest.row(v).head<2>() = p * (size * 4 / std::numbers::pi / p.norm());
  }
  hold(task, 5, 65);
  task.rotation = {Vector3::UnitZ(), degrees, Vector3::Zero()};
  return task;
}

SurveyTask liftedPlane(double height)
{
  SurveyTask task{fmt::format("bumpy plane, lifted by {}", height)};
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
  task.translation = Vector3(0, 0, height);
  return task;
}

SurveyTask bentAtItsEnd(const std::string& name, Mesh whole)
{
  SurveyTask task{name + ", bent by 60"};
  const Model model = makeModel(std::move(whole), name);
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

ConstraintList constraintsOf(const SurveyTask& task, HandleRotation rotation)
{
  ConstraintList list;
  list.constraints.push_back({"fixed", true, FixedConstraint{{VertexIds{task.fixed}}}});
  list.constraints.push_back({"handle", true, handleOf(task, rotation)});
  return list;
}

}  // namespace holdfast::paper
