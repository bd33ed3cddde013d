#include "holdfast/rotation/turning_bodies.h"

#include <algorithm>
#include <map>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

/// The regions, those that overlap as one, in the order of their first unknowns.
std::vector<TurningBody> regionBodies(const ConstraintSystem& system, Index unknownCount)
{
  DisjointSets sets(unknownCount);
  sets.uniteEach(system.rigidRegions);
  std::map<Index, std::vector<Index>> unknowns;  // by representative
  for (const std::vector<Index>& region : system.rigidRegions)
    for (const Index unknown : region) unknowns[sets.find(unknown)].push_back(unknown);
  std::vector<TurningBody> bodies;
  bodies.reserve(unknowns.size());
  for (auto& [representative, its] : unknowns) bodies.push_back({sortedOnce(std::move(its)), {}});
  return bodies;
}

/// The region that all unknowns of `rotation` are in; -1 where they are in none or in several.
Index commonRegion(const std::vector<Term>& rotation, const std::vector<Index>& bodyOfUnknown)
{
  const Index first = bodyOfUnknown[rotation.front().index];
  const bool isCommon =
      std::ranges::all_of(rotation, [&](const Term& term) { return bodyOfUnknown[term.index] == first; });
  return isCommon ? first : -1;
}

/// By row: what turns its target; -1 where nothing does. Vectors that turn with no region become bodies of their own.
std::vector<std::pair<Index, Vector3>> turnedRows(TurningBodies& turning, const ConstraintSystem& system)
{
  std::vector<std::pair<Index, Vector3>> result(system.rows.size(), {-1, Vector3::Zero()});
  for (std::size_t k = 0; k < system.rotated.size(); ++k) {
    const RotatedVector& vector = system.rotated[k];
    Index body = commonRegion(vector.rotation, turning.bodyOfUnknown);
    if (body < 0) {
      body = static_cast<Index>(turning.bodies.size());
      turning.bodies.push_back({});
    }
    turning.bodies[body].rotated.push_back(static_cast<Index>(k));
    result[vector.row] = {body, vector.rest};
  }
  return result;
}

RowTerms circuitOf(const Dependency& dependency)
{
  RowTerms circuit{{dependency.row, 1.0}};
  for (const Term& term : dependency.terms) circuit.push_back({term.index, -term.coefficient});
  return circuit;
}

/// In displacements, whose differences keep their digits far from the origin.
TurningGap gapOf(const Dependency& dependency, const ConstraintSystem& system,
                 const std::vector<std::pair<Index, Vector3>>& turnedBy, double limit)
{
  TurningGap gap{dependency.row, circuitOf(dependency), Vector3::Zero(), {}, limit};
  std::map<Index, Vector3> arms;  // by body
  for (const Term& term : gap.circuit) {
    const auto& [body, rest] = turnedBy[term.index];
    if (body < 0)
      gap.asked += term.coefficient * system.rows[term.index].shift;
    else
      arms.try_emplace(body, Vector3::Zero()).first->second -= term.coefficient * rest;
  }
  for (const auto& [body, arm] : arms) {
    gap.asked += arm;
    if (arm.stableNorm() > limit) gap.arms.push_back({body, arm});
  }
  return gap;
}

}  // namespace

TurningBodies::TurningBodies(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                             const SolverMesh& mesh)
    : bodyOfUnknown(static_cast<std::size_t>(mesh.unknownCount()), -1)
{
  if (system.rotated.empty()) return;
  bodies = regionBodies(system, mesh.unknownCount());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const Index unknown : bodies[b].unknowns) bodyOfUnknown[unknown] = static_cast<Index>(b);
  const auto turnedBy = turnedRows(*this, system);
  const std::vector<double> limits = agreeingGaps(eliminated, system, mesh);
  const auto turns = [&](const Term& term) { return turnedBy[term.index].first >= 0; };
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const Dependency& dependency = eliminated.dependencies[k];
    if (turnedBy[dependency.row].first < 0 && std::ranges::none_of(dependency.terms, turns)) continue;
    TurningGap gap = gapOf(dependency, system, turnedBy, limits[k]);
    if (!gap.arms.empty()) gaps.push_back(std::move(gap));
  }
}

}  // namespace holdfast
