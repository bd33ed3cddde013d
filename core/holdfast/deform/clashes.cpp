#include "holdfast/deform/clashes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace holdfast {
namespace {

using ConstraintSet = std::set<Index>;

/// Rows of one constraint that depend on the same other constraints.
struct Way {
  Index rows = 0;
  Index worstRow = 0;
  Vector3 gap = Vector3::Zero();
  bool isConflict = false;
};

using Ways = std::map<ConstraintSet, Way>;

/// The ways of every constraint, by the other constraints that they need.
std::vector<Ways> waysOf(const ConstraintSystem& system, const Diagnosis& diagnosis, std::size_t constraintCount)
{
  std::vector<Ways> result(constraintCount);
  for (const auto& [dependency, gap] : diagnosis.dependent) {
    const Index own = system.rows[dependency.row].constraint;
    ConstraintSet others;
    for (const Partner& partner : dependency.partners) others.insert(system.rows[partner.row].constraint);
    others.erase(own);
    Way& way = result[own][others];
    if (way.rows++ == 0 || gap.stableNorm() > way.gap.stableNorm()) {
      way.gap = gap;
      way.worstRow = dependency.row;
    }
    way.isConflict = way.isConflict || diagnosis.status[dependency.row] == RowStatus::Conflicting;
  }
  return result;
}

/// Of ways that conflict, and of ways that repeat, leaves out those that need all that another one needs and more.
void keepSmallest(Ways& ways)
{
  const auto needsMore = [&](const auto& way) {
    return std::any_of(ways.begin(), ways.end(), [&](const auto& other) {
      return other.second.isConflict == way.second.isConflict && other.first.size() < way.first.size() &&
             std::includes(way.first.begin(), way.first.end(), other.first.begin(), other.first.end());
    });
  };
  std::vector<ConstraintSet> larger;
  for (const auto& way : ways)
    if (needsMore(way)) larger.push_back(way.first);
  for (const ConstraintSet& set : larger) ways.erase(set);
}

/// How many conflicts each constraint takes part in.
std::vector<Index> conflictCounts(const std::vector<Ways>& ways)
{
  std::vector<Index> counts(ways.size(), 0);
  for (std::size_t own = 0; own < ways.size(); ++own)
    for (const auto& [others, way] : ways[own]) {
      if (!way.isConflict) continue;
      ++counts[own];
      for (const Index other : others) ++counts[other];
    }
  return counts;
}

std::vector<Index> rowCounts(const ConstraintSystem& system, std::size_t constraintCount)
{
  std::vector<Index> counts(constraintCount, 0);
  for (const ConstraintRow& row : system.rows) ++counts[row.constraint];
  return counts;
}

/// Points and offsets have a target of their own that can be another one.
bool hasTarget(const Constraint& constraint)
{
  const Relative* relative = std::get_if<Relative>(&constraint.what);
  return std::holds_alternative<Point>(constraint.what) || (relative != nullptr && relative->offset);
}

/// Makes clashes of ways.
class Teller {
 public:
  Teller(const ConstraintList& list, const ConstraintSystem& system, const std::vector<Ways>& ways)
      : list_(list), system_(system), conflicts_(conflictCounts(ways)), rows_(rowCounts(system, ways.size()))
  {
  }

  [[nodiscard]] Clash tell(Index own, const ConstraintSet& others, const Way& way) const
  {
    Clash clash{{}, way.rows, way.gap, way.isConflict, {}, {}};
    for (const Index other : others) clash.with.push_back(list_.constraints[other].name);
    if (!way.isConflict) return clash;
    clash.disable = list_.constraints[cheapest(own, others)].name;
    if (hasTarget(list_.constraints[own])) clash.consistentTarget = system_.rows[way.worstRow].target - way.gap;
    return clash;
  }

 private:
  [[nodiscard]] Index cheapest(Index own, const ConstraintSet& others) const
  {
    const auto cost = [&](Index c) { return std::tuple(-conflicts_[c], rows_[c], -c); };
    Index best = own;
    for (const Index other : others)
      if (cost(other) < cost(best)) best = other;
    return best;
  }

  const ConstraintList& list_;
  const ConstraintSystem& system_;
  std::vector<Index> conflicts_;
  std::vector<Index> rows_;
};

}  // namespace

std::vector<std::vector<Clash>> clashesOf(const ConstraintList& list, const ConstraintSystem& system,
                                          const Diagnosis& diagnosis)
{
  std::vector<Ways> ways = waysOf(system, diagnosis, list.constraints.size());
  for (Ways& own : ways) keepSmallest(own);
  const Teller teller(list, system, ways);
  std::vector<std::vector<Clash>> result(ways.size());
  for (std::size_t own = 0; own < ways.size(); ++own) {
    for (const auto& [others, way] : ways[own])
      result[own].push_back(teller.tell(static_cast<Index>(own), others, way));
    std::stable_sort(result[own].begin(), result[own].end(),
                     [](const Clash& x, const Clash& y) { return x.gap.stableNorm() > y.gap.stableNorm(); });
  }
  return result;
}

}  // namespace holdfast
