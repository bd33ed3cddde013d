#include "holdfast/elimination/find_dependencies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ranges>

#include <Eigen/OrderingMethods>

#include <holdfast/base/disjoint_sets.h>
#include <holdfast/elimination/merged_unknowns.h>
#include <holdfast/elimination/own_unknowns.h>
#include <holdfast/elimination/sequential_qr.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

/// The basis is not exchanged for one in which a coefficient is larger than this: circuits that lead through many faces
/// grow like powers, and with them the rounding of all that is said of them.
constexpr double kLargestCoefficient = 1e6;

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
  explicit Tableau(const std::vector<Dependency>& dependencies)
  {
    for (const Dependency& dependency : dependencies) dependent_[dependency.row] = dependency.terms;
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
    for (auto& [row, combination] : dependent_) result.push_back({row, std::move(combination)});
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

  void commit(const Exchange& pair, Changes changes)
  {
    dependent_.erase(pair.entering);
    for (auto& [row, combination] : changes) dependent_[row] = std::move(combination);
  }

  std::map<Index, Combination> dependent_;
};

/// Where the largest coefficient is, if it exceeds `kLargestCoefficient`.
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

// The second finds what rounding hid from the first.
constexpr int kMaxRounds = 2;
// One or two are the rule where there is any; a basis that needs more is as badly conditioned after them.
constexpr int kMaxReductions = 64;

/// The dependency of `row` by coefficients over some rows, tiny ones left out.
Dependency dependency(Index row, const std::vector<Index>& basis, const Eigen::VectorXd& coefficients)
{
  Dependency result{row, {}};
  const double vanishing = kCoefficientThreshold * std::max(1.0, coefficients.cwiseAbs().maxCoeff());
  for (Index k = 0; k < coefficients.size(); ++k)
    if (std::abs(coefficients[k]) > vanishing) result.terms.push_back({basis[k], coefficients[k]});
  std::ranges::sort(result.terms, {}, &Term::index);
  return result;
}

/// The dependencies that a QR of the component's block shows: of its R = [R11, R12] the coefficients are R11^-1 R12. Q
/// is not needed. Without `basisSize` the rank tells how large R11 is.
std::vector<Dependency> dependenciesByQr(const std::vector<RowTerms>& all, const RowComponent& component,
                                         ColumnOrder order, std::optional<std::size_t> basisSize = {})
{
  constexpr double kAcceptAll = -1;
  SparseMatrix block = transposedBlock(all, component);
  const Eigen::VectorXd lengths = normalizeColumns(block);
  const SparseQrResult qr = sparseQr(block, basisSize ? kAcceptAll : kRankTolerance, WantQ::No, order);
  const Index rank = basisSize ? static_cast<Index>(*basisSize) : qr.rank;
  const SparseMatrix top = SparseRows(SparseRows(qr.R).topRows(rank));
  const SparseMatrix R11 = top.leftCols(rank);
  std::vector<Index> basis;
  for (Index k = 0; k < rank; ++k) basis.push_back(component.rows[qr.columns[k]]);
  std::vector<Dependency> result;
  for (Index k = rank; k < top.cols(); ++k) {
    Eigen::VectorXd coefficients = top.col(k);
    R11.triangularView<Eigen::Upper>().solveInPlace(coefficients);
    const Index column = qr.columns[k];
    for (Index j = 0; j < rank; ++j) coefficients[j] *= lengths[column] / lengths[qr.columns[j]];
    result.push_back(dependency(component.rows[column], basis, coefficients));
  }
  std::ranges::sort(result, {}, &Dependency::row);
  return result;
}

/// Those of `rows`, ascending, that depend on none.
template <class Rows>
std::vector<Index> independentOf(const Rows& rows, const std::vector<Dependency>& dependencies)
{
  std::vector<Index> result;
  std::ranges::set_difference(rows, dependencies | std::views::transform(&Dependency::row), std::back_inserter(result));
  return result;
}

