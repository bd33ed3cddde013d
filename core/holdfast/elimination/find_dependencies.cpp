#include <algorithm>
#include <cmath>

#include <holdfast/elimination/earliest_basis.h>
#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/sequential_qr.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

/// The dependency of `row` by coefficients over some rows, tiny ones left out.
Dependency dependency(Index row, const std::vector<Index>& basis, const Eigen::VectorXd& coefficients)
{
  Dependency result{row, {}};
  const double vanishing = kPartnerThreshold * std::max(1.0, coefficients.cwiseAbs().maxCoeff());
  for (Index k = 0; k < coefficients.size(); ++k)
    if (std::abs(coefficients[k]) > vanishing) result.partners.push_back({basis[k], coefficients[k]});
  std::sort(result.partners.begin(), result.partners.end(),
            [](const Partner& x, const Partner& y) { return x.row < y.row; });
  return result;
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
  SparseMatrix block = transposedBlock(rows, component);
  const Eigen::VectorXd lengths = normalizeColumns(block);
  const SparseQrResult qr = sparseQr(block, kRankTolerance, WantQ::No);
  std::vector<Index> basis;
  for (Index k = 0; k < qr.rank; ++k) basis.push_back(component.rows[qr.columns[k]]);

  std::vector<Dependency> result;
  const SparseMatrix R1 = qr.R.leftCols(qr.rank);
  for (Index k = qr.rank; k < block.cols(); ++k) {
    Eigen::VectorXd coefficients = qr.R.col(k);
    R1.triangularView<Eigen::Upper>().solveInPlace(coefficients);
    const Index column = qr.columns[k];
    for (Index j = 0; j < qr.rank; ++j) coefficients[j] *= lengths[column] / lengths[qr.columns[j]];
    result.push_back(dependency(component.rows[column], basis, coefficients));
  }
  return byEarliestBasis(std::move(result));
}

std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount)
{
  std::vector<Dependency> all;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].empty()) all.push_back({static_cast<Index>(r), {}});
  for (const RowComponent& component : connectedRows(rows, unknownCount)) {
    if (component.rows.size() == 1) continue;
    std::vector<Dependency> found =
        isDense(component) ? sequentialDependencies(rows, component) : sparseDependencies(rows, component);
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  std::sort(all.begin(), all.end(), [](const Dependency& x, const Dependency& y) { return x.row < y.row; });
  return all;
}

std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount)
{
  std::vector<Index> result;
  auto dependent = dependencies.begin();
  for (std::size_t r = 0; r < rowCount; ++r)
    if (dependent != dependencies.end() && dependent->row == static_cast<Index>(r))
      ++dependent;
    else
      result.push_back(static_cast<Index>(r));
  return result;
}

}  // namespace holdfast
