#include "holdfast/factor/multifrontal.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include <fmt/format.h>

#include <holdfast/factor/dense_kernels_internal.h>
#include <holdfast/factor/strips.h>
#include <holdfast/memory/available_memory.h>
#include <holdfast/memory/large_memory.h>
#include <holdfast/numbers/no_subnormals_internal.h>
#include <holdfast/threads/long_step.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr int kAllPositive = -1;

int stripCount(int columns)
{
  return (columns + kStripWidth - 1) / kStripWidth;
}

/// Runs turns of a loop one after the other, or over all cores. `work` takes the turn and the number of the thread.
class Loop {
 public:
  explicit Loop(bool isParallel) : isParallel_(isParallel) {}

  template <class Work>
  void operator()(int count, const Work& work) const
  {
    if (isParallel_ && count > 1)
      parallelFor(count, [&](Index k, Index thread) { work(static_cast<int>(k), thread); });
    else
      for (int k = 0; k < count; ++k) work(k, 0);
  }

 private:
  bool isParallel_;
};

/// C <- scale C - sign A A1^T for n rows of A, A1 the first `width` of them; above its diagonal C is not used.
void updateColumns(int n, int width, int k, double sign, const double* A, int ldA, double scale, double* C, int ldC)
{
  denseKernels().symmetricUpdate(width, k, -sign, A, ldA, scale, C, ldC);
  if (n > width) denseKernels().update(n - width, width, k, -sign, A + width, A, ldA, scale, C + width, ldC);
}

/// The end of the block of columns of a panel that is factorised at once: in one strip, with one sign in S.
int blockEnd(int first, const Supernode& node)
{
  const int positive = node.width - node.multipliers;
  return std::min(stripOf(first) + kStripWidth, first < positive ? positive : node.width);
}

double signOf(int column, const Supernode& node)
{
  return column < node.width - node.multipliers ? 1 : -1;
}

/// Factorises the columns of a panel, block by block. Returns the place of the first pivot of another sign than S has,
/// from 1; 0 where there is none.
int factorizePanel(const Loop& loop, double* panel, const Supernode& node)
{
  const int height = node.height();
  int end = 0;
  for (int first = 0; first < node.width; first = end) {
    end = blockEnd(first, node);
    const int columns = end - first;
    const int ld = height - stripOf(first);
    const double sign = signOf(first, node);
    double* const corner = panel + placeInStrips(first, first, height);
    if (sign < 0)  // L11 L11^T = -F11, L21 = -F21 L11^-T
      for (int j = first; j < end; ++j) {
        double* const column = panel + placeInStrips(j, j, height);
        std::transform(column, column + (height - j), column, std::negate());
      }
    if (const int bad = denseKernels().cholesky(columns, corner, ld); bad != 0) return first + bad;
    loop(stripCount(height - end), [&](int strip, Index /*thread*/) {
      const int row = end + strip * kStripWidth;
      denseKernels().solveRight(std::min(kStripWidth, height - row), columns, corner, ld,
                                panel + placeInStrips(row, first, height), ld);
    });
    loop(stripCount(node.width - stripOf(end)), [&](int strip, Index /*thread*/) {
      const int behind = stripOf(end) + strip * kStripWidth;
      const int column = std::max(end, behind);
      const int count = std::min(behind + kStripWidth, node.width) - column;
      if (count <= 0) return;
      updateColumns(height - column, count, columns, sign, panel + placeInStrips(column, first, height), ld, 1,
                    panel + placeInStrips(column, column, height), height - behind);
    });
  }
  return 0;
}

/// The columns of M from `first` on. Eigen's own copy needs rows that ascend.
SparseMatrix columnsFrom(int first, const SparseMatrix& M)
{
  const int* const start = M.outerIndexPtr() + first;
  SparseMatrix result(M.rows(), M.cols() - first);
  std::transform(start, start + result.cols() + 1, result.outerIndexPtr(), [&](int entry) { return entry - *start; });
  result.resizeNonZeros(result.outerIndexPtr()[result.cols()]);
  std::copy_n(M.innerIndexPtr() + *start, result.nonZeros(), result.innerIndexPtr());
  std::copy_n(M.valuePtr() + *start, result.nonZeros(), result.valuePtr());
  return result;
}

/// What a thread computes supernodes in.
struct FrontWorkspace {
  std::vector<int> placeOf;              // of a column: its row in the front
  std::vector<std::vector<int>> places;  // of the rows of each child: theirs
  ReusedMemory::Array panel;
};

