#include "holdfast/elimination/find_dependencies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <holdfast/elimination/large_component.h>
#include <holdfast/elimination/merged_unknowns.h>
#include <holdfast/elimination/own_unknowns.h>
#include <holdfast/elimination/sequential_qr.h>
#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

/// The basis is not exchanged for one in which a coefficient is larger than this: circuits that lead through many faces
/// grow like powers, and with them the rounding of all that is said of them.
constexpr double kLargestCoefficient = 1e6;

/// Larger components are judged by sparse matrices. So are those of which no row is to be close to all others: the
/// sequential method compares with rows before it only.
bool isJudgedInOrder(const RowComponent& component, double tolerance)
{
  return tolerance <= kRankTolerance && component.rows.size() <= kMostSequentialRows &&
         component.unknowns.size() <= kMostSequentialRows;
}

/// Tells whether other rows would better stand in the places of some.
bool leadsFar(const Dependency& dependency)
{
  return std::ranges::any_of(dependency.terms,
                             [](const Term& term) { return std::abs(term.coefficient) > 1 / kWaitingDistance; });
}

std::vector<Dependency> dependenciesOf(const RowComponent& component, const std::vector<RowTerms>& rows,
                                       double tolerance)
{
  if (isJudgedInOrder(component, tolerance)) {
    std::vector<Dependency> found = sequentialDependencies(rows, component, tolerance);
    if (std::ranges::none_of(found, leadsFar)) return found;
  }
  return sparseDependencies(rows, component, tolerance);
}

/// A dependent row that takes the place of a row of the basis.
struct Exchange {
  Index entering;
  Index leaving;
};

using Combination = std::vector<Term>;  // ascending by row

/// Solves row = sum c_k k for its term `leaving`.
Combination solvedFor(Index leaving, Index row, const Combination& combination)
{
  const double pivot = std::ranges::lower_bound(combination, leaving, {}, &Term::index)->coefficient;
  Combination result;
  result.reserve(combination.size());
  for (const Term& term : combination)
    if (term.index != leaving) result.push_back({term.index, -term.coefficient / pivot});
  result.insert(std::ranges::lower_bound(result, row, {}, &Term::index), {row, 1 / pivot});
  return result;
}

/// x + share y without its term `leaving`, and without what is rounding of zero.
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

/// The dependencies as rows of a tableau: each states a dependent row by some basis of the rows. Exchanges lead to the
/// basis that the sequential method of section 5 finds: of every circuit the last row is the dependent one. The
/// independent sets of rows are those of a matroid, in which the basis of least weight is reached by exchanges that
/// each lower the weight: a dependent row takes the place of one of its terms that comes after it. Where that would
/// make a coefficient larger than `kLargestCoefficient` it is left undone. Each exchange costs one pass over the
/// dependencies.
class Tableau {
 public:
  explicit Tableau(std::vector<Dependency> dependencies)
  {
    for (Dependency& dependency : dependencies) {
      dependent_[dependency.row] = std::move(dependency.terms);
      distances_[dependency.row] = dependency.distance;
    }
  }

  /// Takes the rows in their order: a dependent one with a term that comes after it goes into the basis, and nothing
  /// that comes later drives it out again. The term that leaves may be any that comes later; the one of the largest
  /// coefficient keeps the others small. Returns the dependencies ascending by row.
  std::vector<Dependency> byEarliestBasis() &&
  {
    for (auto place = dependent_.begin(); place != dependent_.end();) {
      const Index row = place->first;
      if (const auto pair = pairOf(row))
        if (Changes changes = exchanged(*pair); areBounded(changes)) commit(*pair, std::move(changes));
      place = dependent_.upper_bound(row);
    }
    std::vector<Dependency> result;
    for (auto& [row, combination] : dependent_) result.push_back({row, std::move(combination), distances_.at(row)});
    return result;
  }

 private:
  using Changes = std::vector<std::pair<Index, Combination>>;

  static bool areBounded(const Changes& changes)
  {
    const auto isLarge = [](const Term& term) { return std::abs(term.coefficient) > kLargestCoefficient; };
    return std::ranges::none_of(changes, [&](const auto& c) { return std::ranges::any_of(c.second, isLarge); });
  }

  [[nodiscard]] std::optional<Exchange> pairOf(Index row) const
  {
    const Combination& combination = dependent_.at(row);
    const auto later = std::ranges::lower_bound(combination, row, {}, &Term::index);
    const auto size = [](const Term& term) { return std::abs(term.coefficient); };
    const auto largest = std::ranges::max_element(later, combination.end(), {}, size);
    if (largest == combination.end()) return std::nullopt;
    return Exchange{row, largest->index};
  }

