// Fig. 12 of the paper: what set-up, decomposition and solution cost with hard and with soft constraints.

#include <algorithm>
#include <string>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

constexpr PointCounts kPoints{300, 300, 300};
constexpr int kSolutionsPerTurn = 5;

void addCost(Samples& samples, const std::string& row, const std::string& kind, const Cost& cost)
{
  samples.add(row, "s " + kind, cost.seconds);
  samples.add(row, "MiB " + kind, cost.peakMiB);
}

void addFactorization(Samples& samples, const std::string& kind, const Cost& elimination, const Cost& factorization)
{
  addCost(samples, "2 decomposition", kind,
          {elimination.seconds + factorization.seconds, std::max(elimination.peakMiB, factorization.peakMiB)});
}

/// Set-up, decomposition and solutions by one solver.
void takeTurn(Samples& samples, const Model& model, const ConstraintList& constraints, SolverKind solverKind)
{
  const std::string kind(name(solverKind));
  const auto [made, setUpCost] = measure([&] { return setUp(model, constraints); });
  addCost(samples, "1 set-up", kind, setUpCost);

  const auto [eliminated, eliminationCost] = measure([&] { return eliminate(made.system, model.solverMesh); });
  const auto [solver, factorizationCost] = measure([&] {
    return factorized(model, made, eliminated, {solverKind, Backend::Holdfast, 5});
  });
  // Soft constraints need no elimination: it is charged to hard ones alone.
  addFactorization(samples, kind, solverKind == SolverKind::Hard ? eliminationCost : Cost{}, factorizationCost);
  samples.add("4 factor", "MiB " + kind, factorMiB(*solver));

  for (int k = 0; k < kSolutionsPerTurn; ++k)
    addCost(samples, "3 solution", kind, measure([&] { return solution(made, *solver); }).cost);
}

void hardAgainstSoft(benchmark::State& state, const BenchMesh& mesh)
{
  const Model model = mesh.load();
  const ConstraintList constraints = scene(model.mesh, kPoints);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, model, constraints, SolverKind::Hard);
    takeTurn(samples, model, constraints, SolverKind::Soft);
  }
  for (const char* row : {"1 set-up", "2 decomposition", "3 solution"})
    samples.addRatios(row, "= hard/soft", "s hard", "s soft");
  samples.report(state);
}

int turnsFor(const BenchMesh& mesh)
{
  if (mesh.thousands > 200) return 5;
  return mesh.thousands > 100 ? 7 : 11;
}

}  // namespace

void registerHardAgainstSoft()
{
  for (const BenchMesh& mesh : benchMeshes())
    benchmark::RegisterBenchmark(("hard against soft constraints/" + mesh.name).c_str(), hardAgainstSoft, mesh)
        ->Iterations(turnsFor(mesh))
        ->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench
