#pragma once
/// \file
/// Dependent rows by their definition, with all subsets tried. It takes half a dozen rows at most.

#include <vector>

#include <Eigen/Core>

#include <holdfast/elimination/find_dependencies.h>

namespace holdfast::test {

/// All that can be asked of a few rows, worked out once for every subset of them.
class Circuits {
 public:
  /// One row of B a row of `rows`; every subset must be of clear rank.
  explicit Circuits(Eigen::MatrixXd rows);

  /// Taking the rows in `order`: each is dependent when the rank of those accepted before does not grow by it; its
  /// partners are the smallest set of accepted rows that it depends on. Rows are named by their places in `order`.
  [[nodiscard]] std::vector<Dependency> dependenciesInOrder(const std::vector<Index>& order) const;

 private:
  [[nodiscard]] Index rank(unsigned subset) const { return rank_[subset]; }
  [[nodiscard]] unsigned smallestPartners(unsigned accepted, Index row) const;
  [[nodiscard]] Dependency dependency(Index place, unsigned terms, const std::vector<Index>& order) const;

  Eigen::MatrixXd rows_;
  std::vector<Index> rank_;
};

}  // namespace holdfast::test
