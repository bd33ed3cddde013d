#include "bench/samples.h"

#include <algorithm>
#include <limits>

namespace holdfast::bench {

double median(std::vector<double> values)
{
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void Samples::addRatios(const std::string& row, const std::string& ratio, const std::string& column,
                        const std::string& base)
{
  const std::vector<double>& above = cells_.at({row, column});
  const std::vector<double>& below = cells_.at({row, base});
  for (std::size_t turn = 0; turn < above.size(); ++turn) add(row, ratio, above[turn] / below[turn]);
}

void Samples::report(benchmark::State& state) const
{
  for (const auto& [cell, values] : cells_) state.counters[cell.first + "/" + cell.second] = median(values);
}

}  // namespace holdfast::bench
