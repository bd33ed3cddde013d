#include "holdfast/elimination/large_component.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

#include <holdfast/elimination/circuit_patches.h>
#include <holdfast/elimination/near_rows.h>
#include <holdfast/elimination/row_matching.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {
namespace {

// Each round takes away the last of rows that nearly depend on one another. Two to four are the rule. So many rows are
// looked at in all, which takes seconds, but for a few rounds and no more than many.
constexpr std::size_t kRowsOfAllRounds = 2'000'000;
constexpr std::size_t kFewRounds = 8;
constexpr std::size_t kManyRounds = 64;

// Rows that come into the basis are compared with those around them first.
constexpr int kRingsAround = 12;

std::vector<Index> namedBy(const RowTerms& row)
{
  std::vector<Index> result;
  for (const Term& term : row) result.push_back(term.index);
  return result;
}

std::vector<Index> upTo(std::size_t count)
{
  std::vector<Index> result(count);
  std::iota(result.begin(), result.end(), Index{0});
  return result;
}

/// 0, n/2, n/4, 3n/4, n/8, ...: what comes first is spread over all.
std::vector<Index> inStrides(std::size_t count)
{
  const int bits = static_cast<int>(std::bit_width(count));
  const auto reversed = [&](std::size_t k) {
    std::size_t result = 0;
    for (int bit = 0; bit < bits; ++bit) result |= ((k >> bit) & 1U) << (bits - 1 - bit);
    return result;
  };
  std::vector<Index> result;
  for (std::size_t k = 0; k < std::size_t{1} << bits; ++k)
    if (reversed(k) < count) result.push_back(static_cast<Index>(reversed(k)));
  return result;
}

/// Looks for a basis of rows in a given order.
class BasisSearch {
 public:
  BasisSearch(std::vector<RowTerms> rows, std::size_t unknownCount, double tolerance)
      : rows_(std::move(rows)),
        unknowns_(upTo(unknownCount)),
        tolerance_(tolerance),
        isLarge_(std::max(rows_.size(), unknownCount) > kMostSequentialRows),
        role_(rows_.size(), Role::Open),
        rowsOf_(rowsOfUnknowns(rows_, static_cast<Index>(unknownCount)))
  {
    leaveOutRepeats();
  }

  /// The basis, in the order in which it was found. `isDecided` is false where too many rows nearly depend on one
  /// another for this order to tell which of them go.
  struct Basis {
    std::vector<Index> rows;
    bool isDecided = true;
    std::vector<double> closeness;  ///< of each row of all: the distance for which it was taken away, or 0
    BasisKind kind = BasisKind::Whole;
  };
  [[nodiscard]] Basis basisBy(const std::vector<Index>& order, bool isLastResort) const
  {
    std::vector<Role> roles = role_;
    const auto settledAs = [&](Role role, double distance) {
      return settle(order, roles, role, distance, isLastResort);
    };
    const double waiting = isLarge_ ? kCrowdedDistance : kWaitingDistance;
    Settled settled = Settled::AllButSome;
    if (isLarge_ || tolerance_ < waiting) settled = settledAs(Role::Waiting, waiting);
    bool isDecided = settled != Settled::Not;
    if (settled == Settled::AllButSome || (!isDecided && isLastResort))
      isDecided =
          settledAs(Role::Out, isLarge_ && isDecided ? kCrowdedDistance : tolerance_) != Settled::Not && isDecided;
    std::vector<Index> rows = matched(order, roles);
    const std::size_t whole = rows.size();
    if (isLarge_ && tolerance_ > kCrowdedDistance) isDecided = thinOut(rows, roles) && isDecided;
    const BasisKind kind = rows.size() < whole ? BasisKind::Thinned : BasisKind::Whole;
    return {std::move(rows), isDecided, closeness(roles), kind};
  }

  [[nodiscard]] const std::vector<RowTerms>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Index>& unknowns() const { return unknowns_; }

 private:
  enum class Role { Open, Waiting, Out, Repeat };

  /// Rows on the same unknowns as others that they follow from.
  void leaveOutRepeats()
  {
    std::map<std::vector<Index>, std::vector<Index>> groups;
    for (std::size_t r = 0; r < rows_.size(); ++r) groups[namedBy(rows_[r])].push_back(static_cast<Index>(r));
    for (const auto& [unknowns, group] : groups) {
      if (group.size() < 2) continue;
      const Eigen::MatrixXd block = transposedBlock(rows_, {group, unknowns});
      SequentialQr qr(block.rows(), block.cols());
      for (Index k = 0; k < block.cols(); ++k)
        if (qr.add(block.col(k), tolerance_)) role_[group[k]] = Role::Repeat;
    }
  }

  enum class Settled { All, AllButSome, Not };

