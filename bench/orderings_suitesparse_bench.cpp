// CHOLMOD's orders of elimination on the normal equations: its default, minimum degree, nested dissection.

#include <stdexcept>
#include <string>

#include <cholmod.h>

#include <holdfast/base/cholmod_view_internal.h>
#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/gram.h>

#include "bench/bench_meshes.h"
#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

// A decomposition and a drag of 30 steps, each of which solves and corrects: what a user waits for.
constexpr double kSolvesPerSession = 60;

/// One supernodal factorisation by one order.
class Ordered {
 public:
  /// `ordering` is one of CHOLMOD's, or `kDefault`.
  Ordered(SparseMatrix& lower, int ordering)
      : size_(static_cast<std::size_t>(lower.rows())), matrix_(cholmodView(lower, StoredPart::LowerTriangle))
  {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    if (ordering == kDefault) return;
    common_.nmethods = 1;
    common_.method[0].ordering = ordering;
  }
  ~Ordered()
  {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  Ordered(const Ordered&) = delete;
  Ordered& operator=(const Ordered&) = delete;

  static constexpr int kDefault = -1;

  bool analyze()
  {
    factor_ = cholmod_analyze(&matrix_, &common_);
    return factor_ != nullptr;
  }
  bool factorize()
  {
    cholmod_factorize(&matrix_, factor_, &common_);
    return common_.status == CHOLMOD_OK;
  }
  bool solve()
  {
    cholmod_dense* ones = cholmod_ones(size_, 3, CHOLMOD_REAL, &common_);
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, ones, &common_);
    const bool isSolved = solution != nullptr;
    cholmod_free_dense(&ones, &common_);
    cholmod_free_dense(&solution, &common_);
    return isSolved;
  }

  [[nodiscard]] double factorMiB() const { return common_.lnz * sizeof(double) / (1024 * 1024); }

 private:
  std::size_t size_;
  cholmod_sparse matrix_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

/// Seconds of one step; throws where it fails.
template <class Step>
double secondsOf(Step step)
{
  const auto [isDone, cost] = measure(step);
  if (!isDone) throw std::runtime_error("CHOLMOD failed");
  return cost.seconds;
}

void takeTurn(Samples& samples, const std::string& row, SparseMatrix& lower, int ordering)
{
  Ordered ordered(lower, ordering);
  const double analyze = secondsOf([&] { return ordered.analyze(); });
  const double factorize = secondsOf([&] { return ordered.factorize(); });
  const double solve = secondsOf([&] { return ordered.solve(); });
  samples.add(row, "s analyse", analyze);
  samples.add(row, "s factorise", factorize);
  samples.add(row, "s solve", solve);
  samples.add(row, "s +60 solves", analyze + factorize + kSolvesPerSession * solve);
  samples.add(row, "MiB factor", ordered.factorMiB());
}

SparseMatrix normalEquations(const Model& model)
{
  const SetUp made = setUp(model, scene(model.mesh, {300, 300, 300}));
  const EliminatedConstraints eliminated = eliminate(made.system, model.solverMesh);
  return gramLower(*scaleColumns(weightedRows(made.operators) * eliminated.elimination.Q2()).C);
}

void orderings(benchmark::State& state, const BenchMesh& mesh)
{
  SparseMatrix lower = normalEquations(mesh.load());
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    takeTurn(samples, "default", lower, Ordered::kDefault);
    takeTurn(samples, "AMD", lower, CHOLMOD_AMD);
    takeTurn(samples, "METIS", lower, CHOLMOD_METIS);
    takeTurn(samples, "NESDIS", lower, CHOLMOD_NESDIS);
  }
  samples.report(state);
}

}  // namespace

void registerOrderings()
{
  for (const BenchMesh& mesh : benchMeshes())
    benchmark::RegisterBenchmark(("orderings/" + mesh.name).c_str(), orderings, mesh)
        ->Iterations(mesh.thousands > 100 ? 3 : 5)
        ->Unit(benchmark::kSecond);
}

}  // namespace holdfast::bench
