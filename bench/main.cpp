// Runs the benchmarks and prints tables. Takes the options of Google Benchmark (--benchmark_filter=REGEX, ...).

#include <benchmark/benchmark.h>

#include "bench/benchmarks.h"
#include "bench/table_reporter.h"

int main(int argc, char** argv)
{
  using namespace holdfast::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  registerHardAgainstSoft();
  registerBackends();
  registerFrames();
  registerConstraintCounts();
  registerOverlappingPoints();
  registerVerdicts();
  registerClosestPoints();
#ifdef HOLDFAST_WITH_CHOLMOD
  registerOrderings();
#endif
  TableReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
}
