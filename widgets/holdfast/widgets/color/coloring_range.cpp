#include "holdfast/widgets/color/coloring_range.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace holdfast {
namespace {

struct RangeFault {
  std::string operator()(AutomaticRange) const { return {}; }

  std::string operator()(const FixedRange& range) const
  {
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || !std::isfinite(range.high - range.low))
      return "the ends of the range are not finite numbers; give two that are";
    return range.low < range.high ? "" : "the range does not end above where it begins; give a larger end";
  }

  std::string operator()(const LogarithmicRange& range) const
  {
    return range.decades >= 1 ? "" : "the range has no decade; give one or more";
  }
};

struct RangeSetter {
  const std::vector<double>& values;
  ColorScale& scale;

  void operator()(AutomaticRange) const {}

  void operator()(const FixedRange& range) const
  {
    scale.low = range.low;
    scale.high = range.high;
    if (range.low <= 0) scale.scaling = Scaling::Linear;
  }

  void operator()(const LogarithmicRange& range) const
  {
    double largest = 0;
    for (const double value : values)
      if (std::isfinite(value)) largest = std::max(largest, value);
    if (largest == 0) return;
    const double end = std::ceil(std::log10(largest));
    const double low = std::pow(10, end - range.decades);
    if (low == 0 || !std::isfinite(std::pow(10, end))) return;
    scale.scaling = Scaling::Logarithmic;
    scale.low = low;
    scale.high = std::pow(10, end);
  }
};

}  // namespace

std::string whyNoRange(const ColorRange& range)
{
  return std::visit(RangeFault{}, range);
}

Coloring withRange(Coloring coloring, const ColorRange& range)
{
  assert(whyNoRange(range).empty());
  std::visit(RangeSetter{coloring.values, coloring.scale}, range);
  return coloring;
}

}  // namespace holdfast