/// The basis in an order in which its QR fills in little.
std::vector<Index> inFillReducingOrder(const std::vector<RowTerms>& rows, const RowComponent& component,
                                       const std::vector<Index>& basis)
{
  const SparseMatrix block = transposedBlock(rows, {basis, component.unknowns});
  Eigen::COLAMDOrdering<int>::PermutationType placeOf;
  Eigen::COLAMDOrdering<int>()(block, placeOf);
  std::vector<Index> result(basis.size());
  for (std::size_t k = 0; k < basis.size(); ++k) result[placeOf.indices()[static_cast<Index>(k)]] = basis[k];
  return result;
}

/// The dependencies by a given basis of the component's rows, ascending: a QR of the basis with the others behind it.
std::vector<Dependency> byBasis(const std::vector<RowTerms>& rows, const RowComponent& component,
                                const std::vector<Index>& basis)
{
  std::vector<Index> order = inFillReducingOrder(rows, component, basis);
  std::ranges::set_difference(component.rows, basis, std::back_inserter(order));
  return dependenciesByQr(rows, {std::move(order), component.unknowns}, ColumnOrder::AsGiven, basis.size());
}

/// `found`, by a basis in which no coefficient exceeds `kLargestCoefficient`. A factorisation for each exchange: where
/// coefficients are large, those that one leaves small are rounding.
std::vector<Dependency> bounded(std::vector<Dependency> found, const std::vector<RowTerms>& rows,
                                const RowComponent& component)
{
  for (int exchange = 0; exchange < kMaxReductions; ++exchange) {
    const auto pair = largestCoefficient(found);
    if (!pair) break;
    std::vector<Index> basis = independentOf(component.rows, found);
    basis.erase(std::find(basis.begin(), basis.end(), pair->leaving));
    basis.insert(std::lower_bound(basis.begin(), basis.end(), pair->entering), pair->entering);
    found = byBasis(rows, component, basis);
  }
  return found;
}

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

std::vector<Dependency> sequentialDependencies(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  const Eigen::MatrixXd block = transposedBlock(rows, component);
  SequentialQr qr(block.rows(), block.cols());
  std::vector<Index> accepted;
  std::vector<Dependency> result;
  for (Index k = 0; k < block.cols(); ++k) {
    const Index row = component.rows[k];
    if (const auto coefficients = qr.add(block.col(k)))
      result.push_back(dependency(row, accepted, *coefficients));
    else
      accepted.push_back(row);
  }
  return result;
}

std::vector<Dependency> sparseDependencies(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  std::vector<Dependency> found =
      bounded(dependenciesByQr(rows, component, ColumnOrder::FillReducing), rows, component);
  // Each exchange adds rounding: what they lead to is factorised anew, and exchanged again where that tells more.
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Index> basis = independentOf(component.rows, Tableau(found).byEarliestBasis());
    if (basis == independentOf(component.rows, found)) break;
    found = bounded(byBasis(rows, component, basis), rows, component);
  }
  return found;
}

std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount)
{
  const Forest forest = forestOf(rows, unknownCount);
  const MergedUnknowns groups(rows, forest.differences, unknownCount);
  std::vector<RowTerms> contracted(rows.size());
  for (const Index row : forest.others) contracted[row] = groups.contracted(rows[row]);

  std::vector<Dependency> all;
  for (const Index row : forest.others)
    if (contracted[row].empty()) all.push_back({row, {}});
  for (const OwnUnknown& own : ownUnknowns(contracted, groups.count())) contracted[own.row].clear();  // independent
  for (const RowComponent& component : connectedRows(contracted, groups.count())) {
    if (component.rows.size() == 1) continue;
    std::vector<Dependency> found =
        isDense(component) ? sequentialDependencies(contracted, component) : sparseDependencies(contracted, component);
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  for (Dependency& dependency : all) addTermsInside(groups, rows, dependency);
  std::ranges::sort(all, {}, &Dependency::row);
  return forest.differences.empty() ? all : Tableau(all).byEarliestBasis();
}

std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount)
{
  return independentOf(std::views::iota(Index{0}, static_cast<Index>(rowCount)), dependencies);
}

}  // namespace holdfast
