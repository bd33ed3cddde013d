#include "bench/paper/bad_plates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <Eigen/Geometry>

#include <holdfast/operators/cotangents.h>

namespace holdfast::paper {
namespace {

constexpr Index kRow = 40;      // vertices of a row
constexpr double kSide = 0.05;  // of a triangle
constexpr Index kPitch = 6;     // vertices from one bad place to the next

using Corners = std::array<Index, 3>;

struct Builder {
  std::vector<Vector3> places;
  std::vector<Corners> triangles;

  [[nodiscard]] Mesh mesh() const
  {
    Mesh result;
    result.positions.resize(static_cast<Index>(places.size()), 3);
    for (Index v = 0; v < result.vertexCount(); ++v) result.positions.row(v) = places[v];
    for (const Corners& t : triangles) result.faces.add({t[0], t[1], t[2]});
    return result;
  }

  Index add(const Vector3& place)
  {
    places.push_back(place);
    return static_cast<Index>(places.size()) - 1;
  }

  /// Each triangle with this directed edge becomes two, which meet at `middle`.
  void split(Index from, Index to, Index middle)
  {
    const std::size_t count = triangles.size();
    for (std::size_t t = 0; t < count; ++t)
      for (int k = 0; k < 3; ++k) {
        const auto [a, b, c] = std::array{triangles[t][k], triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]};
        if (!(a == from && b == to) && !(a == to && b == from)) continue;
        triangles[t] = {a, middle, c};
        triangles.push_back({middle, b, c});
        break;
      }
  }
};

Index idAt(Index x, Index y)
{
  return y * kRow + x;
}

Builder equilateral()
{
  Builder plate;
  for (Index y = 0; y < kRow; ++y)
    for (Index x = 0; x < kRow; ++x)
      plate.add(kSide * Vector3(static_cast<double>(x) + 0.5 * static_cast<double>(y % 2),
                                std::sqrt(0.75) * static_cast<double>(y), 0));
  for (Index y = 0; y + 1 < kRow; ++y)
    for (Index x = 0; x + 1 < kRow; ++x) {
      const auto [a, b, c, d] = std::array{idAt(x, y), idAt(x + 1, y), idAt(x, y + 1), idAt(x + 1, y + 1)};
      if (y % 2 == 0) {
        plate.triangles.push_back({a, b, c});
        plate.triangles.push_back({b, d, c});
      } else {
        plate.triangles.push_back({a, b, d});
        plate.triangles.push_back({a, d, c});
      }
    }
  return plate;
}

/// Calls `use(x, y)` for bad places away from the ends and from one another, on even rows.
void forEachPlace(const std::function<void(Index x, Index y)>& use)
{
  for (Index y = kPitch; y + kPitch < kRow; y += kPitch)
    for (Index x = kPitch; x + kPitch < kRow; x += kPitch) use(x, y);
}

/// A vertex on an edge, beside its end.
Builder withSmallAngles(double severity)
{
  Builder plate = equilateral();
  forEachPlace([&](Index x, Index y) {
    const Index from = idAt(x, y);
    const Index to = idAt(x + 1, y);
    plate.split(from, to, plate.add(plate.places[from] + severity * (plate.places[to] - plate.places[from])));
  });
  return plate;
}

/// A vertex in a triangle, beside the middle of a side.
Builder withFlatAngles(double severity)
{
  Builder plate = equilateral();
  forEachPlace([&](Index x, Index y) {
    const Corners corners{idAt(x, y), idAt(x + 1, y), idAt(x, y + 1)};
    const auto found = std::ranges::find(plate.triangles, corners);
    const auto [a, b, c] = corners;
    const Index middle = plate.add((plate.places[a] + plate.places[b]) / 2 + severity * kSide * Vector3::UnitY());
    *found = {a, b, middle};
    plate.triangles.push_back({middle, b, c});
    plate.triangles.push_back({a, middle, c});
  });
  return plate;
}

/// The Voronoi area at the middle of six triangles whose other corners are alternately at 1 and at `ratio`, by its
/// formula, an eighth of the sum of (cot a + cot b) |p_i - p_j|^2, for each triangle.
double starArea(double ratio)
{
  Positions corners(3, 3);
  corners << 0, 0, 0, 1, 0, 0, ratio / 2, ratio * std::sqrt(0.75), 0;
  return literalVoronoiAreas(corners, {{0, 1, 2}})[0];
}

/// Returns the ratio at which `starArea` is 0.
double cancellingRatio()
{
  double low = 0.05;
  double high = 0.5;
  for (int k = 0; k < 60; ++k) (starArea((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  return (low + high) / 2;
}

/// Three of the six neighbours of a vertex come so near that its area is nearly 0.
Builder withCancellingAreas(double severity)
{
  Builder plate = equilateral();
  const double ratio = cancellingRatio() * (1 + severity);
  forEachPlace([&](Index x, Index y) {
    const Vector3 middle = plate.places[idAt(x, y)];
    for (const Index neighbour : {idAt(x + 1, y), idAt(x - 1, y + 1), idAt(x - 1, y - 1)})
      plate.places[neighbour] = middle + ratio * (plate.places[neighbour] - middle);
  });
  return plate;
}

/// Right-angled triangles with two equal sides, halved until none is larger than `sizeAt` asks for at its middle. All
/// are of one shape.
class Halving {
 public:
  explicit Halving(std::function<double(const Vector3&)> sizeAt) : sizeAt_(std::move(sizeAt))
  {
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      plate_.add(Vector3(x, y, 0));
    plate_.triangles = {{0, 1, 2}, {2, 3, 0}};  // the longest side last
  }

  [[nodiscard]] Builder halved() &&
  {
    for (bool isDone = false; !isDone;) {
      isDone = true;
      for (std::size_t t = 0; t < plate_.triangles.size(); ++t)
        if (isLarge(t)) {
          halve(t);
          isDone = false;
        }
    }
    return std::move(plate_);
  }

 private:
  [[nodiscard]] double longest(std::size_t t) const
  {
    return (plate_.places[plate_.triangles[t][0]] - plate_.places[plate_.triangles[t][2]]).norm();
  }

  [[nodiscard]] bool isLarge(std::size_t t) const
  {
    const auto [a, b, c] = plate_.triangles[t];
    return longest(t) > sizeAt_((plate_.places[a] + plate_.places[b] + plate_.places[c]) / 3);
  }

  /// The triangle with the directed edge; the number of triangles where there is none.
  [[nodiscard]] std::size_t triangleOn(Index from, Index to) const
  {
    const auto found = std::ranges::find_if(plate_.triangles, [&](const Corners& t) {
      return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
    });
    return static_cast<std::size_t>(found - plate_.triangles.begin());
  }

  /// With its neighbour across the longest side, which is halved first until that side is its longest one too.
  void halve(std::size_t t)
  {
    const auto [a, b, c] = plate_.triangles[t];
    std::size_t other = triangleOn(a, c);
    while (other < plate_.triangles.size() && plate_.triangles[other][0] != c) {
      halve(other);
      other = triangleOn(a, c);
    }
    const Index middle = plate_.add((plate_.places[a] + plate_.places[c]) / 2);
    plate_.triangles[t] = {b, middle, a};
    plate_.triangles.push_back({c, middle, b});
    if (other >= plate_.triangles.size() - 1) return;
    const Index d = plate_.triangles[other][1];
    plate_.triangles[other] = {d, middle, c};
    plate_.triangles.push_back({a, middle, d});
  }

  std::function<double(const Vector3&)> sizeAt_;
  Builder plate_;
};

constexpr double kUsual = 0.12;  // length of the longest side

/// Size grows as half of the distance to the centre, from `severity` of the usual to the usual one.
Builder withSmallAreas(double severity)
{
  return Halving([severity](const Vector3& place) {
           return std::clamp(place.norm() / 2, kUsual * std::sqrt(severity), kUsual);
         })
      .halved();
}

/// Within a disc of 20 triangles size is usual; beyond it grows as half of the distance.
Builder withLargeAreas(double severity)
{
  const double usual = std::sqrt(severity);
  return Halving([usual](const Vector3& place) { return std::max(usual, (place.norm() - 20 * usual) / 2); }).halved();
}

}  // namespace

const char* name(Cause cause)
{
  constexpr std::array kNames{"small angle", "flat angle", "small areas", "large areas", "cancelling area"};
  return kNames[static_cast<std::size_t>(cause)];
}

const std::vector<Cause>& allCauses()
{
  static const std::vector<Cause> kAll{Cause::SmallAngle, Cause::FlatAngle, Cause::SmallAreas, Cause::LargeAreas,
                                       Cause::CancellingArea};
  return kAll;
}

Mesh soundPlate()
{
  return equilateral().mesh();
}

Mesh badPlate(Cause cause, double severity)
{
  constexpr std::array kMakers{withSmallAngles, withFlatAngles, withSmallAreas, withLargeAreas, withCancellingAreas};
  return kMakers[static_cast<std::size_t>(cause)](severity).mesh();
}

}  // namespace holdfast::paper
