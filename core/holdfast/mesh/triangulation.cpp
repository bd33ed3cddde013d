#include "holdfast/mesh/triangulation.h"

#include <algorithm>
#include <limits>
#include <span>

#include <Eigen/Geometry>

namespace holdfast {
namespace {

/// The polygon's normal by Newell's sum: twice its vector area.
Vector3 vectorArea(const std::vector<Vector3>& polygon)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
  return sum;
}

/// Cuts ears off one polygon, the best shaped first.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Vector3> polygon)
      : polygon_(std::move(polygon)), normal_(vectorArea(polygon_)), rim_(polygon_.size()), quality_(polygon_.size())
  {
    for (std::size_t i = 0; i < rim_.size(); ++i) rim_[i] = static_cast<Index>(i);
  }

  std::vector<std::array<Index, 3>> run()
  {
    for (std::size_t k = 0; k < rim_.size(); ++k) quality_[k] = quality(k);
    std::vector<std::array<Index, 3>> ears;
    while (rim_.size() > 3) {
      const std::size_t k = bestEar();
      ears.push_back(ear(k));
      cut(k);
    }
    ears.push_back({rim_[0], rim_[1], rim_[2]});
    return ears;
  }

 private:
  static constexpr double kNotAnEar = -1;
  // A triangle of this height over its longest side has angles of about two degrees.
  static constexpr double kNeedle = 0.02;

  [[nodiscard]] std::array<Index, 3> ear(std::size_t k) const
  {
    const std::size_t n = rim_.size();
    return {rim_[(k + n - 1) % n], rim_[k], rim_[(k + 1) % n]};
  }

  /// Area over the sum of squared edges, signed by the polygon's side: largest for the equilateral triangle. The
  /// triangle left behind counts too, which for a quadrilateral makes the choice of the diagonal symmetric.
  [[nodiscard]] double shape(Index a, Index b, Index c) const
  {
    const Vector3 ab = polygon_[b] - polygon_[a];
    const Vector3 ac = polygon_[c] - polygon_[a];
    const double squares = ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm();
    const double twiceArea = ab.cross(ac).dot(normal_);
    return squares > 0 && normal_.squaredNorm() > 0 ? twiceArea / (squares * normal_.norm()) : 0;
  }

  [[nodiscard]] double quality(std::size_t k) const
  {
    const auto [a, b, c] = ear(k);
    const double own = shape(a, b, c);
    const double gap = gapBehind(a, b, c);
    if (own < 0 || gap < 0) return kNotAnEar;
    if (rim_.size() == 4) {
      const double other = shape(a, c, rim_[(k + 2) % 4]);
      return other < 0 ? kNotAnEar : std::min(own, other);
    }
    // A corner that all but touches the cut makes a needle with it: such an ear waits until there is no other.
    return gap < kNeedle ? own * kNeedle : own;
  }

  /// How far behind the cut from a to c the nearest corner is that the ear's two sides have between them, as a share of
  /// the cut's length; negative where the ear holds a corner.
  [[nodiscard]] double gapBehind(Index a, Index b, Index c) const
  {
    double gap = std::numeric_limits<double>::infinity();
    for (const Index p : rim_)
      if (p != a && p != b && p != c && shape(a, b, p) > 0 && shape(b, c, p) > 0) gap = std::min(gap, height(a, c, p));
    return gap;
  }

  /// Height of the triangle over its side ab as a share of that, signed by the polygon's side; the polygon has an area.
  [[nodiscard]] double height(Index a, Index b, Index c) const
  {
    const Vector3 ab = polygon_[b] - polygon_[a];
    if (ab.isZero(0)) return std::numeric_limits<double>::infinity();
    return ab.cross(polygon_[c] - polygon_[a]).dot(normal_) / (ab.squaredNorm() * normal_.norm());
  }

  [[nodiscard]] std::size_t bestEar() const
  {
    return static_cast<std::size_t>(std::max_element(quality_.begin(), quality_.end()) - quality_.begin());
  }

  void cut(std::size_t k)
  {
    rim_.erase(rim_.begin() + static_cast<std::ptrdiff_t>(k));
    quality_.erase(quality_.begin() + static_cast<std::ptrdiff_t>(k));
    const std::size_t n = rim_.size();
    for (const std::size_t neighbour : {(k + n - 1) % n, k % n}) quality_[neighbour] = quality(neighbour);
    if (n == 4)
      for (std::size_t i = 0; i < n; ++i) quality_[i] = quality(i);
  }

  std::vector<Vector3> polygon_;
  Vector3 normal_;
  std::vector<Index> rim_;       // corner numbers still there
  std::vector<double> quality_;  // of the ear at each corner still there
};

/// The corners seen from the first one, no coordinate beyond 1: products of areas stay within the range of doubles.
std::vector<Vector3> inUnitsOfItsSize(const Positions& positions, std::span<const Index> face)
{
  std::vector<Vector3> polygon;
  polygon.reserve(face.size());
  double size = 0;
  for (const Index v : face) {
    polygon.emplace_back(positions.row(v) - positions.row(face[0]));
    size = std::max(size, polygon.back().cwiseAbs().maxCoeff());
  }
  if (size > 0)
    for (Vector3& corner : polygon) corner /= size;
  return polygon;
}

std::vector<std::array<Index, 3>> cornersOfTriangles(const Positions& positions, std::span<const Index> face)
{
  if (face.size() == 3) return {{0, 1, 2}};
  return EarClipper(inUnitsOfItsSize(positions, face)).run();
}

}  // namespace

Triangulation triangulate(const Mesh& mesh)
{
  Triangulation result;
  const auto expected = static_cast<std::size_t>(mesh.faces.cornerCount() - 2 * mesh.faces.size());
  result.triangles.reserve(expected);
  result.corners.reserve(expected);
  result.faceOf.reserve(expected);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto face = mesh.faces[f];
    for (const auto& corners : cornersOfTriangles(mesh.positions, face)) {
      result.triangles.push_back({face[corners[0]], face[corners[1]], face[corners[2]]});
      result.corners.push_back(corners);
      result.faceOf.push_back(f);
    }
  }
  return result;
}

}  // namespace holdfast
