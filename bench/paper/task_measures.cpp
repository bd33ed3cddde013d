#include "bench/paper/task_measures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <holdfast/geometry/rotation_log.h>

namespace holdfast::paper {
namespace {

Vector3 corner(const SurveyTask& task, const Positions& p, Index triangle, int k)
{
  return p.row(task.triangles(triangle, k % 3));
}

Vector3 normal(const SurveyTask& task, const Positions& p, Index triangle)
{
  const Vector3 a = corner(task, p, triangle, 0);
  return (corner(task, p, triangle, 1) - a).cross(corner(task, p, triangle, 2) - a);
}

double angleBetween(const SurveyTask& task, const Positions& p, Index s, Index t)
{
  const Vector3 a = normal(task, p, s);
  const Vector3 b = normal(task, p, t);
  return std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree;
}

double volume(const SurveyTask& task, const Positions& p)
{
  double sum = 0;
  for (Index t = 0; t < task.triangles.rows(); ++t) sum += corner(task, p, t, 0).dot(normal(task, p, t)) / 6;
  return sum;
}

}  // namespace

double edgeError(const SurveyTask& task, const Positions& deformed)
{
  double squares = 0;
  for (Index t = 0; t < task.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const double before = (corner(task, task.rest, t, k) - corner(task, task.rest, t, k + 1)).norm();
      const double after = (corner(task, deformed, t, k) - corner(task, deformed, t, k + 1)).norm();
      squares += std::pow(after / before - 1, 2);
    }
  return std::sqrt(squares / static_cast<double>(3 * task.triangles.rows()));
}

double volumeError(const SurveyTask& task, const Positions& deformed)
{
  return volume(task, deformed) / volume(task, task.rest) - 1;
}

DihedralError dihedralError(const SurveyTask& task, const Positions& deformed)
{
  std::map<std::pair<Index, Index>, Index> firstOn;
  DihedralError error;
  double squares = 0;
  Index count = 0;
  for (Index t = 0; t < task.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({task.triangles(t, k), task.triangles(t, (k + 1) % 3)});
      const auto [entry, isNew] = firstOn.try_emplace({low, high}, t);
      if (isNew) continue;
      const double change =
          std::abs(angleBetween(task, deformed, entry->second, t) - angleBetween(task, task.rest, entry->second, t));
      error.largest = std::max(error.largest, change);
      squares += change * change;
      ++count;
    }
  error.rms = std::sqrt(squares / static_cast<double>(count));
  return error;
}

double residual(const SurveyTask& task, const Positions& deformed)
{
  const Positions targets = task.targets();
  double largest = 0;
  for (const auto* ids : {&task.fixed, &task.handle})
    for (const Index v : *ids) largest = std::max(largest, (deformed.row(v) - targets.row(v)).norm());
  return largest / task.diagonal();
}

}  // namespace holdfast::paper
