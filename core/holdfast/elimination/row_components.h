#pragma once
/// Rows of B that share unknowns, however indirectly. Rows of different components are orthogonal. So each component is
/// eliminated on its own, and no matrix larger than its block is ever formed.

#include <vector>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// The terms of one row of B: ascending unknowns with coefficients.
using RowTerms = std::vector<Term>;

/// One component: rows ascending, the unknowns that they name ascending.
struct RowComponent {
  std::vector<Index> rows;
  std::vector<Index> unknowns;
};

/// Returns the components of all rows that are not empty, in the order of their first rows. O(terms log terms).
[[nodiscard]] std::vector<RowComponent> connectedRows(const std::vector<RowTerms>& rows, Index unknownCount);

/// Returns the unknowns that some of `rows` name, ascending, each once.
[[nodiscard]] std::vector<Index> unknownsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& some);

/// Returns for each unknown the rows that name it, ascending. O(terms).
[[nodiscard]] IndexLists rowsOfUnknowns(const std::vector<RowTerms>& rows, Index unknownCount);

/// Returns the rows of a component, by places in `component.rows`, over places in `component.unknowns`.
[[nodiscard]] std::vector<RowTerms> localRows(const std::vector<RowTerms>& rows, const RowComponent& component);

/// Returns the component's block of B^T: component.unknowns x component.rows.
[[nodiscard]] SparseMatrix transposedBlock(const std::vector<RowTerms>& rows, const RowComponent& component);

/// Tells whether the component is eliminated as a dense block. Larger ones are eliminated by sparse QR.
[[nodiscard]] bool isDense(const RowComponent& component);

/// Returns B, rows.size() x unknownCount.
[[nodiscard]] SparseMatrix constraintMatrix(const std::vector<RowTerms>& rows, Index unknownCount);

}  // namespace holdfast
