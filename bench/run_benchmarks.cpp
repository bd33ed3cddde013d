#include "bench/run_benchmarks.h"

#include <algorithm>

#include <holdfast/io/mesh_file.h>
#include <holdfast/memory/large_memory.h>

#include "bench/bumpy_mesh.h"
#include "bench/table_reporter.h"

namespace holdfast::bench {
namespace {

/// Returns as many turns as fit into a minute, and one where nothing but the benchmark itself can be measured.
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

int runBenchmarks(const std::vector<Benchmark>& all, int argc, char** argv)
{
  keepFreedMemory();  // as the window does
  benchmark::Initialize(&argc, argv);
  const std::vector<std::string> meshes(argv + 1, argv + argc);
  for (const Benchmark& chosen : all)
    for (const std::string& mesh : meshes.empty() ? chosen.meshes : meshes) registerOne(chosen, mesh);
  TableReporter reporter;
  return benchmark::RunSpecifiedBenchmarks(&reporter) > 0 ? 0 : 1;
}

}  // namespace holdfast::bench
