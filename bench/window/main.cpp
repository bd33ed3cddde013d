// How long the window takes to answer. Needs a display: tests/support/with_display.sh.
//   holdfast_window_bench [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]
// MESH: as in holdfast_bench.

#include <exception>
#include <iostream>

#include "bench/run_benchmarks.h"
#include "bench/window/benchmarks.h"
#include "window/isolated_application.h"

int main(int argc, char** argv)
try {
  using namespace holdfast;
  const test::IsolatedApplication application(argc, argv, "holdfast-bench");
  return bench::runBenchmarks({{"drag in the window", bench::dragInTheWindow, {"35", "173"}}}, argc, argv);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
