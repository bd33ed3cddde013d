#pragma once
/// The dependent rows of a component too large for a dense QR.

#include <vector>

#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {

/// Components of more rows or unknowns than that are large: a dense QR of so many takes some tenths of a second.
inline constexpr std::size_t kMostSequentialRows = 512;

/// Rows that are closer than this to the span of others wait: rows behind them that can stand in their places do, and
/// this is the distance of their dependencies. A basis of less close rows keeps its digits where circuits lead through
/// many faces.
inline constexpr double kWaitingDistance = 1e-10;

/// The same in a large component. There rows that are as close at the end are left out.
inline constexpr double kCrowdedDistance = 1e-8;

/// `findDependencies` of one component. In the order of the rows, more of them than unknowns that they name depend
/// whatever their coefficients are (`matchedRows`), and rows on the same unknowns are judged among themselves. What is
/// left is independent but for few rows, which are looked for (`nearlyDependentRows`). Where these are thousands, as
/// in points that are listed row by row over a patch, the order cannot be had in doubles: then the rows are taken in
/// strides, the first of each 2^k, then those in the middle between, and so on. With a larger tolerance than
/// `kCrowdedDistance` rows of a large component go without others in their places.
[[nodiscard]] std::vector<Dependency> sparseDependencies(const std::vector<RowTerms>& rows,
                                                         const RowComponent& component,
                                                         double tolerance = kRankTolerance);

}  // namespace holdfast