/// Entries of L, and of the updates that are kept at the same time at most where one thread works.
std::int64_t mostNumbers(const SymbolicFactor& symbolic)
{
  std::int64_t kept = 0;
  std::int64_t most = 0;
  const auto updateOf = [](const Supernode& node) { return numbersInStrips(node.rowCount, node.rowCount); };
  for (std::size_t s = 0; s < symbolic.supernodes.size(); ++s) {
    kept += updateOf(symbolic.supernodes[s]);
    most = std::max(most, kept);
    for (const int child : symbolic.children[s]) kept -= updateOf(symbolic.supernodes[child]);
  }
  return symbolic.nonzeros() + most;
}

class Multifrontal {
 public:
  Multifrontal(const std::shared_ptr<const SymbolicFactor>& symbolic, SparseMatrix lower)
      : symbolic_(*symbolic),
        lower_(std::move(lower)),
        updates_(symbolic->supernodes.size()),
        result_(std::make_unique<PackedFactor>(symbolic))
  {
  }

  /// The place of the first pivot that is not positive, or `kAllPositive`. Throws `LeftBehind`.
  int run()
  {
    // One factorisation at a time: each keeps all cores busy, and needs memory for its fronts.
    static std::mutex computing;
    const std::scoped_lock lock(computing);
    step_->stopIfLeftBehind();
    const NoSubnormals arithmetic;  // L falls off exponentially where much is held
    std::vector<FrontWorkspace> workspaces(static_cast<std::size_t>(threadCount()));
    const std::vector<SupernodeRange>& subtrees = symbolic_.subtrees;
    parallelFor(static_cast<Index>(subtrees.size()),
                [&](Index k, Index thread) { factorize(subtrees[k], workspaces[thread], Loop(false)); });
    workspaces.resize(1);
    firstKept_ = symbolic_.topColumn();
    lower_ = columnsFrom(firstKept_, lower_);
    factorize(symbolic_.top, workspaces[0], Loop(true));
    step_->stopIfLeftBehind();
    return badPivot_;
  }

  [[nodiscard]] std::unique_ptr<const PackedFactor> result() { return std::move(result_); }

 private:
  void factorize(const SupernodeRange& range, FrontWorkspace& work, const Loop& loop)
  {
    work.placeOf.resize(symbolic_.order.size());
    for (int s = range.begin; s < range.end && badPivot_ == kAllPositive && !step_->isLeftBehind(); ++s) {
      factorize(s, work, loop);
      done_ += flopsOf(symbolic_.supernodes[s].width, symbolic_.supernodes[s].rowCount);
      step_->setShare(done_ / flops_);
    }
  }

  void factorize(int s, FrontWorkspace& work, const Loop& loop)
  {
    const Supernode& node = symbolic_.supernodes[s];
    findPlaces(s, work);
    work.panel = memory_.take(static_cast<std::size_t>(numbersInStrips(node.width, node.height())));
    loop(stripCount(node.width), [&](int strip, Index /*thread*/) {
      const int first = strip * kStripWidth;
      const FrontPart part{work.panel.get() + placeInStrips(first, first, node.height()), node.height() - first, first,
                           std::min(first + kStripWidth, node.width)};
      addEntries(node, part, work);
      addChildren(s, part, work);
    });
    if (node.rowCount == 0) dropChildren(s);
    if (const int bad = factorizePanel(loop, work.panel.get(), node); bad != 0) {
      int none = kAllPositive;
      badPivot_.compare_exchange_strong(none, node.firstColumn + bad - 1);
      return;
    }
    storeAndUpdate(s, work, loop);
    work.panel.reset();
    dropChildren(s);
  }

  void dropChildren(int s)
  {
    for (const int child : symbolic_.children[s]) updates_[child].reset();
    if (s >= symbolic_.top.begin) memory_.returnGaps();
  }

