#include "support/plain_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/plain_selection.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using Real = long double;
using Place = std::array<Real, 3>;

/// The vertices that edges join to each.
std::vector<std::set<long>> neighboursOf(const PlainMesh& mesh)
{
  std::vector<std::set<long>> neighbours(mesh.positions.size());
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k) {
      const long v = face[k];
      const long w = face[(k + 1) % face.size()];
      neighbours[v].insert(w);
      neighbours[w].insert(v);
    }
  return neighbours;
}

class CurveInside {
 public:
  explicit CurveInside(const PlainMesh& mesh) : mesh_(mesh), neighbours_(neighboursOf(mesh)) {}

  [[nodiscard]] std::set<long> select(const Json& curve) const
  {
    std::vector<long> places;
    for (const Json& place : curve.at("through")) places.push_back(nearestVertex(place.at("near").get<PlainPoint>()));
    std::set<long> onCurve;
    for (std::size_t k = 0; k < places.size(); ++k) addPath(places[k], places[(k + 1) % places.size()], onCurve);
    std::set<long> side = smallerSide(onCurve);
    side.insert(onCurve.begin(), onCurve.end());
    return side;
  }

 private:
  [[nodiscard]] Real distance(long v, const Place& place) const
  {
    const auto& [x, y, z] = mesh_.positions[v];
    return std::hypot(x - place[0], y - place[1], z - place[2]);
  }

  [[nodiscard]] Real length(long v, long w) const
  {
    const auto& [x, y, z] = mesh_.positions[w];
    return distance(v, {x, y, z});
  }

  /// Of the corners of the nearest face the one nearest to its nearest point.
  [[nodiscard]] long nearestVertex(const PlainPoint& place) const
  {
    const auto [corners, weights] = nearestPlain(mesh_, place);
    Place foot{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) foot[i] += weights[k] * mesh_.positions[corners[k]][i];
    const auto isNearer = [&](long v, long w) { return distance(v, foot) < distance(w, foot); };
    return *std::min_element(corners.begin(), corners.end(), isNearer);
  }

  /// Ends of edges are relaxed until nothing is any nearer.
  void addPath(long from, long to, std::set<long>& path) const
  {
    std::vector<Real> far(mesh_.positions.size(), std::numeric_limits<Real>::infinity());
    std::vector<long> before(mesh_.positions.size(), -1);
    far[to] = 0;
    for (std::set<long> changed{to}; !changed.empty();) {
      const long v = *changed.begin();
      changed.erase(changed.begin());
      for (const long w : neighbours_[v])
        if (const Real way = far[v] + length(v, w); way < far[w] && way < far[from]) {
          far[w] = way;
          before[w] = v;
          changed.insert(w);
        }
    }
    for (long v = from; v != -1; v = before[v]) path.insert(v);
  }

  /// Of the two pieces that are left when the curve is taken out.
  [[nodiscard]] std::set<long> smallerSide(const std::set<long>& onCurve) const
  {
    std::set<long> smaller;
    std::set<long> seen = onCurve;
    for (const long start : std::set<long>(neighbours_[*onCurve.begin()]))
      if (!seen.contains(start)) {
        const std::set<long> piece = flood(start, seen);
        if (smaller.empty() || piece.size() < smaller.size()) smaller = piece;
      }
    return smaller;
  }

  std::set<long> flood(long start, std::set<long>& seen) const
  {
    std::set<long> piece;
    for (std::vector<long> open{start}; !open.empty();) {
      const long v = open.back();
      open.pop_back();
      if (!seen.insert(v).second) continue;
      piece.insert(v);
      open.insert(open.end(), neighbours_[v].begin(), neighbours_[v].end());
    }
    return piece;
  }

  const PlainMesh& mesh_;
  std::vector<std::set<long>> neighbours_;
};

}  // namespace

std::set<long> insidePlain(const nlohmann::json& curve, const PlainMesh& mesh)
{
  return CurveInside(mesh).select(curve);
}

}  // namespace holdfast::test
