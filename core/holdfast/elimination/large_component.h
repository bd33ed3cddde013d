#pragma once
/// The dependent rows of a component too large for a dense QR.

#include <vector>

#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {

/// A component with more rows or unknowns than this is large. A dense QR of so many takes some tenths of a second.
inline constexpr std::size_t kMostSequentialRows = 512;

/// A row that is closer than this to the span of others waits. A row behind it takes its place where it can. Then this
/// is the distance of the waiting row's dependency. Where circuits lead through many faces, a basis of less close rows
/// keeps its digits.
inline constexpr double kWaitingDistance = 1e-10;

/// In a large component rows wait that are closer than this. Rows that are as close at the end are left out.
inline constexpr double kCrowdedDistance = 1e-9;

/// Does what `findDependencies` does, for one component. It goes through the rows in their order. Where rows are more
/// than the unknowns that they name, some depend whatever their coefficients are (`matchedRows`). Rows on the same
/// unknowns are judged among themselves. What is left is independent but for few rows, which `nearlyDependentRows`
/// looks for.
///
/// These can be thousands, as in points that are listed row by row over a patch. Then the order cannot be had in
/// doubles, and the rows are taken in strides. The first of each 2^k come first, then those in the middle between, and
/// so on.
///
/// With a larger tolerance than `kCrowdedDistance` no rows take the places of others in a large component.
[[nodiscard]] std::vector<Dependency> sparseDependencies(const std::vector<RowTerms>& rows,
                                                         const RowComponent& component,
                                                         double tolerance = kRankTolerance);

}  // namespace holdfast
