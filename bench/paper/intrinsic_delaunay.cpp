#include "bench/paper/intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace holdfast::paper {
namespace {

// A sum of cotangents above this share of their size is rounding of zero.
constexpr double kRounding = 1e-12;

/// A side of a triangle; of no triangle where `triangle` is negative.
struct Side {
  Index triangle = -1;
  int side = 0;
};

class Flipper {
 public:
  explicit Flipper(IntrinsicTriangles mesh) : mesh_(std::move(mesh)), across_(mesh_.triangles.size()) { tie(); }

  [[nodiscard]] IntrinsicTriangles flipped() &&
  {
    std::vector<Side> queue;
    for (Index t = 0; t < static_cast<Index>(across_.size()); ++t)
      for (int k = 0; k < 3; ++k) queue.push_back({t, k});
    while (!queue.empty()) {
      const Side side = queue.back();
      queue.pop_back();
      if (isDelaunay(side)) continue;
      const Side other = across_[side.triangle][side.side];
      flip(side, other);
      for (int k = 1; k < 3; ++k) {
        queue.push_back({side.triangle, k});
        queue.push_back({other.triangle, k});
      }
    }
    return std::move(mesh_);
  }

 private:
  /// Finds what lies across each side; nothing across those that one or more than two triangles have.
  void tie()
  {
    std::map<std::pair<Index, Index>, std::vector<Side>> sidesOf;
    for (Index t = 0; t < static_cast<Index>(across_.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        const Triangle& corners = mesh_.triangles[t];
        sidesOf[std::minmax({Index(corners[k]), Index(corners[(k + 1) % 3])})].push_back({t, k});
      }
    for (const auto& [ends, sides] : sidesOf)
      if (sides.size() == 2) tie(sides[0], sides[1]);
  }

  void tie(const Side& a, const Side& b)
  {
    if (a.triangle >= 0) across_[a.triangle][a.side] = b;
    if (b.triangle >= 0) across_[b.triangle][b.side] = a;
  }

  [[nodiscard]] bool isDelaunay(const Side& side) const
  {
    const Side other = across_[side.triangle][side.side];
    if (other.triangle < 0 || other.triangle == side.triangle) return true;
    const double a = cotangents(mesh_.lengths[side.triangle])[(side.side + 2) % 3];
    const double b = cotangents(mesh_.lengths[other.triangle])[(other.side + 2) % 3];
    return !(a + b < -kRounding * (std::abs(a) + std::abs(b)));
  }

  /// The edge from a to b, with c across in its triangle and d in the other one, becomes the first side of (d, c, a)
  /// and of (c, d, b).
  void flip(const Side& side, const Side& other)
  {
    const auto corner = [&](const Side& s, int k) { return mesh_.triangles[s.triangle][(s.side + k) % 3]; };
    const auto length = [&](const Side& s, int k) { return mesh_.lengths[s.triangle][(s.side + k) % 3]; };
    const auto beyond = [&](const Side& s, int k) { return across_[s.triangle][(s.side + k) % 3]; };
    const auto [a, b, c, d] = std::array{corner(side, 0), corner(side, 1), corner(side, 2), corner(other, 2)};
    const auto [ab, bc, ca] = std::array{length(side, 0), length(side, 1), length(side, 2)};
    const auto [ad, db] = std::array{length(other, 1), length(other, 2)};
    const auto [beyondBc, beyondCa] = std::array{beyond(side, 1), beyond(side, 2)};
    const auto [beyondAd, beyondDb] = std::array{beyond(other, 1), beyond(other, 2)};
    const double along = (ca * ca - bc * bc - ad * ad + db * db) / (2 * ab);
    const double apart = 2 * (area({ab, bc, ca}) + area({ab, ad, db})) / ab;
    const double cd = std::hypot(along, apart);
    mesh_.triangles[side.triangle] = {d, c, a};
    mesh_.lengths[side.triangle] = {cd, ca, ad};
    mesh_.triangles[other.triangle] = {c, d, b};
    mesh_.lengths[other.triangle] = {cd, db, bc};
    tie({side.triangle, 0}, {other.triangle, 0});
    tie({side.triangle, 1}, beyondCa);
    tie({side.triangle, 2}, beyondAd);
    tie({other.triangle, 1}, beyondDb);
    tie({other.triangle, 2}, beyondBc);
  }

  IntrinsicTriangles mesh_;
  std::vector<std::array<Side, 3>> across_;
};

}  // namespace

IntrinsicTriangles intrinsicTriangles(const Positions& positions, std::vector<Triangle> triangles)
{
  IntrinsicTriangles mesh{std::move(triangles), {}};
  for (const Triangle& t : mesh.triangles) {
    const auto length = [&](int k) { return (positions.row(t[k]) - positions.row(t[(k + 1) % 3])).norm(); };
    mesh.lengths.push_back({length(0), length(1), length(2)});
  }
  return mesh;
}

IntrinsicTriangles delaunay(IntrinsicTriangles mesh)
{
  return Flipper(std::move(mesh)).flipped();
}

double area(const std::array<double, 3>& lengths)
{
  auto [c, b, a] = lengths;
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  return std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)))) / 4;
}

CornerCotangents cotangents(const std::array<double, 3>& lengths)
{
  const double fourAreas = 4 * area(lengths);
  CornerCotangents result{};
  for (int k = 0; k < 3; ++k) {
    const auto [next, across, previous] = std::array{lengths[k], lengths[(k + 1) % 3], lengths[(k + 2) % 3]};
    result[k] = (next * next + previous * previous - across * across) / fourAreas;
  }
  return result;
}

}  // namespace holdfast::paper
