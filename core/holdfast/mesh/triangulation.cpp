#include "holdfast/mesh/triangulation.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include <Eigen/Geometry>

namespace holdfast {
namespace {

using Place2 = Eigen::Vector2d;
using Box = Eigen::AlignedBox2d;

// What rounding may do to places within the unit square and to their cross products, generously.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

double cross(const Place2& a, const Place2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// The polygon's normal by Newell's sum: twice its vector area.
Vector3 vectorArea(const std::vector<Vector3>& polygon)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
  return sum;
}

/// The polygon seen against its normal, which is not zero.
std::vector<Place2> projected(const std::vector<Vector3>& polygon, const Vector3& normal)
{
  const Vector3 x = normal.normalized().unitOrthogonal();
  const Vector3 y = normal.normalized().cross(x);
  std::vector<Place2> places;
  places.reserve(polygon.size());
  for (const Vector3& corner : polygon) places.emplace_back(corner.dot(x), corner.dot(y));
  return places;
}

/// A tree of boxes around corners, halved across their longer side again and again. Corners can be taken out.
class CornerBoxes {
 public:
  explicit CornerBoxes(const std::vector<Place2>& places)
      : boxes_(2 * std::bit_ceil(places.size())), cornerOf_(boxes_.size(), kNoCorner), nodeOf_(places.size())
  {
    std::vector<Index> corners(places.size());
    std::iota(corners.begin(), corners.end(), Index{0});
    build(1, corners, places);
  }

  void remove(Index corner)
  {
    std::size_t node = nodeOf_[corner];
    boxes_[node].setEmpty();
    for (node /= 2; node > 0; node /= 2) boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
  }

  /// Calls `take(corner)` for corners in boxes of which `mayMatter(box)` is true, until it returns true.
  bool find(const auto& mayMatter, const auto& take, std::size_t node = 1) const
  {
    if (boxes_[node].isEmpty() || !mayMatter(boxes_[node])) return false;
    if (cornerOf_[node] != kNoCorner) return take(cornerOf_[node]);
    return find(mayMatter, take, 2 * node) || find(mayMatter, take, 2 * node + 1);
  }

 private:
  static constexpr Index kNoCorner = -1;

  void build(std::size_t node, std::span<Index> corners, const std::vector<Place2>& places)
  {
    for (const Index corner : corners) boxes_[node].extend(places[corner]);
    if (corners.size() == 1) {
      cornerOf_[node] = corners[0];
      nodeOf_[corners[0]] = node;
      return;
    }
    const Place2 size = boxes_[node].sizes();
    const int longer = size.x() < size.y() ? 1 : 0;
    const std::size_t half = corners.size() / 2;
    const auto key = [&](Index corner) { return std::pair(places[corner][longer], corner); };
    std::ranges::nth_element(corners, corners.begin() + static_cast<std::ptrdiff_t>(half), {}, key);
    build(2 * node, corners.first(half), places);
    build(2 * node + 1, corners.subspan(half), places);
  }

  std::vector<Box> boxes_;  // the root is 1, those below k are 2 k and 2 k + 1
  std::vector<Index> cornerOf_;
  std::vector<std::size_t> nodeOf_;
};

/// The region of the corners that count against an ear a, b, c: between the rays from b through a and c, and less than
/// `depth` behind the line through both (a cross product with c - a).
class EarRegion {
 public:
  EarRegion(const Place2& a, const Place2& b, const Place2& c, double depth) : a_(a), b_(b), c_(c), depth_(depth)
  {
    // The region is the ear scaled from b. Of flat ears rounding makes the scale uncertain.
    constexpr double kMargin = 1.01;
    constexpr double kLargestScale = 1e5;
    const double twiceArea = cross(b - a, c - a);
    const double scale = kMargin * (1 + depth / twiceArea);
    if (!(twiceArea > 0 && scale < kLargestScale)) return;
    box_ = Box(b).extend(b + scale * (a - b)).extend(b + scale * (c - b));
    box_ = Box(box_.min().array() - kRounding, box_.max().array() + kRounding);
  }

  [[nodiscard]] bool mayMeet(const Box& box) const
  {
    return box_.intersects(box) && most(a_, b_, box) > 0 && most(b_, c_, box) > 0 && -most(c_, a_, box) < depth_;
  }

