#include "holdfast/widgets/color/histogram.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace holdfast {
namespace {

constexpr double kMostCountTicks = 5;

// A share of the largest value: multiples of finer widths would be the same numbers.
constexpr double kLeastRange = 1e-12;

double roundDegrees(double least)
{
  if (least <= 5) return roundStep(least);
  for (const double degrees : {15.0, 45.0, 90.0, 180.0})
    if (degrees >= least) return degrees;
  return 360 * roundStep(std::max(1.0, least / 360));
}

void count(Histogram& histogram, std::span<const double> values)
{
  histogram.counts.assign(histogram.edges.empty() ? 0 : histogram.edges.size() - 1, 0);
  for (const double value : values)
    if (const auto bin = binOf(histogram, value)) {
      ++histogram.counts[*bin];
      ++histogram.valueCount;
    }
}

}  // namespace

Histogram linearHistogram(std::span<const double> values, TickSteps steps, Index mostBins)
{
  assert(mostBins >= 2);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values)
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  Histogram histogram;
  if (low <= high) {
    // Beginning at a multiple of the width costs up to one bin. Values that are all the same have no range.
    const double size = std::max(std::abs(low), std::abs(high));
    const double range = high > low ? std::max(high - low, kLeastRange * size) : std::max(1.0, size);
    const double least = range / static_cast<double>(mostBins - 1);
    const double width = steps == TickSteps::Degrees ? roundDegrees(least) : roundStep(least);
    double first = std::floor(low / width);
    // The quotient may have been rounded up to a whole number.
    if (first * width > low) --first;
    for (double k = first; histogram.edges.size() < 2 || histogram.edges.back() < high; ++k)
      histogram.edges.push_back(k * width);
  }
  count(histogram, values);
  return histogram;
}

Histogram logarithmicHistogram(std::span<const double> values, int firstPower, int leastLastPower)
{
  assert(firstPower < leastLastPower);
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  Histogram histogram{Scaling::Logarithmic, {0}, {}};
  for (int power = firstPower; power <= leastLastPower || histogram.edges.back() < largest; ++power)
    histogram.edges.push_back(std::pow(10, power));
  count(histogram, values);
  return histogram;
}

std::optional<Index> binOf(const Histogram& histogram, double value)
{
  const std::vector<double>& edges = histogram.edges;
  if (edges.size() < 2 || !(value >= edges.front() && value <= edges.back()) || std::isinf(value)) return std::nullopt;
  const auto above = std::upper_bound(edges.begin(), edges.end() - 1, value);
  return static_cast<Index>(above - edges.begin()) - 1;
}

std::vector<Index> placesInBin(const Histogram& histogram, std::span<const double> values, Index bin)
{
  std::vector<Index> places;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (binOf(histogram, values[k]) == bin) places.push_back(static_cast<Index>(k));
  return places;
}

double placeAmongBins(const Histogram& histogram, double value)
{
  const std::vector<double>& edges = histogram.edges;
  if (edges.size() < 2) return 0;
  const double inside = std::clamp(value, edges.front(), edges.back());
  const Index bin = binOf(histogram, inside).value();
  const double low = edges[bin];
  const double high = edges[bin + 1];
  // Nothing is said of where in the first bin of a logarithmic histogram a value is: it reaches down to 0.
  const double within = histogram.scaling == Scaling::Logarithmic && low > 0
                            ? std::log10(inside / low) / std::log10(high / low)
                            : (inside - low) / (high - low);
  return static_cast<double>(bin) + within;
}

std::vector<Tick> edgeTicks(const Histogram& histogram, Index most)
{
  std::vector<Tick> ticks;
  const auto bins = static_cast<Index>(histogram.counts.size());
  const Index step = std::max<Index>(1, (bins + most - 1) / std::max<Index>(1, most));
  for (Index k = 0; bins > 0 && k <= bins; k += step) {
    const double edge = histogram.edges[k];
    const bool isPower = histogram.scaling == Scaling::Logarithmic && edge > 0 && edge != 1;
    ticks.push_back({static_cast<double>(k),
                     isPower ? fmt::format("1e{}", std::lround(std::log10(edge))) : fmt::format("{:.6g}", edge)});
  }
  return ticks;
}

std::vector<Tick> countTicks(Index largest)
{
  const double step = std::max(1.0, roundStep(std::max(1.0, static_cast<double>(largest)) / kMostCountTicks));
  std::vector<Tick> ticks;
  for (double k = 0; k * step <= static_cast<double>(std::max<Index>(largest, 1)); ++k)
    ticks.push_back({k * step, fmt::format("{:.0f}", k * step)});
  return ticks;
}

}  // namespace holdfast
