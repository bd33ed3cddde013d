// CHOLMOD's orders of elimination on the normal equations: its default, minimum degree, nested dissection. With each,
// CHOLMOD's factorisation and solves against our own.

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <cholmod.h>

#include <holdfast/base/cholmod_view_internal.h>
#include <holdfast/base/one_thread_internal.h>
#include <holdfast/factor/multifrontal.h>
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
    for (cholmod_dense** dense : {&ones_, &solution_, &work_[0], &work_[1]}) cholmod_free_dense(dense, &common_);
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
    if (ones_ == nullptr) ones_ = cholmod_ones(size_, 3, CHOLMOD_REAL, &common_);
    return cholmod_solve2(CHOLMOD_A, factor_, ones_, nullptr, &solution_, nullptr, &work_[0], &work_[1], &common_) != 0;
  }

  /// The column that is eliminated k-th.
  [[nodiscard]] std::vector<int> order() const
  {
    const int* const first = static_cast<const int*>(factor_->Perm);
    return {first, first + size_};
  }

  [[nodiscard]] double factorMiB() const { return common_.lnz * sizeof(double) / (1024 * 1024); }

 private:
  std::size_t size_;
  cholmod_sparse matrix_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* ones_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  std::array<cholmod_dense*, 2> work_{};
};

/// Seconds of one step; throws where it fails.
template <class Step>
double secondsOf(Step step)
{
  const auto [isDone, cost] = measure(step);
  if (!isDone) throw std::runtime_error("CHOLMOD failed");
  return cost.seconds;
}

/// The shortest of a few: the first solve also takes memory.
template <class Step>
double shortest(Step step)
{
  constexpr int kTimes = 5;
  double seconds = secondsOf(step);
  for (int k = 1; k < kTimes; ++k) seconds = std::min(seconds, secondsOf(step));
  return seconds;
}

/// Our own factorisation and solve in the same order.
void takeOwnTurn(Samples& samples, const std::string& row, const SparseMatrix& lower, const std::vector<int>& order)
{
  const auto [symbolic, analysis] =
      measure([&] { return std::make_shared<const SymbolicFactor>(analyze(lower, order)); });
  const auto [factor, factorization] = measure([&] { return factorizeMultifrontal(symbolic, lower); });
  if (!factor) throw std::runtime_error(factor.failure);
  std::vector<double> x(4 * order.size(), 1);
  const double solve = shortest([&] {
    factor.value->solve(x);
    return true;
  });
  samples.add(row, "s analyse own", analysis.seconds);
  samples.add(row, "s factorise own", factorization.seconds);
  samples.add(row, "s solve own", solve);
  samples.add(row, "GB/s solve own", 2e-9 * static_cast<double>(factor.value->bytes()) / solve);
}

void takeTurn(Samples& samples, const std::string& row, SparseMatrix& lower, int ordering)
{
  Ordered ordered(lower, ordering);
  const double analyze = secondsOf([&] { return ordered.analyze(); });
  const double factorize = secondsOf([&] { return ordered.factorize(); });
  const double solve = shortest([&] { return ordered.solve(); });
  samples.add(row, "s analyse", analyze);
  samples.add(row, "s factorise", factorize);
  samples.add(row, "s solve", solve);
  samples.add(row, "s +60 solves", analyze + factorize + kSolvesPerSession * solve);
  samples.add(row, "MiB factor", ordered.factorMiB());
  takeOwnTurn(samples, row, lower, ordered.order());
}

SparseMatrix normalEquations(const Model& model)
{
  const SetUp made = setUp(model, scene(model.mesh, {300, 300, 300}));
  const EliminatedConstraints eliminated = eliminate(made.system, model.solverMesh);
  return gramLower(scaleColumns(product(weightedRows(made.operators), eliminated.elimination.Q2())).value.C);
}

void orderings(benchmark::State& state, const BenchMesh& mesh)
{
  const OneThread libraries;  // as the solver calls CHOLMOD: it is slower with threads of its own
  SparseMatrix lower = normalEquations(mesh.load());
  Samples samples;
  const std::array<std::pair<const char*, int>, 4> kOrders{
      {{"default", Ordered::kDefault}, {"AMD", CHOLMOD_AMD}, {"METIS", CHOLMOD_METIS}, {"NESDIS", CHOLMOD_NESDIS}}};
  for ([[maybe_unused]] auto turn : state)
    for (const auto& [row, ordering] : kOrders) takeTurn(samples, row, lower, ordering);
  for (const auto& [row, ordering] : kOrders) {
    samples.addRatios(row, "= factorise own/CHOLMOD", "s factorise own", "s factorise");
    samples.addRatios(row, "= solve own/CHOLMOD", "s solve own", "s solve");
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
