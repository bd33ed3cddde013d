#pragma once
/// \file
/// Rows that repeat others and agree with them only as far as rounding goes, met together.

#include <vector>

#include <holdfast/elimination/block_elimination.h>

namespace holdfast {

/// As `BlockElimination::particular`, with `redundant` rows of `rows` met as well: see
/// `Elimination::reconciledParticular`.
[[nodiscard]] Columns3 reconciled(const BlockElimination& elimination, const std::vector<RowTerms>& rows,
                                  const std::vector<Index>& redundant, const Columns3& d);

}  // namespace holdfast
