// Our factorisation, solves and frames of a drag against CHOLMOD's factorisation and solves in its best order, beside
// those of MUMPS, and against what the machine can read and multiply.

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <cholmod.h>
#include <dlfcn.h>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/matrices/cholmod_view_internal.h>
#include <holdfast/threads/one_thread_internal.h>
#include <holdfast/threads/parallel.h>

#include "bench/benchmarks.h"
#include "bench/dragged_mesh.h"
#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/mumps_factor.h"
#include "bench/samples.h"
#include "bench/scenes.h"
#include "bench/steps.h"

namespace holdfast::bench {
namespace {

// Of which the shortest counts: the first also takes memory.
constexpr int kFactorizations = 2;
constexpr int kSolves = 5;

/// CHOLMOD's supernodal factorisation in one of its orders.
class CholmodFactor {
 public:
  CholmodFactor(SparseMatrix& lower, int ordering) : matrix_(cholmodView(lower, StoredPart::LowerTriangle))
  {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = ordering;
    factor_ = cholmod_analyze(&matrix_, &common_);
    ones_ = cholmod_ones(matrix_.nrow, 3, CHOLMOD_REAL, &common_);
  }
  ~CholmodFactor()
  {
    cholmod_free_factor(&factor_, &common_);
    for (cholmod_dense** dense : {&ones_, &solution_, &work_[0], &work_[1]}) cholmod_free_dense(dense, &common_);
    cholmod_finish(&common_);
  }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  void factorize()
  {
    cholmod_factorize(&matrix_, factor_, &common_);
    if (common_.status != CHOLMOD_OK) throw std::runtime_error("CHOLMOD cannot factorise");
  }
  void solve()
  {
    cholmod_solve2(CHOLMOD_A, factor_, ones_, nullptr, &solution_, nullptr, &work_[0], &work_[1], &common_);
  }
  [[nodiscard]] double entries() const { return common_.lnz; }
  [[nodiscard]] double operations() const { return common_.fl; }

 private:
  cholmod_sparse matrix_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* ones_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  std::array<cholmod_dense*, 2> work_{};
};

/// While this lives, OpenBLAS and CHOLMOD start threads for all cores; else each call computes on the thread that makes
/// it, as in the program.
class LibraryThreads {
 public:
  LibraryThreads() { setBlasThreads(static_cast<int>(threadCount())); }
  ~LibraryThreads() { setBlasThreads(1); }
  LibraryThreads(const LibraryThreads&) = delete;
  LibraryThreads& operator=(const LibraryThreads&) = delete;

