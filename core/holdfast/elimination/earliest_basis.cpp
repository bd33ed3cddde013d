#include "holdfast/elimination/earliest_basis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace holdfast {
namespace {

using Combination = std::vector<Term>;  // ascending by row

bool comesBefore(const Term& term, Index row)
{
  return term.index < row;
}

/// The partner `row` of a combination that has it.
const Term& partnerIn(const Combination& combination, Index row)
{
  return *std::lower_bound(combination.begin(), combination.end(), row, comesBefore);
}

double largestOf(const Combination& combination)
{
  double largest = 0;
  for (const Term& term : combination) largest = std::max(largest, std::abs(term.coefficient));
  return largest;
}

/// Solves row = sum c_k k for its partner `leaving`.
Combination solvedFor(Index leaving, Index row, const Combination& combination)
{
  const double pivot = partnerIn(combination, leaving).coefficient;
  Combination result;
  result.reserve(combination.size());
  for (const Term& term : combination)
    if (term.index != leaving) result.push_back({term.index, -term.coefficient / pivot});
  result.insert(std::lower_bound(result.begin(), result.end(), row, comesBefore), {row, 1 / pivot});
  return result;
}

/// x + share y without its partner `leaving`, and without what is rounding of zero.
Combination sum(const Combination& x, double share, const Combination& y, Index leaving)
{
  Combination result;
  result.reserve(x.size() + y.size());
  double largest = 1;
  auto a = x.begin();
  auto b = y.begin();
  while (a != x.end() || b != y.end()) {
    const bool takesA = b == y.end() || (a != x.end() && a->index <= b->index);
    const bool takesB = a == x.end() || (b != y.end() && b->index <= a->index);
    const Index row = takesA ? a->index : b->index;
    const double old = takesA ? (a++)->coefficient : 0;
    const double added = takesB ? share * (b++)->coefficient : 0;
    largest = std::max({largest, std::abs(old), std::abs(added)});
    if (row != leaving) result.push_back({row, old + added});
  }
  const double vanishing = kCoefficientThreshold * largest;
  std::erase_if(result, [&](const Term& term) { return std::abs(term.coefficient) <= vanishing; });
  return result;
}

/// The dependencies as rows of a tableau, changed by exchanges.
class Tableau {
 public:
  explicit Tableau(const std::vector<Dependency>& dependencies)
  {
    for (const Dependency& dependency : dependencies) dependent_[dependency.row] = dependency.terms;
  }

  /// Takes the rows in their order: a dependent one with a partner that comes after it goes into the basis, and nothing
  /// that comes later drives it out again. The partner that leaves may be any that comes later; the one of the largest
  /// coefficient keeps the others small.
  void takeInOrder()
  {
    for (auto place = dependent_.begin(); place != dependent_.end();) {
      const Index row = place->first;
      if (const auto pair = pairOf(row))
        if (Changes changes = exchanged(*pair); areBounded(changes)) commit(*pair, std::move(changes));
      place = dependent_.upper_bound(row);
    }
  }

  [[nodiscard]] std::vector<Dependency> dependencies() const
  {
    std::vector<Dependency> result;
    for (const auto& [row, combination] : dependent_) result.push_back({row, combination});
    return result;
  }

 private:
  using Changes = std::vector<std::pair<Index, Combination>>;

  static bool areBounded(const Changes& changes)
  {
    return std::all_of(changes.begin(), changes.end(),
                       [](const auto& change) { return largestOf(change.second) <= kLargestCoefficient; });
  }

  [[nodiscard]] std::optional<Exchange> pairOf(Index row) const
  {
    const Combination& combination = dependent_.at(row);
    const auto later = std::lower_bound(combination.begin(), combination.end(), row, comesBefore);
    const auto largest = std::max_element(later, combination.end(), [](const Term& x, const Term& y) {
      return std::abs(x.coefficient) < std::abs(y.coefficient);
    });
    if (largest == combination.end()) return std::nullopt;
    return Exchange{row, largest->index};
  }

  /// What an exchange would make of the rows that it changes.
  [[nodiscard]] Changes exchanged(const Exchange& pair) const
  {
    Changes changes;
    const Combination replacement = solvedFor(pair.leaving, pair.entering, dependent_.at(pair.entering));
    for (const auto& [row, combination] : dependent_) {
      const auto term = std::lower_bound(combination.begin(), combination.end(), pair.leaving, comesBefore);
      if (term == combination.end() || term->index != pair.leaving || row == pair.entering) continue;
      changes.emplace_back(row, sum(combination, term->coefficient, replacement, pair.leaving));
    }
    changes.emplace_back(pair.leaving, replacement);
    return changes;
  }

  void commit(const Exchange& pair, Changes changes)
  {
    dependent_.erase(pair.entering);
    for (auto& [row, combination] : changes) dependent_[row] = std::move(combination);
  }

  std::map<Index, Combination> dependent_;
};

}  // namespace

std::vector<Dependency> byEarliestBasis(const std::vector<Dependency>& dependencies)
{
  Tableau tableau(dependencies);
  tableau.takeInOrder();
  return tableau.dependencies();
}

std::optional<Exchange> largestCoefficient(const std::vector<Dependency>& dependencies)
{
  std::optional<Exchange> result;
  double largest = kLargestCoefficient;
  for (const Dependency& dependency : dependencies)
    for (const Term& term : dependency.terms)
      if (std::abs(term.coefficient) > largest) {
        largest = std::abs(term.coefficient);
        result = Exchange{dependency.row, term.index};
      }
  return result;
}

}  // namespace holdfast
