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

void Samples::addRatios(const std::string& name, const Cell& above, const Cell& below)
{
  const std::vector<double>& over = cells_.at(above);
  const std::vector<double>& under = cells_.at(below);
  for (std::size_t turn = 0; turn < over.size(); ++turn) add(above.first, name, over[turn] / under[turn]);
}

void Samples::report(benchmark::State& state) const
{
  for (const auto& [cell, values] : cells_) state.counters[cell.first + "/" + cell.second] = median(values);
}

}  // namespace holdfast::bench
