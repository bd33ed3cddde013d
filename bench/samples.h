#pragma once
/// \file
/// Numbers collected over the turns of a benchmark, and the tables made of them.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

namespace holdfast::bench {

/// The middle of `values` (the mean of the two in the middle of an even number); NaN of none.
[[nodiscard]] double median(std::vector<double> values);

/// Cells of a table, each with one number a turn.
class Samples {
 public:
  void add(const std::string& row, const std::string& column, double value) { cells_[{row, column}].push_back(value); }

  /// Turn for turn, the number in `column` over that in `base`.
  void addRatios(const std::string& row, const std::string& ratio, const std::string& column, const std::string& base);

  /// The medians as counters "row/column", which `TableReporter` sets as a table, rows and columns in alphabetic order.
  void report(benchmark::State& state) const;

 private:
  std::map<std::pair<std::string, std::string>, std::vector<double>> cells_;
};

}  // namespace holdfast::bench
