#include "holdfast/solve/fixed_sums.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

// What is left of an equation by those before it is rounding below this share.
constexpr double kFollowsFrom = 1e-10;

// Offsets in diagonals that differ by this are the same.
constexpr double kAgrees = 5e-13;

}  // namespace

FixedSums::FixedSums(const std::vector<SumEquation>& equations, Index count) : particular_(Eigen::VectorXd::Zero(count))
{
  DisjointSets columns(count);
  for (const SumEquation& equation : equations)
    for (const Term& term : equation.terms) columns.unite(equation.terms.front().index, term.index);
  std::map<Index, Group> groups;  // by representative
  for (const SumEquation& equation : equations)
    if (!equation.terms.empty()) groups[columns.find(equation.terms.front().index)].equations.push_back(&equation);
  std::vector<Eigen::Triplet<double, int>> entries;
  int next = 0;
  for (Index y = 0; y < count; ++y)
    if (const auto group = groups.find(columns.find(y)); group != groups.end())
      group->second.columns.push_back(y);
    else
      entries.emplace_back(static_cast<int>(y), next++, 1);
  for (const auto& [representative, group] : groups) solve(group, entries, next);
  free_ = SparseMatrix(count, next);
  free_.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd FixedSums::nearest(const Eigen::VectorXd& y) const
{
  return particular_ + free_ * (free_.transpose() * (y - particular_));
}

/// Gram and Schmidt, twice for the digits. Each direction is a sum of equations, which `sums` has.
void FixedSums::solve(const Group& group, std::vector<Eigen::Triplet<double, int>>& entries, int& next)
{
  const auto count = static_cast<Index>(group.columns.size());
  const auto rows = static_cast<Index>(group.equations.size());
  Eigen::MatrixXd directions(count, 0);
  Eigen::MatrixXd sums(rows, 0);  // of equations: each direction
  Eigen::VectorXd to(rows);
  for (Index r = 0; r < rows; ++r) {
    to[r] = group.equations[r]->to;
    Eigen::VectorXd left = Eigen::VectorXd::Zero(count);
    for (const Term& term : group.equations[r]->terms)
      left[std::ranges::lower_bound(group.columns, term.index) - group.columns.begin()] += term.coefficient;
    const double size = left.norm();
    Eigen::VectorXd sum = Eigen::VectorXd::Unit(rows, r);
    for (int twice = 0; twice < 2; ++twice) {
      const Eigen::VectorXd shares = directions.transpose() * left;
      left -= directions * shares;
      sum -= sums * shares;
    }
    if (left.norm() > kFollowsFrom * size) {
      directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
      sums.conservativeResize(Eigen::NoChange, sums.cols() + 1);
      directions.rightCols<1>() = left / left.norm();
      sums.rightCols<1>() = sum / left.norm();
    } else if (std::abs(sum.dot(to)) > kAgrees * sum.lpNorm<1>()) {
      contradict(group, sum, r);
    }
  }
  for (Index c = 0; c < directions.cols(); ++c)
    for (Index k = 0; k < count; ++k) particular_[group.columns[k]] += directions(k, c) * sums.col(c).dot(to);
  const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(directions).householderQ();
  for (Index c = directions.cols(); c < count; ++c, ++next)
    for (Index k = 0; k < count; ++k)
      if (Q(k, c) != 0) entries.emplace_back(static_cast<int>(group.columns[k]), next, Q(k, c));
}

void FixedSums::contradict(const Group& group, const Eigen::VectorXd& sum, Index row)
{
  const Index own = group.equations[row]->names.front();
  std::vector<Index>& others = contradicted_[own];
  if (!others.empty()) return;
  for (Index r = 0; r <= row; ++r)
    if (std::abs(sum[r]) > kFollowsFrom * sum.lpNorm<Eigen::Infinity>())
      std::ranges::copy_if(group.equations[r]->names, std::back_inserter(others),
                           [&](Index name) { return name != own; });
}

}  // namespace holdfast
