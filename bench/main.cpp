// Runs the benchmarks and prints tables.
//   holdfast_bench [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]
// MESH: a file of triangles, or how many thousand vertices a generated mesh has. Without: those of each benchmark.

#include <algorithm>
#include <cctype>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <holdfast/io/mesh_file.h>

#include "bench/benchmarks.h"
#include "bench/bumpy_mesh.h"
#include "bench/table_reporter.h"

namespace holdfast::bench {
namespace {

struct Benchmark {
  const char* name;
  void (*measure)(benchmark::State& state, const Mesh& mesh);
  std::vector<std::string> meshes;
};

const std::vector<Benchmark>& allBenchmarks()
{
  static const std::vector<Benchmark> kAll{
      {"hard against soft", hardAgainstSoft, {"35", "173", "438"}},
      {"against CHOLMOD", againstCholmod, {"35", "173", "438", "1000"}},
      {"edits of constraints", editsOfConstraints, {"35", "173", "438", "1000"}},
      {"many points", manyPoints, {"1000"}},
      {"random points", randomPoints, {"156"}},
      {"verdicts", verdicts, {"438"}},
      {"one core against all", oneCoreAgainstAll, {"35", "173"}},
      {"batch program", batchProgram, {"35", "173", "438"}},
      {"accuracy", accuracy, {"35", "173"}},
  };
  return kAll;
}

/// As many as fit into a minute, and one where nothing but the benchmark itself can be measured.
Index turnsFor(Index thousands)
{
  return thousands < 10 ? 1 : std::clamp<Index>(600 / thousands, 1, 9);
}

/// One benchmark on one mesh.
void registerOne(const Benchmark& chosen, const std::string& mesh)
{
  constexpr Index kTurnsOfAFile = 3;
  const bool isGenerated = std::ranges::all_of(mesh, ::isdigit);
  const Index thousands = isGenerated ? std::stoll(mesh) : 0;
  const std::string subject = isGenerated ? mesh + "k" : mesh.substr(mesh.rfind('/') + 1);
  const auto run = [=, measure = chosen.measure](benchmark::State& state) {
    measure(state, isGenerated ? bumpyMesh(1000 * thousands) : readMesh(mesh).mesh);
  };
  benchmark::RegisterBenchmark((chosen.name + ("/" + subject)).c_str(), run)
      ->Iterations(isGenerated ? turnsFor(thousands) : kTurnsOfAFile)
      ->Unit(benchmark::kSecond);
}

}  // namespace
}  // namespace holdfast::bench

int main(int argc, char** argv)
try {
  benchmark::Initialize(&argc, argv);
  const std::vector<std::string> meshes(argv + 1, argv + argc);
  for (const auto& chosen : holdfast::bench::allBenchmarks())
    for (const std::string& mesh : meshes.empty() ? chosen.meshes : meshes) holdfast::bench::registerOne(chosen, mesh);
  holdfast::bench::TableReporter reporter;
  return benchmark::RunSpecifiedBenchmarks(&reporter) > 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
