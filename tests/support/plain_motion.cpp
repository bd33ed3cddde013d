#include "support/plain_motion.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "support/plain_selection.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using Real = long double;

/// a + factor b.
PlainPlace sum(PlainPlace a, Real factor, const PlainPlace& b)
{
  for (std::size_t k = 0; k < 3; ++k) a[k] += factor * b[k];
  return a;
}

Real innerProduct(const PlainPlace& a, const PlainPlace& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PlainPlace cross(const PlainPlace& a, const PlainPlace& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

PlainPlace unit(const PlainPlace& a)
{
  return sum({}, 1 / std::hypot(a[0], a[1], a[2]), a);
}

/// Rodrigues' formula.
PlainPlace rotated(const PlainPlace& v, const PlainPlace& axis, Real degrees)
{
  const PlainPlace k = unit(axis);
  const Real angle = std::fmod(degrees, Real{360}) * std::numbers::pi_v<Real> / 180;
  return sum(sum(sum({}, std::cos(angle), v), std::sin(angle), cross(k, v)), innerProduct(k, v) * (1 - std::cos(angle)),
             k);
}

/// The mirror image across the plane through 0 with the unit normal `n`.
PlainPlace mirrored(const PlainPlace& v, const PlainPlace& n)
{
  return sum(v, -2 * innerProduct(v, n), n);
}

/// The shortest rotation from one direction to another is two mirror images: `from` goes to -`from`, and on to `to`.
PlainPlace swung(const PlainPlace& v, const PlainPlace& from, const PlainPlace& to)
{
  const PlainPlace a = unit(from);
  return mirrored(mirrored(v, a), unit(sum(a, 1, unit(to))));
}

/// Right-handed, orthonormal.
std::array<PlainPlace, 3> axesOf(const Json& frame)
{
  const PlainPlace x = unit(frame.value("x", PlainPlace{1, 0, 0}));
  const PlainPlace y = frame.value("y", PlainPlace{0, 1, 0});
  const PlainPlace across = unit(sum(y, -innerProduct(x, y), x));
  return {x, across, cross(x, across)};
}

/// The coordinates of `v` along `from`, laid off along `to`.
PlainPlace rotated(const PlainPlace& v, const std::array<PlainPlace, 3>& from, const std::array<PlainPlace, 3>& to)
{
  PlainPlace result{};
  for (std::size_t k = 0; k < 3; ++k) result = sum(result, innerProduct(v, from[k]), to[k]);
  return result;
}

/// A motion p -> to + R (p - from).
struct Motion {
  PlainPlace from;
  PlainPlace to;
  std::function<PlainPlace(const PlainPlace&)> R;
};

Motion motionOf(const Json& handle, const PlainPlace& own, const std::vector<long>& fixed, const PlainMesh& rest)
{
  if (handle.contains("rotate")) {
    const Json& rotate = handle.at("rotate");
    const PlainPlace center = rotate.value("center", own);
    return {center, center,
            [axis = rotate.at("axis").get<PlainPlace>(),
             degrees = rotate.at("degrees").get<Real>()](const PlainPlace& v) { return rotated(v, axis, degrees); }};
  }
  if (handle.contains("turn")) {
    if (handle.at("turn") != "about-fixed")
      throw std::runtime_error("not to be verified: a turn " + handle.at("turn").dump());
    const PlainPlace before = sum(own, -1, centroidOf(fixed, rest));
    const PlainPlace after = sum(before, 1, handle.at("translate").get<PlainPlace>());
    return {own, own, [before, after](const PlainPlace& v) { return swung(v, before, after); }};
  }
  if (!handle.contains("frame")) return {own, own, [](const PlainPlace& v) { return v; }};
  const Json& frame = handle.at("frame");
  const Json from = frame.value("from", Json::object());
  const Json& to = frame.at("to");
  const PlainPlace origin = from.value("origin", own);
  return {origin, to.value("origin", origin),
          [a = axesOf(from), b = axesOf(to)](const PlainPlace& v) { return rotated(v, a, b); }};
}

/// `v` with its coordinates along the axes of the handle times its factors.
PlainPlace scaled(const Json& handle, const PlainPlace& v)
{
  if (!handle.contains("scale")) return v;
  const Json& scale = handle.at("scale");
  const Json frame = handle.contains("frame") ? handle.at("frame").value("from", Json::object()) : Json::object();
  const std::array<PlainPlace, 3> axes = axesOf(frame);
  PlainPlace result{};
  for (std::size_t k = 0; k < 3; ++k)
    result = sum(result, (scale.is_array() ? scale.at(k) : scale).get<Real>() * innerProduct(v, axes[k]), axes[k]);
  return result;
}

void requireKnownKeys(const Json& handle)
{
  static const std::set<std::string> kKnown{"type",      "name",  "enabled", "select",    "translate", "rotate", "turn",
                                            "turn_near", "frame", "targets", "rotations", "scale",     "rings"};
  for (const auto& entry : handle.items())
    if (!kKnown.contains(entry.key())) throw std::runtime_error("not to be verified: handles with " + entry.key());
}

}  // namespace

PlainPlace centroidOf(const std::vector<long>& vertices, const PlainMesh& rest)
{
  PlainPlace middle{};
  for (const long v : vertices)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += static_cast<Real>(rest.positions.at(v)[k]) / static_cast<Real>(vertices.size());
  return middle;
}

bool isTurned(const Json& handle)
{
  return handle.contains("rotate") || handle.contains("turn") || handle.contains("frame") || handle.contains("scale");
}

std::vector<std::pair<long, PlainPlace>> placesOfHandle(const Json& handle, const std::vector<long>& fixed,
                                                        const PlainMesh& rest)
{
  requireKnownKeys(handle);
  const Json& select = handle.at("select");
  const bool hasTargets = handle.contains("targets");
  // Targets come in the order of the ids.
  const auto vertices = hasTargets ? select.at("vertices").get<std::vector<long>>() : verticesOfPlain(handle, rest);
  const auto shift = handle.value("translate", PlainPoint{});
  std::vector<std::pair<long, PlainPlace>> places;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const PlainPoint& p = hasTargets ? handle.at("targets").at(k).get<PlainPoint>() : rest.positions.at(vertices[k]);
    places.emplace_back(vertices[k], PlainPlace{p[0], p[1], p[2]});
  }
  if (!isTurned(handle)) {
    for (auto& [vertex, place] : places)
      for (std::size_t k = 0; k < 3; ++k) place[k] = static_cast<double>(place[k]) + shift[k];
    return places;
  }
  const Motion motion = motionOf(handle, centroidOf(vertices, rest), fixed, rest);
  for (auto& [vertex, place] : places)
    place = sum(sum(motion.to, 1, {shift[0], shift[1], shift[2]}), 1,
                motion.R(scaled(handle, sum(place, -1, motion.from))));
  return places;
}

}  // namespace holdfast::test
