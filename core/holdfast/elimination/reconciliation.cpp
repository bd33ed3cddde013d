#include "holdfast/elimination/reconciliation.h"

#include <algorithm>

#include <holdfast/mesh/index_lists.h>

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
  result.changed = sortedOnce(std::move(result.changed));
  result.rows = result.changed;
  result.rows.insert(result.rows.end(), redundant.begin(), redundant.end());

  std::vector<Eigen::Triplet<double, int>> entries;
  const int count = static_cast<int>(result.changed.size());
  entries.reserve(static_cast<std::size_t>(count));
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

}  // namespace

Columns3 reconciledParticular(const EliminatedConstraints& eliminated, const std::vector<Index>& redundant,
                              const Columns3& d)
{
  Columns3 u = eliminated.elimination.particular(d);
  Circuits circuits = circuitsOf(eliminated, redundant);
  if (circuits.changed.empty()) return u;
  std::vector<RowTerms> terms;
  for (const Index row : circuits.rows) terms.push_back(eliminated.rows[row]);
  const SparseMatrix B = constraintMatrix(terms, u.rows());
  const Columns3 asked = d(circuits.rows, Eigen::all);
  // The y of least |W y - d| by semi-normal equations: Q would be as large as the rows are many, squared.
  SparseMatrix& W = circuits.W;
  const Eigen::VectorXd lengths = normalizeColumns(W);
  const SparseQrResult qr = sparseQr(W, -1, WantQ::No);
  for (int round = 0; round < kRounds; ++round) {
    Columns3 change = Columns3::Zero(d.rows(), 3);
    const Columns3 missed = asked - B * u;
    const Columns3 y = qr.solveSeminormal(W.transpose() * missed);
    change(circuits.changed, Eigen::all) = (y.array().colwise() / lengths.array()).matrix();
    u += eliminated.elimination.particular(change);
  }
  return u;
}

}  // namespace holdfast
