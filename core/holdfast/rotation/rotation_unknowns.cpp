#include "holdfast/rotation/rotation_unknowns.h"

#include <holdfast/base/disjoint_sets.h>

namespace holdfast {
namespace {

DisjointSets regionsOf(const RotationProblem& problem)
{
  DisjointSets regions(problem.unknownCount);
  regions.uniteEach(problem.rigidRegions);
  return regions;
}

DisjointSets tiedByEdges(DisjointSets sets, const std::vector<EdgeWeight>& weights)
{
  for (const EdgeWeight& edge : weights)
    if (edge.weight != 0) sets.unite(edge.i, edge.j);
  return sets;
}

/// Of each representative: the first place in `prescribed` of an unknown of its set; -1 elsewhere.
std::vector<Index> firstGiven(DisjointSets& sets, const RotationProblem& problem)
{
  std::vector<Index> first(static_cast<std::size_t>(problem.unknownCount), -1);
  for (Index k = static_cast<Index>(problem.prescribed.size()) - 1; k >= 0; --k)
    first[sets.find(problem.prescribed[k])] = k;
  return first;
}

/// Of each unknown: its own place in `prescribed`, else that of its region; -1 elsewhere.
std::vector<Index> givenOfUnknowns(DisjointSets& regions, const std::vector<Index>& ofRegion,
                                   const RotationProblem& problem)
{
  std::vector<Index> given(static_cast<std::size_t>(problem.unknownCount));
  for (Index i = 0; i < problem.unknownCount; ++i) given[i] = ofRegion[regions.find(i)];
  for (Index k = static_cast<Index>(problem.prescribed.size()) - 1; k >= 0; --k) given[problem.prescribed[k]] = k;
  return given;
}

}  // namespace

RotationUnknowns rotationUnknowns(const RotationProblem& problem)
{
  DisjointSets regions = regionsOf(problem);
  DisjointSets parts = tiedByEdges(regions, problem.weights);
  const std::vector<Index> ofRegion = firstGiven(regions, problem);
  const std::vector<Index> ofPart = firstGiven(parts, problem);

  RotationUnknowns result;
  result.givenOf = givenOfUnknowns(regions, ofRegion, problem);
  for (const Index unknown : problem.prescribed) result.leaderOf.push_back(ofRegion[regions.find(unknown)]);
  result.columnOf.assign(result.givenOf.size(), -1);
  for (Index i = 0; i < problem.unknownCount; ++i) {
    const Index reference = ofPart[parts.find(i)];
    if (result.givenOf[i] >= 0 || reference < 0) continue;
    const Index first = regions.find(i);
    if (first == i) result.referenceOf.push_back(reference);
    result.columnOf[i] = first == i ? result.columnCount() - 1 : result.columnOf[first];
  }
  return result;
}

}  // namespace holdfast
