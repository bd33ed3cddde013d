#pragma once
/// \file
/// Rows of constraints as a sparse matrix.

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// B, rows.size() x unknownCount.
[[nodiscard]] SparseMatrix constraintMatrix(const std::vector<RowTerms>& rows, Index unknownCount);

}  // namespace holdfast
