#include <algorithm>

#include <holdfast/surface/surface_point.h>

namespace holdfast {

SurfacePoint canonical(std::vector<PointTerm> terms)
{
  std::sort(terms.begin(), terms.end(), [](const PointTerm& x, const PointTerm& y) { return x.vertex < y.vertex; });
  SurfacePoint point;
  for (const PointTerm& term : terms)
    if (!point.terms.empty() && point.terms.back().vertex == term.vertex)
      point.terms.back().weight += term.weight;
    else
      point.terms.push_back(term);
  std::erase_if(point.terms, [](const PointTerm& term) { return term.weight <= kVanishingWeight; });
  if (point.terms.size() == 1) point.terms.front().weight = 1;
  return point;
}

Vector3 positionOf(const SurfacePoint& point, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();
  for (const PointTerm& term : point.terms) sum += term.weight * positions.row(term.vertex).transpose();
  return sum;
}

}  // namespace holdfast
