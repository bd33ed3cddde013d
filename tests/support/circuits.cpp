#include "support/circuits.h"

#include <bit>
#include <utility>

#include "support/dense_svd.h"

namespace holdfast::test {
namespace {

unsigned bit(Index row)
{
  return 1U << static_cast<unsigned>(row);
}

Eigen::MatrixXd chosen(const Eigen::MatrixXd& rows, unsigned subset)
{
  Eigen::MatrixXd result(std::popcount(subset), rows.cols());
  Index next = 0;
  for (Index r = 0; r < rows.rows(); ++r)
    if ((subset & bit(r)) != 0) result.row(next++) = rows.row(r);
  return result;
}

}  // namespace

Circuits::Circuits(Eigen::MatrixXd rows) : rows_(std::move(rows))
{
  for (unsigned subset = 0; subset < bit(rows_.rows()); ++subset) rank_.push_back(clearRank(chosen(rows_, subset)));
}

unsigned Circuits::smallestPartners(unsigned accepted, Index row) const
{
  for (int size = 0; size <= std::popcount(accepted); ++size)
    for (unsigned subset = 0; subset <= accepted; ++subset)
      if ((subset & ~accepted) == 0 && std::popcount(subset) == size && rank(subset | bit(row)) == rank(subset))
        return subset;
  return accepted;
}

Dependency Circuits::dependency(Index place, unsigned terms, const std::vector<Index>& order) const
{
  Eigen::MatrixXd columns(rows_.cols(), std::popcount(terms));
  Dependency result{place, {}};
  for (std::size_t p = 0; p < order.size(); ++p)
    if ((terms & bit(order[p])) != 0) {
      columns.col(static_cast<Index>(result.terms.size())) = rows_.row(order[p]).transpose();
      result.terms.push_back({static_cast<Index>(p), 0});
    }
  const Eigen::VectorXd coefficients = leastSquares(columns, rows_.row(order[place]).transpose());
  for (std::size_t k = 0; k < result.terms.size(); ++k) result.terms[k].coefficient = coefficients[k];
  return result;
}

std::vector<Dependency> Circuits::dependenciesInOrder(const std::vector<Index>& order) const
{
  unsigned accepted = 0;
  std::vector<Dependency> result;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const Index row = order[place];
    if (rank(accepted | bit(row)) > rank(accepted))
      accepted |= bit(row);
    else
      result.push_back(dependency(static_cast<Index>(place), smallestPartners(accepted, row), order));
  }
  return result;
}

}  // namespace holdfast::test
