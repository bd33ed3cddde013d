#pragma once
/// \file
/// How far all unknowns move for a unit of change in what one row asks for, where bodies move as one.

#include <vector>

#include <holdfast/elimination/merged_unknowns.h>

namespace holdfast {

/// Raises `sensitivities`, one for each row and measured over bodies, to what they are over unknowns: the lengths of
/// the columns of the pseudo-inverse of B. `contracted` are the rows over `groups`, those in `others` independent of
/// one another; the difference rows that tie the bodies have no amplification before. Bodies that no other row names
/// take O(1) a row; a component of other rows takes an elimination, and one solution of it for each difference row
/// that separates its points.
void spreadOverMerged(std::vector<double>& sensitivities, const std::vector<RowTerms>& rows,
                      const std::vector<RowTerms>& contracted, const std::vector<Index>& others,
                      const MergedUnknowns& groups);

}  // namespace holdfast
