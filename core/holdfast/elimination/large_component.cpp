#include "holdfast/elimination/large_component.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

#include <holdfast/elimination/basis_circuits.h>
#include <holdfast/elimination/near_rows.h>
#include <holdfast/elimination/row_matching.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {
namespace {

// Each round takes away the last of rows that nearly depend on one another. Two to four are the rule. So many rows are
// looked at in all, which takes seconds, but for a few rounds and no more than many.
constexpr std::size_t kRowsOfAllRounds = 500'000;
constexpr std::size_t kFewRounds = 8;
constexpr std::size_t kManyRounds = 64;

std::vector<Index> unknownsOf(const RowTerms& row)
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
      : rows_(std::move(rows)), unknowns_(upTo(unknownCount)), tolerance_(tolerance), role_(rows_.size(), Role::Open)
  {
    leaveOutRepeats();
  }

  /// The basis, in the order in which it was found. `isDecided` is false where too many rows nearly depend on one
  /// another for this order to tell which of them go.
  struct Basis {
    std::vector<Index> rows;
    bool isDecided = true;
    std::vector<double> closeness;  ///< of each row of all: the distance for which it was taken away, or 0
  };
  [[nodiscard]] Basis basisBy(const std::vector<Index>& order, bool isLastResort) const
  {
    std::vector<Role> roles = role_;
    Settled settled = Settled::AllButSome;
    if (tolerance_ < kWaitingDistance) settled = settle(order, roles, Role::Waiting, kWaitingDistance, isLastResort);
    bool isDecided = settled != Settled::Not;
    if (settled == Settled::AllButSome || (!isDecided && isLastResort))
      isDecided = settle(order, roles, Role::Out, tolerance_, isLastResort) != Settled::Not && isDecided;
    return {matched(order, roles), isDecided, closeness(roles)};
  }

  [[nodiscard]] const std::vector<RowTerms>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Index>& unknowns() const { return unknowns_; }

 private:
  enum class Role { Open, Waiting, Out, Repeat };

  /// Rows on the same unknowns as others that they follow from.
  void leaveOutRepeats()
  {
    std::map<std::vector<Index>, std::vector<Index>> groups;
    for (std::size_t r = 0; r < rows_.size(); ++r) groups[unknownsOf(rows_[r])].push_back(static_cast<Index>(r));
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
    const std::size_t mostRounds = std::clamp(kRowsOfAllRounds / rows_.size(), kFewRounds, kManyRounds);
    for (std::size_t round = 0; round < mostRounds; ++round) {
      NearRows near = nearlyDependentRows(rows_, matched(order, roles), unknowns_, distance);
      isDecided = isDecided && !near.isBeyondOrder;
      if (!isDecided && !isLastResort) return Settled::Not;
      if (near.last.empty()) return isDecided ? Settled::All : Settled::Not;
      std::erase_if(near.last, [&](Index row) { return roles[row] == role; });
      if (near.last.empty()) return isDecided ? Settled::AllButSome : Settled::Not;
      for (const Index row : near.last) roles[row] = role;
    }
    return Settled::Not;
  }

  [[nodiscard]] std::vector<double> closeness(const std::vector<Role>& roles) const
  {
    std::vector<double> result;
    for (const Role role : roles)
      result.push_back(role == Role::Waiting ? kWaitingDistance : role == Role::Out ? tolerance_ : 0);
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
  std::vector<Role> role_;
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
  std::vector<Dependency> result = circuitsOf(search.rows(), basis.rows, others, search.unknowns());
  for (Dependency& dependency : result)
    dependency.distance = std::max(dependency.distance, basis.closeness[dependency.row]);
  renumber(result, component.rows);
  return result;
}

}  // namespace holdfast