 private:
  /// The largest cross product of `to` - `from` with a place in the box, seen from `from`; rather too large.
  static double most(const Place2& from, const Place2& to, const Box& box)
  {
    const Place2 across(from.y() - to.y(), to.x() - from.x());
    return across.dot(box.center() - from) + across.cwiseAbs().dot(box.sizes()) / 2 + kRounding;
  }

  Place2 a_;
  Place2 b_;
  Place2 c_;
  double depth_;
  Box box_{Place2::Constant(-std::numeric_limits<double>::infinity()),
           Place2::Constant(std::numeric_limits<double>::infinity())};
};

/// Cuts ears off one polygon without a coordinate beyond 1: the best shaped first, of equals the one at the first
/// corner. O(n log n) where ears hold few corners of others, as in polygons that do not wind about themselves.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Vector3> polygon)
      : polygon_(std::move(polygon)),
        normal_(vectorArea(polygon_)),
        hasArea_(normal_.squaredNorm() > 0),
        count_(static_cast<Index>(polygon_.size())),
        before_(polygon_.size()),
        behind_(polygon_.size()),
        quality_(polygon_.size())
  {
    for (Index k = 0; k < count_; ++k) {
      before_[k] = k == 0 ? count_ - 1 : k - 1;
      behind_[k] = k + 1 == count_ ? 0 : k + 1;
    }
    if (count_ < kFew || !hasArea_) return;
    places_ = projected(polygon_, normal_);
    boxes_.emplace(places_);
  }

  std::vector<std::array<Index, 3>> run()
  {
    for (Index k = 0; k < static_cast<Index>(polygon_.size()); ++k) classify(k);
    std::vector<std::array<Index, 3>> ears;
    ears.reserve(polygon_.size() - 2);
    while (count_ > 3) {
      const Index k = bestEar();
      ears.push_back(ear(k));
      cut(k);
    }
    ears.push_back({first_, behind_[first_], behind_[behind_[first_]]});
    return ears;
  }

 private:
  static constexpr double kNotAnEar = -1;
  static constexpr double kCut = -2;
  // A triangle of this height over its longest side has angles of about two degrees.
  static constexpr double kNeedle = 0.02;
  // Fewer corners are looked through faster than a tree of boxes.
  static constexpr Index kFew = 32;

  [[nodiscard]] std::array<Index, 3> ear(Index k) const { return {before_[k], k, behind_[k]}; }

  /// Area over the sum of squared edges, signed by the polygon's side: largest for the equilateral triangle. The
  /// triangle left behind counts too, which for a quadrilateral makes the choice of the diagonal symmetric.
  [[nodiscard]] double shape(Index a, Index b, Index c) const
  {
    const Vector3 ab = polygon_[b] - polygon_[a];
    const Vector3 ac = polygon_[c] - polygon_[a];
    const double squares = ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm();
    const double twiceArea = ab.cross(ac).dot(normal_);
    return squares > 0 && hasArea_ ? twiceArea / (squares * normal_.norm()) : 0;
  }

  [[nodiscard]] double quality(Index k) const
  {
    const auto [a, b, c] = ear(k);
    const double own = shape(a, b, c);
    if (own < 0) return kNotAnEar;
    const double gap = gapBehind(a, b, c);
    if (gap < 0) return kNotAnEar;
    if (count_ == 4) {
      const double other = shape(a, c, behind_[c]);
      return other < 0 ? kNotAnEar : std::min(own, other);
    }
    // A corner that all but touches the cut makes a needle with it: such an ear waits until there is no other.
    return gap < kNeedle ? own * kNeedle : own;
  }

