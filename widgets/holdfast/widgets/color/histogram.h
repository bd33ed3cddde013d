#pragma once
/// A histogram counts values in bins whose ends are round numbers.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/numbers/types.h>
#include <holdfast/widgets/color/scalar_legend.h>

namespace holdfast {

/// The counts of values in bins. Bin k holds the values from `edges[k]` up to, but not at, `edges[k + 1]`. The last bin
/// holds its end as well.
///
///     const Histogram histogram = linearHistogram(coloring.values, coloring.scale.steps, 40);
///     for (std::size_t k = 0; k < histogram.counts.size(); ++k)
///       std::cout << histogram.edges[k] << ": " << histogram.counts[k] << '\n';
struct Histogram {
  Scaling scaling = Scaling::Linear;
  std::vector<double> edges;  ///< ascending, one more than bins; the first one of a logarithmic histogram is 0
  std::vector<Index> counts;  ///< the number of values in each bin
  Index valueCount = 0;       ///< the number of values in all bins; NaN and infinities are left out
};

/// Counts `values` in bins that share one round width. There are at most `mostBins`, which is 2 or more, and none
/// without a value. `steps` says which widths are round. The difference of the highest and the lowest value must be a
/// finite double. O(values).
[[nodiscard]] Histogram linearHistogram(std::span<const double> values, TickSteps steps, Index mostBins);

/// Counts `values` in a bin for each power of ten. The first bin holds all that is below 10^`firstPower`, zero
/// included. The last one ends at 10^`leastLastPower`, or beyond that at the first power that no value exceeds.
/// `firstPower` is below `leastLastPower`. O(values).
[[nodiscard]] Histogram logarithmicHistogram(std::span<const double> values, int firstPower, int leastLastPower);

/// Returns the bin of a value. There is none for NaN and for values beyond the ends.
[[nodiscard]] std::optional<Index> binOf(const Histogram& histogram, double value);

/// Returns the places in `values` of those in one bin, ascending.
[[nodiscard]] std::vector<Index> placesInBin(const Histogram& histogram, std::span<const double> values, Index bin);

/// Returns the place of a value if every bin is one wide: 2.5 is the middle of the third bin. The value lies between
/// the ends.
[[nodiscard]] double placeAmongBins(const Histogram& histogram, double value);

/// Returns about `most` numbers, or fewer, for the edges of bins. The `value` of each is its place among bins.
[[nodiscard]] std::vector<Tick> edgeTicks(const Histogram& histogram, Index most);

/// Returns about five round counts, from 0 up to `largest`.
[[nodiscard]] std::vector<Tick> countTicks(Index largest);

}  // namespace holdfast
