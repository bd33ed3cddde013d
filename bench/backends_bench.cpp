// Factorisation and solution by each backend.

#include <string>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

void takeTurn(Samples& samples, const Model& model, const SetUp& made, const EliminatedConstraints& eliminated,
              Backend backend)
{
  const std::string kind(name(backend));
  const auto [solver, factorization] = measure([&] {
    return factorized(model, made, eliminated, {SolverKind::Hard, backend, 0});
  });
  samples.add("factorisation", "s " + kind, factorization.seconds);
  samples.add("factorisation", "MiB " + kind, factorization.peakMiB);
  samples.add("solution", "s " + kind, measure([&] { return solution(made, *solver); }).cost.seconds);
  samples.add("factor", "MiB " + kind, factorMiB(*solver));
}

void backends(benchmark::State& state, const BenchMesh& mesh)
{
  const Model model = mesh.load();
  const SetUp made = setUp(model, scene(model.mesh, {300, 300, 300}));
  const EliminatedConstraints eliminated = eliminate(made.system, model.solverMesh);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    for (const Backend backend : {Backend::Holdfast, Backend::Cholmod, Backend::Eigen})
      if (isBuilt(backend)) takeTurn(samples, model, made, eliminated, backend);
  }
  for (const Backend other : {Backend::Cholmod, Backend::Eigen})
    if (isBuilt(other))
      for (const char* row : {"factorisation", "solution"})
        samples.addRatios(row, "= holdfast/" + std::string(name(other)), "s holdfast", "s " + std::string(name(other)));
  samples.report(state);
}

}  // namespace

void registerBackends()
{
  for (const BenchMesh& mesh : benchMeshesUpTo(173))
    benchmark::RegisterBenchmark(("backends/" + mesh.name).c_str(), backends, mesh)
        ->Iterations(mesh.thousands > 100 ? 3 : 5)
        ->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench
