#include "support/plain_selection.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "support/plain_curve.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using Real = long double;
using Place = std::array<Real, 3>;

Place minus(const Place& a, const Place& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Real dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Place placeOf(const PlainPoint& point)
{
  return {point[0], point[1], point[2]};
}

/// The number of each vertex's part, by flooding along faces until nothing changes; -1 where no face uses it.
std::vector<long> partsOf(const PlainMesh& mesh)
{
  std::vector<long> lowest(mesh.positions.size(), -1);
  for (const auto& face : mesh.faces)
    for (const long v : face) lowest[v] = v;
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (const auto& face : mesh.faces) {
      long least = std::numeric_limits<long>::max();
      for (const long v : face) least = std::min(least, lowest[v]);
      for (const long v : face) hasChanged |= std::exchange(lowest[v], least) != least;
    }
  }
  std::set<long> roots(lowest.begin(), lowest.end());
  roots.erase(-1);
  for (long& part : lowest)
    if (part >= 0) part = std::distance(roots.begin(), roots.find(part));
  return lowest;
}

bool isInBox(const Json& box, const PlainPoint& p)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < box.at("min").at(k).get<double>() || p[k] > box.at("max").at(k).get<double>()) return false;
  return true;
}

/// Evaluates selections; finds parts once, when a selection asks for them.
class Selector {
 public:
  explicit Selector(const PlainMesh& mesh) : mesh_(mesh) {}

  bool selects(const Json& selection, long v)
  {
    const std::string& kind = selection.begin().key();
    const Json& value = selection.begin().value();
    const auto selectsIt = [&](const Json& part) { return selects(part, v); };
    const PlainPoint& p = mesh_.positions[v];
    if (kind == "vertices") return std::find(value.begin(), value.end(), v) != value.end();
    if (kind == "box") return isInBox(value, p);
    if (kind == "sphere") {
      const Place offset = minus(placeOf(p), value.at("center").get<Place>());
      return dot(offset, offset) <= value.at("radius").get<Real>() * value.at("radius").get<Real>();
    }
    if (kind == "halfspace")
      return dot(minus(placeOf(p), value.at("point").get<Place>()), value.at("normal").get<Place>()) >= 0;
    if (kind == "curve") return inside(value).contains(v);
    if (kind == "component") return partOf(v) == value.get<long>();
    if (kind == "all") return std::all_of(value.begin(), value.end(), selectsIt);
    if (kind == "any") return std::any_of(value.begin(), value.end(), selectsIt);
    if (kind == "not") return !selectsIt(value);
    if (kind == "grown") return grown(value).contains(v);
    throw std::runtime_error("unknown selection " + kind);
  }

 private:
  long partOf(long v)
  {
    if (parts_.empty()) parts_ = partsOf(mesh_);
    return parts_[v];
  }

  /// Ring by ring: all corners of triangles that have one in the set.
  const std::set<long>& grown(const Json& value)
  {
    const auto [found, isNew] = sets_.try_emplace(value.dump());
    if (!isNew) return found->second;
    std::set<long> vertices;
    for (long v = 0; v < static_cast<long>(mesh_.positions.size()); ++v)
      if (selects(value.at("select"), v)) vertices.insert(v);
    for (long ring = 0; ring < value.at("rings").get<long>(); ++ring) {
      const std::set<long> before = vertices;
      for (const auto& face : mesh_.faces)
        if (std::ranges::any_of(face, [&](long v) { return before.contains(v); }))
          vertices.insert(face.begin(), face.end());
    }
    return found->second = std::move(vertices);
  }

  const std::set<long>& inside(const Json& curve)
  {
    const auto [found, isNew] = sets_.try_emplace(curve.dump());
    if (isNew) found->second = insidePlain(curve, mesh_);
    return found->second;
  }

  const PlainMesh& mesh_;
  std::vector<long> parts_;
  std::map<std::string, std::set<long>> sets_;  // of curves and rings, by their text
};

/// Weight t of b on the segment a b where it is closest to p.
Real alongSegment(const Place& a, const Place& b, const Place& p)
{
  const Place d = minus(b, a);
  const Real length = dot(d, d);
  return length > 0 ? std::clamp(dot(minus(p, a), d) / length, Real{0}, Real{1}) : Real{0};
}

using BarycentricWeights = std::array<Real, 3>;
using CornerPlaces = std::array<Place, 3>;

Real squaredDistance(const CornerPlaces& corners, const BarycentricWeights& weights, const Place& p)
{
  Place offset = p;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) offset[i] -= weights[k] * corners[k][i];
  return dot(offset, offset);
}

/// The foot of the perpendicular by Cramer's rule where it lies inside, and otherwise the best point of the three
/// sides.
BarycentricWeights nearestOfTriangle(const CornerPlaces& corners, const Place& p)
{
  const Place u = minus(corners[1], corners[0]);
  const Place v = minus(corners[2], corners[0]);
  const Place w = minus(p, corners[0]);
  const Real determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  if (determinant > 0) {
    const Real s = (dot(v, v) * dot(u, w) - dot(u, v) * dot(v, w)) / determinant;
    const Real t = (dot(u, u) * dot(v, w) - dot(u, v) * dot(u, w)) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) return {1 - s - t, s, t};
  }
  BarycentricWeights best{1, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    BarycentricWeights side{};
    side[(k + 1) % 3] = alongSegment(corners[k], corners[(k + 1) % 3], p);
    side[k] = 1 - side[(k + 1) % 3];
    if (squaredDistance(corners, side, p) < squaredDistance(corners, best, p)) best = side;
  }
  return best;
}

}  // namespace

std::vector<long> selectPlain(const nlohmann::json& selection, const PlainMesh& mesh)
{
  Selector selector(mesh);
  std::vector<long> vertices;
  for (long v = 0; v < static_cast<long>(mesh.positions.size()); ++v)
    if (selector.selects(selection, v)) vertices.push_back(v);
  return vertices;
}

std::vector<long> verticesOfPlain(const nlohmann::json& constraint, const PlainMesh& mesh)
{
  if (!constraint.contains("rings")) return selectPlain(constraint.at("select"), mesh);
  return selectPlain({{"grown", {{"select", constraint.at("select")}, {"rings", constraint.at("rings")}}}}, mesh);
}

std::pair<std::array<long, 3>, std::array<long double, 3>> nearestPlain(const PlainMesh& mesh, const PlainPoint& place)
{
  std::pair<std::array<long, 3>, BarycentricWeights> best;
  Real least = std::numeric_limits<Real>::infinity();
  for (const auto& face : mesh.faces) {
    if (face.size() != 3) throw std::runtime_error("nearest points are found on triangles only");
    const std::array<long, 3> ids{face[0], face[1], face[2]};
    const CornerPlaces corners{placeOf(mesh.positions[ids[0]]), placeOf(mesh.positions[ids[1]]),
                               placeOf(mesh.positions[ids[2]])};
    const BarycentricWeights weights = nearestOfTriangle(corners, placeOf(place));
    const Real distance = squaredDistance(corners, weights, placeOf(place));
    if (distance >= least) continue;
    least = distance;
    best = {ids, weights};
  }
  return best;
}

}  // namespace holdfast::test
