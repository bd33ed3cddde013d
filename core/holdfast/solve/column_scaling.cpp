#include "holdfast/solve/column_scaling.h"

#include <cmath>

#include <fmt/format.h>

namespace holdfast {

namespace {

/// M with K diag(scale) below it, whose rows get length 1.
SparseMatrix withKeptRows(const SparseMatrix& M, const SparseMatrix& K, const Eigen::VectorXd& scale)
{
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(K.rows());
  for (Index k = 0; k < K.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(K, k); entry; ++entry)
      squares[entry.row()] += std::pow(scale[k] * entry.value(), 2);
  return assembled<SparseMatrix>(M.rows() + K.rows(), M.cols(), [&](Index k, ColumnSum& sum) {
    sum.addColumn(M, k);
    for (SparseMatrix::InnerIterator entry(K, k); entry; ++entry)
      sum.add(static_cast<int>(M.rows() + entry.row()), scale[k] * entry.value() / std::sqrt(squares[entry.row()]));
  });
}

}  // namespace

Result<ScaledColumns> scaleColumns(SparseMatrix&& M, const SparseMatrix& K)
{
  ScaledColumns result;
  result.scale.resize(M.cols());
  parallelBlocks(M.cols(), [&](Index k) {
    double squares = 0;
    for (SparseMatrix::InnerIterator entry(M, k); entry; ++entry) squares += entry.value() * entry.value();
    result.scale[k] = 1 / std::sqrt(squares);
    for (SparseMatrix::InnerIterator entry(M, k); entry; ++entry) entry.valueRef() *= result.scale[k];
  });
  for (Index k = 0; k < M.cols(); ++k)
    if (!(result.scale[k] > 0) || !std::isfinite(result.scale[k]))
      return {{}, fmt::format("unknown {} of {} is in no equation, or in one that is not finite", k, M.cols())};
  result.kept = K.rows();
  result.C = K.rows() == 0 ? TwoWayMatrix(std::move(M)) : TwoWayMatrix(withKeptRows(M, K, result.scale));
  return {std::move(result)};
}

}  // namespace holdfast
