#include "delaunay.h"

#include <algorithm>
#include <stdexcept>

#include <Eigen/LU>

namespace holdfast::generate {
namespace {

// Points on one circle, as rows of equilateral triangles make them, count as Delaunay either way: without a margin two
// of them could flip an edge to and fro for ever. Relative to the fourth power of the lengths in the determinant.
constexpr double kInCircleMargin = 1e-9;

// Positive where d is inside the circle through a, b, c (anticlockwise), relative to the lengths involved.
double inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  Eigen::Matrix3d rows;
  for (Index i = 0; const Vector2* p : {&a, &b, &c}) {
    const Vector2 offset = *p - d;
    rows.row(i++) << offset.x(), offset.y(), offset.squaredNorm();
  }
  const double scale = std::max({rows(0, 2), rows(1, 2), rows(2, 2)});
  return rows.determinant() / (scale * scale);
}

std::pair<Index, Index> sorted(Index a, Index b)
{
  return std::minmax({a, b});
}

}  // namespace

double orientation(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const Vector2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

Vector2 circumcentre(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const Vector2 u = b - a, v = c - a;
  const Vector2 numerator(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                          u.x() * v.squaredNorm() - v.x() * u.squaredNorm());
  return a + numerator / (2 * orientation(a, b, c));
}

Delaunay::Delaunay(const std::vector<Loop>& loops)
{
  Eigen::AlignedBox2d box;
  for (const Loop& loop : loops) {
    for (const Vector2& point : loop) box.extend(point);
  }
  for (const Loop& loop : loops) points_.insert(points_.end(), loop.begin(), loop.end());
  const Index cornerCount = static_cast<Index>(points_.size());
  surround(box);
  boundaryCount_ = static_cast<Index>(points_.size());
  isInside_.assign(1, false);
  for (Index vertex = 0; vertex < cornerCount; ++vertex) {
    edges_.splitFace(findFace(points_[vertex]), vertex);
    isInside_.resize(edges_.faceCount(), false);
    std::vector<Index> suspects;
    for (const Index h : edges_.outgoing(vertex)) suspects.push_back(HalfEdges::next(h));
    legalise(suspects);
  }
  markBoundary(loops);
  markInside();
}

void Delaunay::surround(const Eigen::AlignedBox2d& box)
{
  constexpr double kFar = 20;
  const double reach = kFar * box.diagonal().norm();
  const Vector2 middle = box.center();
  const Index first = static_cast<Index>(points_.size());
  points_.push_back(middle + reach * Vector2(-1, -0.6));
  points_.push_back(middle + reach * Vector2(1, -0.6));
  points_.push_back(middle + reach * Vector2(0, 1.2));
  edges_ = HalfEdges({{first, first + 1, first + 2}}, first + 3);
}

void Delaunay::markBoundary(const std::vector<Loop>& loops)
{
  std::set<std::pair<Index, Index>> present;
  for (Index h = 0; h < edges_.halfEdgeCount(); ++h) present.insert(sorted(edges_.origin(h), edges_.target(h)));
  Index first = 0;
  for (const Loop& loop : loops) {
    const Index count = static_cast<Index>(loop.size());
    for (Index i = 0; i < count; ++i) {
      const auto edge = sorted(first + i, first + (i + 1) % count);
      if (!present.contains(edge)) throw std::logic_error("a boundary edge is not Delaunay: sample the loops finer");
      boundary_.insert(edge);
    }
    first += count;
  }
}

// Walks from the outermost face; each boundary edge crossed changes sides.
void Delaunay::markInside()
{
  std::vector<bool> isSeen(edges_.faceCount(), false);
  std::vector<Index> stack{findFace(points_[boundaryCount_ - 1])};
  isSeen[stack.back()] = true;
  while (!stack.empty()) {
    const Index face = stack.back();
    stack.pop_back();
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index neighbour = edges_.twin(h) / 3;
      if (edges_.twin(h) == HalfEdges::kNone || isSeen[neighbour]) continue;
      isSeen[neighbour] = true;
      isInside_[neighbour] = isInside_[face] != isBoundary(h);
      stack.push_back(neighbour);
    }
  }
}

bool Delaunay::isBoundary(Index halfEdge) const
{
  return boundary_.contains(sorted(edges_.origin(halfEdge), edges_.target(halfEdge)));
}

// The face whose smallest signed area towards the point is largest: never fails, whatever rounding does. Linear in the
// number of faces, which the small regions here can afford.
Index Delaunay::findFace(const Vector2& point) const
{
  Index best = 0;
  double bestArea = -std::numeric_limits<double>::infinity();
  for (Index face = 0; face < edges_.faceCount(); ++face) {
    const auto [a, b, c] = edges_.corners(face);
    const double area =
        std::min({orientation(points_[a], points_[b], point), orientation(points_[b], points_[c], point),
                  orientation(points_[c], points_[a], point)});
    if (area > bestArea) {
      bestArea = area;
      best = face;
    }
    if (area >= 0) break;
  }
  return best;
}

Index Delaunay::locate(const Vector2& point) const
{
  const Index face = findFace(point);
  return isInside_[face] ? face : HalfEdges::kNone;
}

Index Delaunay::insert(const Vector2& point)
{
  const Index face = findFace(point);
  points_.push_back(point);
  const Index vertex = edges_.addVertex();
  edges_.splitFace(face, vertex);
  isInside_.resize(edges_.faceCount(), true);
  std::vector<Index> suspects;
  for (const Index h : edges_.outgoing(vertex)) suspects.push_back(HalfEdges::next(h));
  legalise(suspects);
  return vertex;
}

void Delaunay::restore()
{
  std::vector<Index> all;
  for (Index h = 0; h < edges_.halfEdgeCount(); ++h) all.push_back(h);
  legalise(all);
}

bool Delaunay::shouldFlip(Index halfEdge) const
{
  const Index twin = edges_.twin(halfEdge);
  if (twin == HalfEdges::kNone || isBoundary(halfEdge)) return false;
  return inCircle(points_[edges_.origin(halfEdge)], points_[edges_.target(halfEdge)], points_[edges_.apex(halfEdge)],
                  points_[edges_.apex(twin)]) > kInCircleMargin;
}

void Delaunay::legalise(std::vector<Index> suspects)
{
  while (!suspects.empty()) {
    const Index h = suspects.back();
    suspects.pop_back();
    if (!shouldFlip(h)) continue;
    const Index t = edges_.twin(h);
    edges_.flip(h);
    for (const Index side : {HalfEdges::next(h), HalfEdges::previous(h), HalfEdges::next(t), HalfEdges::previous(t)}) {
      suspects.push_back(side);
    }
  }
}

std::vector<Triangle> Delaunay::insideTriangles() const
{
  std::vector<Triangle> result;
  for (Index face = 0; face < edges_.faceCount(); ++face) {
    if (isInside_[face]) result.push_back(edges_.corners(face));
  }
  return result;
}

}  // namespace holdfast::generate
