#include "shell.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

namespace holdfast::generate {
namespace {

// Places of border vertices closer than this are one vertex: far above rounding, far below any edge.
constexpr double kWeldDistance = 1e-7;

// The last bits of sines and cosines differ from one library to the next. Filling a region chooses between equals
// here and there, so that these bits, if let in, would change the whole pattern of triangles.
Vector2 snapped(const Vector2& place)
{
  constexpr double kPerUnit = 1 << 28;
  return (place * kPerUnit).array().round() / kPerUnit;
}

Index stepsFor(double length, double step)
{
  return std::max<Index>(1, std::lround(length / step));
}

// The two triangles between a step of a lower and of an upper ring. In an even row the lower ring is the one that is
// not turned.
void addCell(std::vector<Triangle>& triangles, const Ring& lower, const Ring& upper, Index row, Index column)
{
  const Index next = (column + 1) % static_cast<Index>(lower.size());
  const Index a = lower[column], b = lower[next], c = upper[next], d = upper[column];
  if (row % 2 == 0) {
    triangles.push_back({a, b, d});
    triangles.push_back({b, c, d});
  } else {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
}

}  // namespace

Chart planeChart(const Vector3& origin, const Vector3& normal)
{
  const Vector3 v = normal.unitOrthogonal();
  const Vector3 u = v.cross(normal);
  return {[=](const Vector3& place) { return Vector2((place - origin).dot(u), (place - origin).dot(v)); },
          [=](const Vector2& place) -> Vector3 { return origin + place.x() * u + place.y() * v; }};
}

Vector3 Circle::at(double angle) const
{
  return centre + radius * (std::cos(angle) * x + std::sin(angle) * y);
}

double Circle::angleOf(const Vector3& place) const
{
  return std::atan2((place - centre).dot(y), (place - centre).dot(x));
}

Chart cylinderChart(const Circle& circle, Facing facing)
{
  const double sign = facing == Facing::kOutward ? 1 : -1;
  const Vector3 axis = sign * circle.x.cross(circle.y);
  return {[=](const Vector3& place) {
            return Vector2(circle.radius * circle.angleOf(place), (place - circle.centre).dot(axis));
          },
          [=](const Vector2& place) -> Vector3 { return circle.at(place.x() / circle.radius) + place.y() * axis; }};
}

Curve Shell::curve(const std::function<Vector3(double)>& place, Index count)
{
  Curve result;
  for (Index i = 0; i <= count; ++i) {
    result.push_back(borderVertex(place(static_cast<double>(i) / static_cast<double>(count))));
  }
  return result;
}

Curve Shell::segment(const Vector3& from, const Vector3& to)
{
  return curve([&](double t) -> Vector3 { return (1 - t) * from + t * to; },
               stepsFor((to - from).norm(), largestEdge_));
}

Curve Shell::arc(const Circle& circle, double fromAngle, double toAngle)
{
  return curve([&](double t) { return circle.at((1 - t) * fromAngle + t * toAngle); },
               stepsFor(circle.radius * std::abs(toAngle - fromAngle), largestEdge_));
}

Ring Shell::join(const std::vector<Curve>& curves)
{
  Ring result = curves.front();
  const Curve& second = curves[1];
  if (result.back() != second.front() && result.back() != second.back()) std::ranges::reverse(result);
  for (std::size_t i = 1; i < curves.size(); ++i) {
    Curve curve = curves[i];
    if (curve.front() != result.back()) std::ranges::reverse(curve);
    if (curve.front() != result.back()) throw std::logic_error("the curves of a ring do not meet");
    result.insert(result.end(), curve.begin() + 1, curve.end());
  }
  if (result.front() != result.back()) throw std::logic_error("the curves of a ring do not close");
  result.pop_back();
  return result;
}

void Shell::addPatch(const std::string& group, const Chart& chart, const std::vector<Ring>& rings)
{
  std::vector<Loop> loops;
  std::vector<Index> ids;
  for (const Ring& ring : rings) {
    Loop loop;
    for (const Index vertex : ring) loop.push_back(snapped(chart.flatten(mesh_.points[vertex])));
    loops.push_back(loop);
    ids.insert(ids.end(), ring.begin(), ring.end());
  }
  constexpr double kGrowth = 0.3;
  const Region region = meshRegion(loops, sizeFromBoundary(loops, kGrowth, largestEdge_));
  for (std::size_t i = ids.size(); i < region.points.size(); ++i)
    ids.push_back(innerVertex(chart.lift(region.points[i])));
  mesh_.groups.push_back({group, static_cast<Index>(mesh_.triangles.size())});
  for (const auto& [a, b, c] : region.triangles) mesh_.triangles.push_back({ids[a], ids[b], ids[c]});
}

Shell::BandEnds Shell::addBand(const std::string& group, const Band& band)
{
  std::vector<Ring> rings;
  for (Index row = 0; row <= band.rows; ++row) {
    const bool isEnd = row == 0 || row == band.rows;
    Ring ring;
    for (Index i = 0; i < band.count; ++i) {
      const double t = (static_cast<double>(i) + 0.5 * static_cast<double>(row % 2)) / static_cast<double>(band.count);
      const Vector3 place = band.place(row, t);
      ring.push_back(isEnd ? borderVertex(place) : innerVertex(place));
    }
    rings.push_back(ring);
  }
  mesh_.groups.push_back({group, static_cast<Index>(mesh_.triangles.size())});
  for (Index row = 0; row < band.rows; ++row) {
    for (Index i = 0; i < band.count; ++i) addCell(mesh_.triangles, rings[row], rings[row + 1], row, i);
  }
  return {rings.front(), rings.back()};
}

Index Shell::borderVertex(const Vector3& place)
{
  for (const Index vertex : border_) {
    if ((mesh_.points[vertex] - place).norm() < kWeldDistance) return vertex;
  }
  border_.push_back(innerVertex(place));
  return border_.back();
}

Index Shell::innerVertex(const Vector3& place)
{
  mesh_.points.push_back(place);
  return static_cast<Index>(mesh_.points.size()) - 1;
}

}  // namespace holdfast::generate