  /// Stores the columns, and keeps what the supernode and those below it take off its parents. Strips stay in the
  /// cache.
  void storeAndUpdate(int s, FrontWorkspace& work, const Loop& loop)
  {
    const Supernode& node = symbolic_.supernodes[s];
    const int rows = node.rowCount;
    updates_[s] = memory_.take(static_cast<std::size_t>(numbersInStrips(rows, rows)));
    loop(stripCount(rows) + stripCount(node.width), [&](int strip, Index /*thread*/) {
      const int first = strip * kStripWidth;
      if (first >= rows) return result_->store(s, strip - stripCount(rows), work.panel.get());
      const int row = node.width + first;
      const int width = std::min(kStripWidth, rows - first);
      double* const numbers = updates_[s].get() + placeInStrips(first, first, rows);
      for (int column = 0, end = 0; column < node.width; column = end) {
        end = blockEnd(column, node);
        updateColumns(rows - first, width, end - column, signOf(column, node),
                      work.panel.get() + placeInStrips(row, column, node.height()), node.height() - stripOf(column),
                      column == 0 ? 0 : 1, numbers, rows - first);
      }
      addChildren(s, {numbers, rows - first, row, row + width}, work);
    });
  }

  /// Finds the places of the rows of the front in it, and of those that its children have updated.
  void findPlaces(int s, FrontWorkspace& work)
  {
    const Supernode& node = symbolic_.supernodes[s];
    int place = 0;
    for (; place < node.width; ++place) work.placeOf[node.firstColumn + place] = place;
    for (const int row : symbolic_.rowsOf(node)) work.placeOf[row] = place++;
    const std::vector<int>& children = symbolic_.children[s];
    if (work.places.size() < children.size()) work.places.resize(children.size());
    for (std::size_t c = 0; c < children.size(); ++c) {
      work.places[c].clear();
      for (const int row : symbolic_.rowsOf(symbolic_.supernodes[children[c]]))
        work.places[c].push_back(work.placeOf[row]);
    }
  }

  /// Columns [first, end) of a front, from row `first` on, `height` apart.
  struct FrontPart {
    double* numbers = nullptr;
    int height = 0;
    int first = 0;
    int end = 0;
  };

  /// Makes the numbers of a part of a supernode's front: entries of M, and zeros.
  void addEntries(const Supernode& node, const FrontPart& part, const FrontWorkspace& work)
  {
    double* column = part.numbers;
    for (int k = part.first; k < part.end; ++k, column += part.height) {
      std::fill_n(column + (k - part.first), part.height - (k - part.first), 0.0);
      for (SparseMatrix::InnerIterator entry(lower_, node.firstColumn + k - firstKept_); entry; ++entry)
        column[work.placeOf[entry.row()] - part.first] += entry.value();
    }
  }

  /// Adds what the children of a supernode have kept to a part of its front.
  void addChildren(int s, const FrontPart& part, const FrontWorkspace& work)
  {
    for (std::size_t c = 0; c < symbolic_.children[s].size(); ++c) {
      const std::vector<int>& places = work.places[c];
      const double* const update = updates_[symbolic_.children[s][c]].get();
      const int size = static_cast<int>(places.size());
      const int begin = static_cast<int>(std::ranges::lower_bound(places, part.first) - places.begin());
      for (int j = begin; j < size && places[j] < part.end; ++j) {
        double* const to = part.numbers + static_cast<std::ptrdiff_t>(places[j] - part.first) * part.height;
        const double* const from = update + placeInStrips(j, j, size) - j;
        for (int i = j; i < size; ++i) to[places[i] - part.first] += from[i];
      }
    }
  }

  const SymbolicFactor& symbolic_;
  SparseMatrix lower_;  // columns that have not been added to a front yet, from `firstKept_` on
  int firstKept_ = 0;
  ReusedMemory memory_{static_cast<std::size_t>(mostNumbers(symbolic_))};
  /// What supernodes take off the rows below them, each a lower triangle, until their parents have added it.
  std::vector<ReusedMemory::Array> updates_;
  std::unique_ptr<PackedFactor> result_;
  std::shared_ptr<StepState> step_ = currentStep();
  double flops_ = symbolic_.flops();
  std::atomic<double> done_ = 0;
  std::atomic<int> badPivot_{kAllPositive};
};

}  // namespace

Result<std::unique_ptr<const PackedFactor>> factorizeMultifrontal(const std::shared_ptr<const SymbolicFactor>& symbolic,
                                                                  SparseMatrix lower)
{
  requireMemory(sizeof(double) * static_cast<std::uint64_t>(mostNumbers(*symbolic)),
                fmt::format("the factor of {} unknowns", symbolic->size()));
  Multifrontal multifrontal(symbolic, std::move(lower));
  if (const int bad = multifrontal.run(); bad != kAllPositive)
    return {nullptr, fmt::format("the normal equations are not positive definite in doubles (pivot {} of {})", bad + 1,
                                 symbolic->size())};
  return {multifrontal.result()};
}

}  // namespace holdfast