  /// How far behind the cut from a to c the corners are that the ear's two sides have between them, as a share of the
  /// cut's length: negative where the ear holds a corner, else below `kNeedle` where one is as near as that.
  [[nodiscard]] double gapBehind(Index a, Index b, Index c) const
  {
    double gap = std::numeric_limits<double>::infinity();
    // True where no other corner can say more: the ear holds this one.
    const auto take = [&](Index p) {
      gap = std::min(gap, gapTo(p, a, b, c));
      return gap < 0;
    };
    if (count_ < kFew || !boxes_) {
      for (Index p = behind_[c]; p != a; p = behind_[p]) take(p);
      return gap;
    }
    const auto region = [&](double depth) {
      return EarRegion(places_[a], places_[b], places_[c], depth * (polygon_[c] - polygon_[a]).squaredNorm());
    };
    const auto mayMatter = [&, ear = region(0), needle = region(kNeedle)](const Box& box) {
      return (gap < kNeedle ? ear : needle).mayMeet(box);
    };
    // Along smooth curves the next corners are near the cut. They are far fewer than a search would go through.
    if (!take(behind_[c]) && !take(before_[a])) boxes_->find(mayMatter, take);
    return gap;
  }

  /// The same of one corner; infinite where the two sides do not have it between them.
  [[nodiscard]] double gapTo(Index p, Index a, Index b, Index c) const
  {
    const bool isBetween = p != a && p != b && p != c && shape(a, b, p) > 0 && shape(b, c, p) > 0;
    return isBetween ? height(a, c, p) : std::numeric_limits<double>::infinity();
  }

  /// Height of the triangle over its side ab as a share of that, signed by the polygon's side; the polygon has an area.
  [[nodiscard]] double height(Index a, Index b, Index c) const
  {
    const Vector3 ab = polygon_[b] - polygon_[a];
    if (ab.isZero(0)) return std::numeric_limits<double>::infinity();
    return ab.cross(polygon_[c] - polygon_[a]).dot(normal_) / (ab.squaredNorm() * normal_.norm());
  }

  void classify(Index k)
  {
    quality_[k] = quality(k);
    ears_.emplace(quality_[k], -k);
  }

  [[nodiscard]] Index bestEar()
  {
    for (;;) {
      const auto [quality, minusCorner] = ears_.top();
      ears_.pop();
      // The last quality of an ear counts.
      if (quality_[-minusCorner] == quality) return -minusCorner;
    }
  }

  void cut(Index k)
  {
    const auto [a, b, c] = ear(k);
    behind_[a] = c;
    before_[c] = a;
    quality_[b] = kCut;
    if (b == first_) first_ = c;
    if (boxes_) boxes_->remove(b);
    --count_;
    classify(a);
    classify(c);
    if (count_ != 4) return;
    classify(behind_[c]);
    classify(behind_[behind_[c]]);
  }

  std::vector<Vector3> polygon_;
  Vector3 normal_;
  bool hasArea_;
  std::vector<Place2> places_;        // of the corners, in the plane; empty where there are few
  std::optional<CornerBoxes> boxes_;  // of the corners still there; none where there are few
  Index first_ = 0;                   // the first corner still there
  Index count_;                       // how many are
  std::vector<Index> before_;         // each of them knows its neighbours
  std::vector<Index> behind_;
  std::vector<double> quality_;                         // of the ear at each corner
  std::priority_queue<std::pair<double, Index>> ears_;  // qualities and corners times -1
};

/// The corners seen from the first one, no coordinate beyond 1: products of areas stay within the range of doubles.
std::vector<Vector3> inUnitsOfItsSize(const Positions& positions, std::span<const int> face)
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

std::vector<std::array<Index, 3>> cornersOfTriangles(const Positions& positions, std::span<const int> face)
{
  if (face.size() < 3) return {};
  if (face.size() == 3) return {{0, 1, 2}};
  return EarClipper(inUnitsOfItsSize(positions, face)).run();
}

}  // namespace

Triangulation triangulate(const Mesh& mesh)
{
  Triangulation result;
  std::size_t expected = 0;
  bool areTriangles = true;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const std::size_t corners = mesh.faces[f].size();
    expected += corners < 3 ? 0 : corners - 2;
    areTriangles = areTriangles && corners <= 3;
  }
  result.triangles.reserve(expected);
  if (!areTriangles) result.corners.reserve(expected);
  result.faceOf.reserve(expected);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto face = mesh.faces[f];
    for (const auto& corners : cornersOfTriangles(mesh.positions, face)) {
      result.triangles.push_back({face[corners[0]], face[corners[1]], face[corners[2]]});
      if (!areTriangles) result.corners.push_back(corners);
      result.faceOf.push_back(static_cast<int>(f));
    }
  }
  return result;
}

}  // namespace holdfast