 private:
  static void setBlasThreads(int count)
  {
    if (auto* const set = reinterpret_cast<void (*)(int)>(::dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set(count);
  }
};

double operationsOf(const SymbolicFactor& symbolic)
{
  double operations = 0;
  for (const Supernode& node : symbolic.supernodes)
    for (int k = 0; k < node.width; ++k) operations += static_cast<double>(node.height() - k) * (node.height() - k);
  return operations;
}

/// Figures of a factor, as one row of the table.
struct Figures {
  double factorize = 0;  ///< seconds
  double solve = 0;      ///< seconds
  double entries = 0;
  double operations = 0;

  [[nodiscard]] double bytesPerSecond() const { return 2 * sizeof(double) * entries / solve; }
  [[nodiscard]] double operationsPerSecond() const { return operations / factorize; }

  void addTo(Samples& samples, const std::string& row) const
  {
    samples.add(row, "s factorise", factorize);
    samples.add(row, "ms solve", 1000 * solve);
    samples.add(row, "M entries", 1e-6 * entries);
    samples.add(row, "GFlop/s", 1e-9 * operationsPerSecond());
    samples.add(row, "GB/s", 1e-9 * bytesPerSecond());
  }
};

template <class Factor>
Figures figuresOf(Factor& factor)
{
  const double factorize = shortest(kFactorizations, [&] { factor.factorize(); });
  return {factorize, shortest(kSolves, [&] { factor.solve(); }), factor.entries(), factor.operations()};
}

/// The rows of a library's factorisation that `analyze` makes, and its shortest times.
template <class Analyze>
Figures takeLibrarysTurn(Samples& samples, const std::string& name, const Analyze& analyze)
{
  decltype(analyze()) factor;
  samples.add(name + ", one thread", "s analyse", secondsOf([&] { factor = analyze(); }));
  Figures one;
  {
    const OneThread libraries;
    one = figuresOf(*factor);
  }
  const LibraryThreads libraries;
  const Figures all = figuresOf(*factor);
  one.addTo(samples, name + ", one thread");
  all.addTo(samples, name + ", all threads");
  return {std::min(one.factorize, all.factorize), std::min(one.solve, all.solve)};
}

/// CHOLMOD's rows of the table, and its shortest times.
Figures takeCholmodsTurn(Samples& samples, SparseMatrix& lower)
{
  const auto turnOf = [&](const std::string& name, int ordering) {
    return takeLibrarysTurn(samples, name, [&] { return std::make_unique<CholmodFactor>(lower, ordering); });
  };
  const Figures amd = turnOf("AMD", CHOLMOD_AMD);
  const Figures metis = turnOf("METIS", CHOLMOD_METIS);
  return {std::min(amd.factorize, metis.factorize), std::min(amd.solve, metis.solve)};
}

Figures takeOwnTurn(Samples& samples, const SparseMatrix& lower)
{
  std::vector<int> order(static_cast<std::size_t>(lower.cols()));  // the matrix has it already
  std::iota(order.begin(), order.end(), 0);
  std::shared_ptr<const SymbolicFactor> symbolic;
  SparseMatrix ordered = lower;
  samples.add("own", "s analyse",
              secondsOf([&] { symbolic = std::make_shared<const SymbolicFactor>(analyze(ordered, order)); }));
  Result<std::unique_ptr<const PackedFactor>> factor;
  const double factorize = shortest(kFactorizations, [&] {
    factor.value.reset();
    factor = factorizeMultifrontal(symbolic, inOrder(lower, symbolic->order));
  });
  if (!factor) throw std::runtime_error(factor.failure);
  // As with CHOLMOD, right-hand sides and solutions are in the order of the matrix.
  const Columns3 ones = Columns3::Ones(lower.cols(), 3);
  Columns3 solution = ones;
  std::vector<double> x(4 * order.size());
  const auto place = [&](Index k) { return Eigen::Map<Eigen::RowVector3d>(&x[4 * k]); };
  const double solve = shortest(kSolves, [&] {
    parallelBlocks(lower.cols(), [&](Index k) { place(k) = ones.row(symbolic->order[k]); });
    factor.value->solveForward(x);
    factor.value->solveBackward(x);
    parallelBlocks(lower.cols(), [&](Index k) { solution.row(symbolic->order[k]) = place(k); });
  });
  const Figures own{factorize, solve, static_cast<double>(symbolic->nonzeros()), operationsOf(*symbolic)};
  own.addTo(samples, "own");
  return own;
}

}  // namespace

void againstCholmod(benchmark::State& state, const Mesh& mesh)
{
  const ConstraintList list = scene(mesh);
  DraggedMesh dragged(mesh);
  dragged.deform(list);
  SparseMatrix lower = normalEquations(dragged.model(), list);
  Samples samples;
  for ([[maybe_unused]] auto turn : state) {
    const double frame = dragged.frame(list);
    const double read = bytesReadPerSecond();
    const double multiplied = operationsPerSecond();
    const Figures cholmod = takeCholmodsTurn(samples, lower);
    takeLibrarysTurn(samples, "MUMPS", [&] { return std::make_unique<MumpsFactor>(lower); });
    const Figures own = takeOwnTurn(samples, lower);
    samples.add("own", "= GB/s", own.bytesPerSecond() / read);
    samples.add("own", "= GFlop/s", own.operationsPerSecond() / multiplied);
    samples.add("own", "= factorise", own.factorize / cholmod.factorize);
    samples.add("own", "= solve", own.solve / cholmod.solve);
    samples.add("machine", "GB/s", 1e-9 * read);
    samples.add("machine", "GFlop/s", 1e-9 * multiplied);
    samples.add("own", "ms frame", 1000 * frame);
    samples.add("own", "= frame", frame / cholmod.solve);
  }
  samples.report(state);
}

}  // namespace holdfast::bench
