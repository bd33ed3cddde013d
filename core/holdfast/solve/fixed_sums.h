#pragma once
/// Sums of numbers that equations fix, and what these leave free.

#include <map>
#include <vector>

#include <Eigen/Dense>

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/numbers/term.h>
#include <holdfast/numbers/types.h>

namespace holdfast {

/// An equation says that the sum of coefficient * y_index is `to`.
struct SumEquation {
  std::vector<Term> terms;
  double to = 0;
  std::vector<Index> names;  ///< the equation's own name is the first; the others are what its numbers come from
};

/// The numbers y under equations. A later equation that contradicts those before it is left out.
class FixedSums {
 public:
  /// `count` is how many y there are. Equations that share numbers are dense problems: O(equations^2 * numbers).
  FixedSums(const std::vector<SumEquation>& equations, Index count);

  /// Returns an orthonormal basis of what the equations leave free.
  [[nodiscard]] const SparseMatrix& free() const noexcept { return free_; }

  /// Returns by the own name of an equation that is left out the names of those that it contradicts.
  [[nodiscard]] const std::map<Index, std::vector<Index>>& contradicted() const noexcept { return contradicted_; }

  /// Returns the y that meets the equations and is nearest to `y`.
  [[nodiscard]] Eigen::VectorXd nearest(const Eigen::VectorXd& y) const;

 private:
  /// Equations that share columns.
  struct Group {
    std::vector<const SumEquation*> equations;
    std::vector<Index> columns;  // ascending
  };

  void solve(const Group& group, std::vector<Eigen::Triplet<double, int>>& entries, int& next);
  void contradict(const Group& group, const Eigen::VectorXd& sum, Index row);

  Eigen::VectorXd particular_;
  SparseMatrix free_;
  std::map<Index, std::vector<Index>> contradicted_;
};

}  // namespace holdfast
