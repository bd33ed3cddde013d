#include "holdfast/elimination/circuit_patches.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <holdfast/elimination/basis_circuits.h>

namespace holdfast {
namespace {

// R of a basis and other rows is nearly full in the columns of these. Of so many it is small beside that of the basis.
constexpr std::size_t kFewOthers = 4000;

// Circuits have 25 to 50 rows where a patch is crowded. Few lead farther.
constexpr std::array kRingsOfPatches{10, 20, 40};

// A circuit whose rows are no longer all in the basis closes nowhere. What is nearest lies as near.
constexpr int kRingsOfOpenCircuits = 20;

/// Finds circuits in patches: what is reached in so many steps from row to row by shared unknowns. A circuit that
/// closes within a patch is the one of the whole basis, which is independent.
class CircuitPatches {
 public:
  CircuitPatches(const std::vector<RowTerms>& rows, const std::vector<Index>& basis, const std::vector<Index>& others,
                 const std::vector<Index>& unknowns)
      : rows_(rows),
        others_(others),
        placeOf_(rows.size(), kNowhere),
        rings_(others.size(), 0),
        seen_(rows.size(), 0),
        rowsOf_(rowsOfUnknowns(rows, unknowns.empty() ? 0 : unknowns.back() + 1))
  {
    for (const Index row : basis) placeOf_[row] = kInBasis;
    for (std::size_t k = 0; k < others.size(); ++k) placeOf_[others[k]] = static_cast<Index>(k);
  }

  /// Tells whether no patch of so many rings had the row near its middle.
  [[nodiscard]] bool isOpen(std::size_t place, int rings) const { return rings_[place] < rings; }

  /// Looks for the circuits of the rows near one of `others`; those that do not close as well where they `mayBeOpen`.
  void findAround(std::size_t place, int rings, bool mayBeOpen, std::vector<std::optional<Dependency>>& found)
  {
    ++search_;
    std::vector<Index> basis;
    std::vector<Index> middle;
    std::vector<Index> front{others_[place]};
    seen_[front.front()] = search_;
    for (int ring = 0; ring <= rings; ++ring) {
      for (const Index row : front)
        if (placeOf_[row] == kInBasis)
          basis.push_back(row);
        else if (2 * ring <= rings && !found[placeOf_[row]] && rings_[placeOf_[row]] < rings)
          middle.push_back(row);
      front = behind(front);
    }
    if (basis.empty()) return;
    std::ranges::sort(basis);
    std::vector<Index> named = basis;
    named.insert(named.end(), middle.begin(), middle.end());
    const std::vector<Dependency> circuits = circuitsOf(rows_, basis, middle, unknownsOf(rows_, named));
    for (std::size_t k = 0; k < middle.size(); ++k) {
      const Index own = placeOf_[middle[k]];
      rings_[own] = rings;
      if (mayBeOpen || !circuits[k].isUndecided()) found[own] = circuits[k];
    }
  }

 private:
  static constexpr Index kNowhere = -1;
  static constexpr Index kInBasis = -2;

  /// The rows that share an unknown with one of `front`, and were not reached before.
  [[nodiscard]] std::vector<Index> behind(const std::vector<Index>& front)
  {
    std::vector<Index> result;
    for (const Index row : front)
      for (const Term& term : rows_[row])
        for (const Index other : rowsOf_[term.index])
          if (placeOf_[other] != kNowhere && std::exchange(seen_[other], search_) != search_) result.push_back(other);
    return result;
  }

  const std::vector<RowTerms>& rows_;
  const std::vector<Index>& others_;
  std::vector<Index> placeOf_;  // in `others_`
  std::vector<int> rings_;      // of the largest patch that had each of `others_` near its middle
  std::vector<Index> seen_;     // the last search that reached each row
  Index search_ = 0;
  IndexLists rowsOf_;  // of each unknown
};

}  // namespace

std::vector<Dependency> circuitsByPatches(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                          const std::vector<Index>& others, const std::vector<Index>& unknowns,
                                          BasisKind kind)
{
  if (others.size() <= kFewOthers) return circuitsOf(rows, basis, others, unknowns);
  std::vector<std::optional<Dependency>> found(others.size());
  CircuitPatches patches(rows, basis, others, unknowns);
  for (const int rings : kRingsOfPatches)
    for (std::size_t k = 0; k < others.size(); ++k)
      if (!found[k] && patches.isOpen(k, rings))
        patches.findAround(k, rings, kind == BasisKind::Thinned && rings >= kRingsOfOpenCircuits, found);
  std::vector<Index> left;
  for (std::size_t k = 0; k < others.size(); ++k)
    if (!found[k]) left.push_back(others[k]);
  const std::vector<Dependency> ofAll =
      left.empty() ? std::vector<Dependency>() : circuitsOf(rows, basis, left, unknowns);
  std::vector<Dependency> result;
  result.reserve(found.size());
  std::size_t next = 0;
  for (std::optional<Dependency>& dependency : found)
    result.push_back(dependency ? *std::move(dependency) : ofAll[next++]);
  return result;
}

}  // namespace holdfast
