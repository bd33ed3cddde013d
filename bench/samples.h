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

/// Row and column.
using Cell = std::pair<std::string, std::string>;

/// Cells of a table, each with one number a turn.
class Samples {
 public:
  void add(const std::string& row, const std::string& column, double value) { cells_[{row, column}].push_back(value); }

  /// Turn for turn, the number of one cell over that of another, as column `name` in the row of the former.
  void addRatios(const std::string& name, const Cell& above, const Cell& below);

  /// The medians as counters "row/column", which `TableReporter` sets as a table, rows and columns in alphabetic order.
  void report(benchmark::State& state) const;

 private:
  std::map<Cell, std::vector<double>> cells_;
};

}  // namespace holdfast::bench
