#include "holdfast/surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace holdfast {

namespace {

/// Sorted by vertex, the weights of each vertex added up.
std::vector<PointTerm> merged(std::vector<PointTerm> terms)
{
  std::sort(terms.begin(), terms.end(), [](const PointTerm& x, const PointTerm& y) { return x.vertex < y.vertex; });
  std::vector<PointTerm> sums;
  for (const PointTerm& term : terms)
    if (!sums.empty() && sums.back().vertex == term.vertex)
      sums.back().weight += term.weight;
    else
      sums.push_back(term);
  return sums;
}

/// The terms of both, weighted.
std::vector<PointTerm> combined(const SurfacePoint& x, double ofX, const SurfacePoint& y, double ofY)
{
  std::vector<PointTerm> terms;
  for (const PointTerm& term : x.terms) terms.push_back({term.vertex, ofX * term.weight});
  for (const PointTerm& term : y.terms) terms.push_back({term.vertex, ofY * term.weight});
  return terms;
}

}  // namespace

SurfacePoint canonical(std::vector<PointTerm> terms)
{
  SurfacePoint point{merged(std::move(terms))};
  std::erase_if(point.terms, [](const PointTerm& term) { return term.weight <= kVanishingWeight; });
  if (point.terms.size() == 1) point.terms.front().weight = 1;
  return point;
}

std::vector<PointTerm> difference(const SurfacePoint& x, const SurfacePoint& y)
{
  std::vector<PointTerm> terms = merged(combined(x, 1, y, -1));
  std::erase_if(terms, [](const PointTerm& term) { return std::abs(term.weight) <= kVanishingWeight; });
  if (terms.size() == 1) terms.clear();
  return terms;
}

SurfacePoint midpoint(const SurfacePoint& x, const SurfacePoint& y)
{
  return canonical(combined(x, 0.5, y, 0.5));
}

Vector3 positionOf(const SurfacePoint& point, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();
  for (const PointTerm& term : point.terms) sum += term.weight * positions.row(term.vertex).transpose();
  return sum;
}

}  // namespace holdfast
