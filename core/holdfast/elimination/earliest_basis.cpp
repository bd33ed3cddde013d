#include <algorithm>
#include <cmath>
#include <map>

#include <holdfast/elimination/earliest_basis.h>

namespace holdfast {
namespace {

using Combination = std::map<Index, double>;  // row to coefficient, ascending

/// Solves row = sum c_k k for its partner `leaving`.
Combination solvedFor(Index leaving, Index row, const Combination& combination)
{
  const double pivot = combination.at(leaving);
  Combination result{{row, 1 / pivot}};
  for (const auto& [partner, coefficient] : combination)
    if (partner != leaving) result[partner] = -coefficient / pivot;
  return result;
}

/// Puts `replacement` in the place of `leaving`.
void substitute(Combination& combination, Index leaving, const Combination& replacement)
{
  const auto found = combination.find(leaving);
  if (found == combination.end()) return;
  const double share = found->second;
  combination.erase(found);
  double largest = 1;
  for (const auto& [partner, coefficient] : replacement) {
    double& sum = combination[partner];
    largest = std::max({largest, std::abs(sum), std::abs(share * coefficient)});
    sum += share * coefficient;
  }
  std::erase_if(combination, [&](const auto& term) { return std::abs(term.second) <= kPartnerThreshold * largest; });
}

/// The dependencies as rows of a tableau, changed by exchanges.
class Tableau {
 public:
  explicit Tableau(const std::vector<Dependency>& dependencies)
  {
    for (const Dependency& dependency : dependencies)
      for (Combination& combination = dependent_[dependency.row]; const Partner& partner : dependency.partners)
        combination[partner.row] = partner.coefficient;
  }

  /// One exchange that lowers the weight of the basis; false when there is none.
  bool exchange()
  {
    for (const auto& [row, combination] : dependent_)
      if (!combination.empty() && combination.rbegin()->first > row) {
        exchange(row, combination.rbegin()->first);
        return true;
      }
    return false;
  }

  [[nodiscard]] std::vector<Dependency> dependencies() const
  {
    std::vector<Dependency> result;
    for (const auto& [row, combination] : dependent_) {
      Dependency dependency{row, {}};
      for (const auto& [partner, coefficient] : combination) dependency.partners.push_back({partner, coefficient});
      result.push_back(std::move(dependency));
    }
    return result;
  }

 private:
  void exchange(Index entering, Index leaving)
  {
    const Combination replacement = solvedFor(leaving, entering, dependent_.at(entering));
    dependent_.erase(entering);
    for (auto& [row, combination] : dependent_) substitute(combination, leaving, replacement);
    dependent_[leaving] = replacement;
  }

  std::map<Index, Combination> dependent_;
};

}  // namespace

std::vector<Dependency> byEarliestBasis(std::vector<Dependency> dependencies)
{
  Tableau tableau(dependencies);
  while (tableau.exchange()) {
  }
  return tableau.dependencies();
}

}  // namespace holdfast
