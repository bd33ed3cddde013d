#include "holdfast/elimination/reconciliation.h"

#include <algorithm>
#include <utility>

#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

// Circuits are known up to rounding, and so is what one change of targets leaves.
constexpr int kRounds = 3;

/// Circuits through rows that can be changed: b_row = sum of coefficient * b_index, as a matrix W with b = W b_rows.
struct Circuits {
  std::vector<Index> changed;  ///< the independent rows in them that are no pins, ascending
  std::vector<Index> rows;     ///< those, then the redundant ones
  SparseMatrix W;              ///< rows x changed: identity on top of the coefficients
};

Circuits circuitsOf(const EliminatedConstraints& eliminated, const std::vector<Index>& redundant)
{
  Circuits result;
  const auto isChanged = [&](const Term& term) { return eliminated.rows[term.index].size() > 1; };
  const auto termsOf = [&](Index row) -> const std::vector<Term>& {
    return std::ranges::lower_bound(eliminated.dependencies, row, {}, &Dependency::row)->terms;
  };
  for (const Index row : redundant)
    for (const Term& term : termsOf(row))
      if (isChanged(term)) result.changed.push_back(term.index);
  std::ranges::sort(result.changed);
  result.changed.erase(std::unique(result.changed.begin(), result.changed.end()), result.changed.end());
  result.rows = result.changed;
  result.rows.insert(result.rows.end(), redundant.begin(), redundant.end());

  std::vector<Eigen::Triplet<double, int>> entries;
  const int count = static_cast<int>(result.changed.size());
  for (int k = 0; k < count; ++k) entries.emplace_back(k, k, 1.0);
  for (std::size_t r = 0; r < redundant.size(); ++r)
    for (const Term& term : termsOf(redundant[r]))
      if (isChanged(term))
        entries.emplace_back(
            count + static_cast<int>(r),
            static_cast<int>(std::ranges::lower_bound(result.changed, term.index) - result.changed.begin()),
            term.coefficient);
  result.W.resize(static_cast<Index>(result.rows.size()), count);
  result.W.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The y of least |W y - d|, W of full column rank, by semi-normal equations: Q would be as large as the rows are many,
/// squared.
class LeastSquares {
 public:
  explicit LeastSquares(SparseMatrix W) : W_(std::move(W)), lengths_(normalizeColumns(W_))
  {
    SparseQrResult qr = sparseQr(W_, -1, WantQ::No);
    columns_ = std::move(qr.columns);
    R_ = qr.R.leftCols(W_.cols());
  }

  [[nodiscard]] Columns3 solve(const Columns3& d) const
  {
    const Columns3 right = W_.transpose() * d;
    Columns3 x = right(columns_, Eigen::all);
    R_.transpose().triangularView<Eigen::Lower>().solveInPlace(x);
    R_.triangularView<Eigen::Upper>().solveInPlace(x);
    Columns3 y(x.rows(), 3);
    for (Index k = 0; k < y.rows(); ++k) y.row(columns_[k]) = x.row(k) / lengths_[columns_[k]];
    return y;
  }

 private:
  SparseMatrix W_;
  Eigen::VectorXd lengths_;
  SparseMatrix R_;
  std::vector<Index> columns_;
};

}  // namespace

Columns3 reconciledParticular(const EliminatedConstraints& eliminated, const std::vector<Index>& redundant,
                              const Columns3& d)
{
  Columns3 u = eliminated.elimination.particular(d);
  const Circuits circuits = circuitsOf(eliminated, redundant);
  if (circuits.changed.empty()) return u;
  std::vector<RowTerms> terms;
  for (const Index row : circuits.rows) terms.push_back(eliminated.rows[row]);
  const SparseMatrix B = constraintMatrix(terms, u.rows());
  const Columns3 asked = d(circuits.rows, Eigen::all);
  const LeastSquares leastSquares(circuits.W);
  for (int round = 0; round < kRounds; ++round) {
    Columns3 change = Columns3::Zero(d.rows(), 3);
    change(circuits.changed, Eigen::all) = leastSquares.solve(asked - B * u);
    u += eliminated.elimination.particular(change);
  }
  return u;
}

}  // namespace holdfast
