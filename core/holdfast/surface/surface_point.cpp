#include "holdfast/surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace holdfast {

namespace {

/// Sorted by vertex, the weights of each vertex added up.
std::vector<Term> merged(std::vector<Term> terms)
{
  std::sort(terms.begin(), terms.end(), [](const Term& x, const Term& y) { return x.index < y.index; });
  std::vector<Term> sums;
  for (const Term& term : terms)
    if (!sums.empty() && sums.back().index == term.index)
      sums.back().coefficient += term.coefficient;
    else
      sums.push_back(term);
  return sums;
}

std::vector<Term> combined(const SurfacePoint& x, double ofX, const SurfacePoint& y, double ofY)
{
  std::vector<Term> terms;
  for (const Term& term : x.terms) terms.push_back({term.index, ofX * term.coefficient});
  for (const Term& term : y.terms) terms.push_back({term.index, ofY * term.coefficient});
  return terms;
}

}  // namespace

SurfacePoint canonical(std::vector<Term> terms)
{
  terms = merged(std::move(terms));
  std::erase_if(terms, [](const Term& term) { return term.coefficient <= kVanishingWeight; });
  if (terms.size() == 1) terms.front().coefficient = 1;
  return {terms};
}

std::vector<Term> difference(const SurfacePoint& x, const SurfacePoint& y)
{
  std::vector<Term> terms = merged(combined(x, 1, y, -1));
  std::erase_if(terms, [](const Term& term) { return std::abs(term.coefficient) <= kVanishingWeight; });
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
  for (const Term& term : point.terms) sum += term.coefficient * positions.row(term.index).transpose();
  return sum;
}

}  // namespace holdfast