  /// What an exchange would make of the rows that it changes.
  [[nodiscard]] Changes exchanged(const Exchange& pair) const
  {
    Changes changes;
    const Combination replacement = solvedFor(pair.leaving, pair.entering, dependent_.at(pair.entering));
    for (const auto& [row, combination] : dependent_) {
      const auto term = std::ranges::lower_bound(combination, pair.leaving, {}, &Term::index);
      if (term == combination.end() || term->index != pair.leaving || row == pair.entering) continue;
      changes.emplace_back(row, sum(combination, term->coefficient, replacement, pair.leaving));
    }
    changes.emplace_back(pair.leaving, replacement);
    return changes;
  }

  void commit(const Exchange& pair, Changes&& changes)
  {
    dependent_.erase(pair.entering);
    distances_[pair.leaving] = distances_[pair.entering];
    for (auto& [row, combination] : changes) dependent_[row] = std::move(combination);
  }

  std::map<Index, Combination> dependent_;
  std::map<Index, double> distances_;
};

/// Difference rows that close no loop, in the user's order, and all other rows.
struct Forest {
  std::vector<Index> differences;
  std::vector<Index> others;
};

Forest forestOf(const std::vector<RowTerms>& rows, Index unknownCount)
{
  Forest forest;
  DisjointSets sets(unknownCount);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto difference = differenceOf(rows[r]);
    const bool joins = difference && sets.find(difference->from) != sets.find(difference->to);
    (joins ? forest.differences : forest.others).push_back(static_cast<Index>(r));
    if (joins) sets.unite(difference->from, difference->to);
  }
  return forest;
}

/// What is left of a dependency over merged unknowns when it is read over unknowns is a combination of difference rows.
void addTermsInside(const MergedUnknowns& groups, const std::vector<RowTerms>& rows, Dependency& dependency)
{
  RowTerms left = rows[dependency.row];
  double largest = 1;
  for (const auto& [row, coefficient] : dependency.terms) {
    largest = std::max(largest, std::abs(coefficient));
    for (const Term& term : rows[row]) left.push_back({term.index, -coefficient * term.coefficient});
  }
  for (const Term& term : groups.combinationOf(left))
    if (std::abs(term.coefficient) > kCoefficientThreshold * largest) dependency.terms.push_back(term);
  std::ranges::sort(dependency.terms, {}, &Term::index);
}

}  // namespace

std::vector<Dependency> sequentialDependencies(const std::vector<RowTerms>& rows, const RowComponent& component,
                                               double tolerance)
{
  const Eigen::MatrixXd block = transposedBlock(rows, component);
  SequentialQr qr(block.rows(), block.cols());
  std::vector<Index> accepted;
  std::vector<Dependency> result;
  for (Index k = 0; k < block.cols(); ++k) {
    const Index row = component.rows[k];
    if (const auto coefficients = qr.add(block.col(k), tolerance))
      result.push_back(dependencyOf(row, accepted, *coefficients, qr.distance()));
    else
      accepted.push_back(row);
  }
  return result;
}

std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount, double tolerance)
{
  const Forest forest = forestOf(rows, unknownCount);
  const MergedUnknowns groups(rows, forest.differences, unknownCount);
  std::vector<RowTerms> contracted(rows.size());
  for (const Index row : forest.others) contracted[row] = groups.contracted(rows[row]);

  std::vector<Dependency> all;
  for (const Index row : forest.others)
    if (contracted[row].empty()) all.push_back({row, {}});
  if (tolerance * kMostMoved < 1)  // they are independent
    for (const OwnUnknown& own : ownUnknowns(contracted, groups.count())) contracted[own.row].clear();
  for (const RowComponent& component : connectedRows(contracted, groups.count())) {
    if (component.rows.size() == 1) continue;
    std::vector<Dependency> found = dependenciesOf(component, contracted, tolerance);
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  for (Dependency& dependency : all) addTermsInside(groups, rows, dependency);
  std::ranges::sort(all, {}, &Dependency::row);
  return forest.differences.empty() ? all : Tableau(std::move(all)).byEarliestBasis();
}

std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount)
{
  std::vector<Index> result;
  result.reserve(rowCount - dependencies.size());
  auto next = dependencies.begin();
  for (Index row = 0; row < static_cast<Index>(rowCount); ++row)
    if (next != dependencies.end() && next->row == row)
      ++next;
    else
      result.push_back(row);
  return result;
}

}  // namespace holdfast
