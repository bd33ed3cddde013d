#pragma once
/// How many values lie where: counts in bins whose ends are round numbers.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/base/types.h>
#include <holdfast/widgets/color/scalar_legend.h>

namespace holdfast {

/// Bin k holds what is from `edges[k]` up to, but not at, `edges[k + 1]`; the last one its end as well.
struct Histogram {
  Scaling scaling = Scaling::Linear;
  std::vector<double> edges;    ///< ascending, one more than bins; the first of a logarithmic one is 0
  std::vector<Index> counts;    ///< of each bin
  Index valueCount = 0;         ///< in all bins: NaN and infinities are left out
  Index withoutValueCount = 0;  ///< what was left out
};

/// Bins of one round width over all values, `mostBins` of them or fewer; without a value none. `steps` says what is
/// round. From the lowest to the highest value must be less than the largest double. O(values).
[[nodiscard]] Histogram linearHistogram(std::span<const double> values, TickSteps steps, Index mostBins);

/// A bin for each power of ten. The first one holds all that is below 10^`firstPower`, zero included; the last one ends
/// at 10^`leastLastPower`, or beyond that at the first power that no value exceeds. O(values).
[[nodiscard]] Histogram logarithmicHistogram(std::span<const double> values, int firstPower, int leastLastPower);

/// The bin of a value; none for NaN and beyond the ends.
[[nodiscard]] std::optional<Index> binOf(const Histogram& histogram, double value);

/// The places in `values` of those in one bin, ascending.
[[nodiscard]] std::vector<Index> placesInBin(const Histogram& histogram, std::span<const double> values, Index bin);

/// Where a value is when all bins are one wide: 2.5 in the middle of the third one. Inside the ends.
[[nodiscard]] double placeAmongBins(const Histogram& histogram, double value);

/// Numbers for edges of bins, about `most` of them or fewer, `value` being the place among bins.
[[nodiscard]] std::vector<Tick> edgeTicks(const Histogram& histogram, Index most);

/// Round counts from 0 up to the largest, about five.
[[nodiscard]] std::vector<Tick> countTicks(Index largest);

}  // namespace holdfast
