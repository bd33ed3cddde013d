#pragma once
/// \file
/// Results as tables for people. (`--benchmark_out=FILE --benchmark_out_format=json` writes them for programs.)

#include <string>

#include <benchmark/benchmark.h>

namespace holdfast::bench {

/// Prints one table a family: benchmarks are called "family/case", their counters "row/column".
class TableReporter final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  void reportRun(const Run& run);

  std::string family_;
};

}  // namespace holdfast::bench
