// Runs the benchmarks and prints tables.
//   holdfast_bench [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]
// MESH: a file of triangles, or how many thousand vertices a generated mesh has. Without: those of each benchmark.

#include <exception>
#include <iostream>

#include "bench/benchmarks.h"
#include "bench/run_benchmarks.h"

int main(int argc, char** argv)
try {
  using namespace holdfast::bench;
  // The batch program first: what is resident here counts in its peak.
  return runBenchmarks({{"batch program", batchProgram, {"35", "173", "438"}},
                        {"hard against soft", hardAgainstSoft, {"35", "173", "438"}},
                        {"against CHOLMOD", againstCholmod, {"35", "173", "438", "1000"}},
                        {"edits of constraints", editsOfConstraints, {"35", "173", "438", "1000"}},
                        {"many points", manyPoints, {"1000"}},
                        {"random points", randomPoints, {"156"}},
                        {"verdicts", verdicts, {"438"}},
                        {"checks of results", resultChecks, {"35", "173", "438"}},
                        {"freedom", freedom, {"173"}},
                        {"many boxes", manyBoxes, {"173"}},
                        {"held-out noise", heldOutNoise, {"20"}},
                        {"one core against all", oneCoreAgainstAll, {"35", "173"}},
                        {"accuracy", accuracy, {"35", "173"}}},
                       argc, argv);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