  /// Gives rows this role until no row of the basis is closer to the others than `distance`, but for some that have the
  /// role and are needed all the same.
  Settled settle(const std::vector<Index>& order, std::vector<Role>& roles, Role role, double distance,
                 bool isLastResort) const
  {
    bool isDecided = true;
    std::vector<Index> basis = matched(order, roles);
    std::vector<Index> looked = basis;
    const std::size_t mostRounds = std::clamp(kRowsOfAllRounds / rows_.size(), kFewRounds, kManyRounds);
    for (std::size_t round = 0; round < mostRounds;) {
      NearRows near = nearlyDependentRows(rows_, looked, unknownsOf(rows_, looked), distance);
      isDecided = isDecided && !near.isBeyondOrder;
      if (!isDecided && !isLastResort) return Settled::Not;
      const bool isAnyNear = !near.last.empty();
      std::erase_if(near.last, [&](Index row) { return roles[row] == role; });
      const bool areAllLookedAt = looked.size() == basis.size();
      if (areAllLookedAt) ++round;
      if (near.last.empty() && areAllLookedAt) {
        const Settled settled = isAnyNear ? Settled::AllButSome : Settled::All;
        return isDecided ? settled : Settled::Not;
      }
      for (const Index row : near.last) roles[row] = role;
      std::vector<Index> next = matched(order, roles);
      looked = near.last.empty() || !isLarge_ ? next : around(changes(basis, next), next);
      basis = std::move(next);
    }
    return Settled::Not;
  }

  /// The rows that one of them has, and those that only the other one has.
  static std::vector<Index> changes(std::vector<Index> a, std::vector<Index> b)
  {
    std::ranges::sort(a);
    std::ranges::sort(b);
    std::vector<Index> result;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
    return result;
  }

  /// Returns those of `basis`, in their order, that some rows lead to by `kRingsAround` rows that share an unknown
  /// each.
  [[nodiscard]] std::vector<Index> around(std::vector<Index> some, const std::vector<Index>& basis) const
  {
    std::vector<bool> isReached(rows_.size(), false);
    for (const Index row : some) isReached[row] = true;
    for (int ring = 0; ring < kRingsAround; ++ring) {
      std::vector<Index> next;
      for (const Index row : some)
        for (const Term& term : rows_[row])
          for (const Index other : rowsOf_[term.index])
            if (!isReached[other]) {
              isReached[other] = true;
              next.push_back(other);
            }
      some = std::move(next);
    }
    std::vector<Index> result;
    std::ranges::copy_if(basis, std::back_inserter(result), [&](Index row) { return isReached[row]; });
    return result;
  }

  /// Takes rows of a basis out until none is closer to the others than the tolerance. False where that has no end.
  [[nodiscard]] bool thinOut(std::vector<Index>& basis, std::vector<Role>& roles) const
  {
    for (std::size_t round = 0; round < kManyRounds; ++round) {
      const NearRows near = nearlyDependentRows(rows_, basis, unknowns_, tolerance_);
      if (near.last.empty()) return true;
      for (const Index row : near.last) roles[row] = Role::Out;
      std::erase_if(basis, [&](Index row) { return roles[row] == Role::Out; });
    }
    return false;
  }

  [[nodiscard]] std::vector<double> closeness(const std::vector<Role>& roles) const
  {
    const double waiting = isLarge_ ? kCrowdedDistance : kWaitingDistance;
    const double out = isLarge_ ? std::max(tolerance_, kCrowdedDistance) : tolerance_;
    std::vector<double> result;
    result.reserve(roles.size());
    for (const Role role : roles) result.push_back(role == Role::Waiting ? waiting : role == Role::Out ? out : 0);
    return result;
  }

  [[nodiscard]] std::vector<Index> matched(const std::vector<Index>& order, const std::vector<Role>& roles) const
  {
    std::vector<Index> candidates;
    for (const Role role : {Role::Open, Role::Waiting})
      std::ranges::copy_if(order, std::back_inserter(candidates), [&](Index row) { return roles[row] == role; });
    return matchedRows(rows_, candidates, static_cast<Index>(unknowns_.size()));
  }

  std::vector<RowTerms> rows_;
  std::vector<Index> unknowns_;
  double tolerance_;
  bool isLarge_;
  std::vector<Role> role_;
  IndexLists rowsOf_;  // of each unknown
};

/// Rows by their places in a component as rows of the whole.
void renumber(std::vector<Dependency>& dependencies, const std::vector<Index>& rows)
{
  for (Dependency& dependency : dependencies) {
    dependency.row = rows[dependency.row];
    for (Term& term : dependency.terms) term.index = rows[term.index];
  }
}

}  // namespace

std::vector<Dependency> sparseDependencies(const std::vector<RowTerms>& rows, const RowComponent& component,
                                           double tolerance)
{
  const BasisSearch search(localRows(rows, component), component.unknowns.size(), tolerance);
  const std::size_t count = component.rows.size();
  BasisSearch::Basis basis = search.basisBy(upTo(count), false);
  if (!basis.isDecided) basis = search.basisBy(inStrides(count), true);
  std::ranges::sort(basis.rows);
  std::vector<Index> others;
  std::ranges::set_difference(upTo(count), basis.rows, std::back_inserter(others));
  std::vector<Dependency> result = circuitsByPatches(search.rows(), basis.rows, others, search.unknowns(), basis.kind);
  for (Dependency& dependency : result)
    dependency.distance = std::max(dependency.distance, basis.closeness[dependency.row]);
  renumber(result, component.rows);
  return result;
}

}  // namespace holdfast
