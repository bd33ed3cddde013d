#include "holdfast/factor/multifrontal.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

#include <fmt/format.h>

#include <holdfast/base/long_step.h>
#include <holdfast/base/no_subnormals_internal.h>
#include <holdfast/base/one_thread_internal.h>
#include <holdfast/base/parallel.h>
#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast {
namespace {

// Blocks that dense matrices are taken apart into. They are fixed: which sums are formed must not depend on threads.
constexpr int kBlock = 192;

constexpr int kAllPositive = -1;

std::size_t at(int row, int column, int height)
{
  return static_cast<std::size_t>(column) * static_cast<std::size_t>(height) + static_cast<std::size_t>(row);
}

int blockCount(int size)
{
  return (size + kBlock - 1) / kBlock;
}

/// Runs turns of a loop one after the other, or over all cores.
class Loop {
 public:
  explicit Loop(bool isParallel) : isParallel_(isParallel) {}

  template <class Work>
  void operator()(int count, const Work& work) const
  {
    if (isParallel_ && count > 1)
      parallelFor(count, [&](Index k) { work(static_cast<int>(k)); });
    else
      for (int k = 0; k < count; ++k) work(k);
  }

 private:
  bool isParallel_;
};

/// C <- scale C - sign A A^T for the lower triangle of C, n x n.
void update(const Loop& loop, int n, int k, double sign, const double* A, int ldA, double scale, double* C, int ldC)
{
  loop(blockCount(n), [&](int block) {
    const int first = block * kBlock;
    const int width = std::min(kBlock, n - first);
    denseSymmetricUpdate(width, k, -sign, A + first, ldA, scale, C + at(first, first, ldC), ldC);
    if (const int below = n - first - width; below > 0)
      denseUpdate(below, width, k, -sign, A + first + width, A + first, ldA, scale, C + at(first + width, first, ldC),
                  ldC);
  });
}

/// Factorises the columns of a panel (height x width), block by block; from column `positive` on with -1 in S. Returns
/// the place of the first pivot of another sign, from 1; 0 where there is none.
int factorizePanel(const Loop& loop, double* panel, int height, int width, int positive)
{
  int end = 0;
  for (int first = 0; first < width; first = end) {
    end = std::min(first + kBlock, first < positive ? positive : width);
    const int columns = end - first;
    const double sign = first < positive ? 1 : -1;
    double* const corner = panel + at(first, first, height);
    if (sign < 0)  // L11 L11^T = -F11, L21 = -F21 L11^-T
      for (int j = 0; j < columns; ++j)
        std::transform(corner + at(j, j, height), corner + at(height - first, j, height), corner + at(j, j, height),
                       std::negate());
    if (const int bad = denseCholesky(columns, corner, height); bad != 0) return first + bad;
    loop(blockCount(height - end), [&](int block) {
      const int row = end + block * kBlock;
      denseSolveRight(std::min(kBlock, height - row), columns, corner, height, panel + at(row, first, height), height);
    });
    loop(blockCount(width - end), [&](int block) {
      const int column = end + block * kBlock;
      const int count = std::min(kBlock, width - column);
      const double* const left = panel + at(column, first, height);
      denseSymmetricUpdate(count, columns, -sign, left, height, 1, panel + at(column, column, height), height);
      if (const int below = height - column - count; below > 0)
        denseUpdate(below, count, columns, -sign, left + count, left, height, 1,
                    panel + at(column + count, column, height), height);
    });
  }
  return 0;
}

/// Numbers of a lower triangle, column by column without gaps.
std::size_t triangleSize(int size)
{
  return static_cast<std::size_t>(size) * (static_cast<std::size_t>(size) + 1) / 2;
}

/// Where column j of such a triangle has its row 0.
std::size_t triangleColumn(int j, int size)
{
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(2 * size - j - 1) / 2;
}

/// What supernodes of a range take off the rows below them, each a lower triangle, until their parents have added it.
/// In the order of elimination the children of the next one are always those that came last.
class UpdateStack {
 public:
  UpdateStack(const SymbolicFactor& symbolic, const SupernodeRange& range)
      : numbers_(std::make_unique_for_overwrite<double[]>(highest(symbolic, range)))
  {
  }

  [[nodiscard]] double* push(int rowCount)
  {
    double* const place = numbers_.get() + size_;
    size_ += triangleSize(rowCount);
    return place;
  }
  void pop(int rowCount) { size_ -= triangleSize(rowCount); }

 private:
  static std::size_t highest(const SymbolicFactor& symbolic, const SupernodeRange& range)
  {
    std::size_t size = 0;
    std::size_t highest = 0;
    for (int s = range.begin; s < range.end; ++s) {
      for (const int child : symbolic.children[s])
        if (child >= range.begin) size -= triangleSize(symbolic.supernodes[child].rowCount);
      size += triangleSize(symbolic.supernodes[s].rowCount);
      highest = std::max(highest, size);
    }
    return highest;
  }

  std::unique_ptr<double[]> numbers_;
  std::size_t size_ = 0;
};

class Multifrontal {
 public:
  Multifrontal(const std::shared_ptr<const SymbolicFactor>& symbolic, const SparseMatrix& lower)
      : symbolic_(*symbolic),
        lower_(lower),
        diagonal_(symbolic->order.size()),
        updates_(symbolic->supernodes.size()),
        result_(std::make_unique<PackedFactor>(symbolic))
  {
  }

  /// The place of the first pivot that is not positive, or `kAllPositive`. Throws `LeftBehind`.
  int run()
  {
    // One factorisation at a time: `OneThread` has taken memory for one thread a core.
    static std::mutex computing;
    const std::scoped_lock lock(computing);
    if (isLeftBehind_()) throw LeftBehind();
    const OneThread libraries;
    const NoSubnormals arithmetic;  // L falls off exponentially where much is held
    findDiagonal();
    std::vector<Workspace> ranges;
    for (const SupernodeRange& range : symbolic_.subtrees) ranges.emplace_back(symbolic_, range);
    parallelFor(static_cast<Index>(ranges.size()), [&](Index k) { factorize(ranges[k], Loop(false)); });
    Workspace top(symbolic_, symbolic_.top);
    factorize(top, Loop(true));
    if (isLeftBehind_()) throw LeftBehind();
    return badPivot_;
  }

  [[nodiscard]] std::unique_ptr<const PackedFactor> result() { return std::move(result_); }

 private:
  /// What the supernodes of a range are computed in.
  struct Workspace {
    Workspace(const SymbolicFactor& symbolic, const SupernodeRange& supernodes)
        : range(supernodes), stack(symbolic, supernodes)
    {
    }

    SupernodeRange range;
    UpdateStack stack;
    std::vector<int> placeOf;  // of a column: its row in the front
    std::vector<int> places;   // of the rows of a child
    std::vector<double> panel;
    std::vector<double> update;
  };

  void findDiagonal()
  {
    for (std::size_t k = 0; k < diagonal_.size(); ++k) {
      const SparseMatrix::InnerIterator first(lower_, symbolic_.order[k]);
      diagonal_[k] = first && first.row() == first.col() ? first.value() : 0;
    }
  }

  void factorize(Workspace& work, const Loop& loop)
  {
    work.placeOf.resize(diagonal_.size());
    for (int s = work.range.begin; s < work.range.end && badPivot_ == kAllPositive && !isLeftBehind_(); ++s)
      factorize(s, work, loop);
    work.placeOf = {};
    work.panel = {};
    work.update = {};
  }

  void factorize(int s, Workspace& work, const Loop& loop)
  {
    const Supernode& node = symbolic_.supernodes[s];
    const int height = node.height();
    const int rows = node.rowCount;
    for (int k = 0; k < node.width; ++k) work.placeOf[node.firstColumn + k] = k;
    int place = node.width;
    for (const int row : symbolic_.rowsOf(node)) work.placeOf[row] = place++;

    work.panel.assign(static_cast<std::size_t>(height) * static_cast<std::size_t>(node.width), 0);
    addEntries(node, work);
    for (const int child : symbolic_.children[s]) addToPanel(child, node, work, loop);
    const int positive = node.width - node.multipliers;
    if (const int bad = factorizePanel(loop, work.panel.data(), height, node.width, positive); bad != 0) {
      int none = kAllPositive;
      badPivot_.compare_exchange_strong(none, node.firstColumn + bad - 1);
      return;
    }
    result_->store(s, work.panel.data());

    const std::size_t needed = static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows);
    if (work.update.size() < needed) work.update.resize(needed);
    const double* const below = work.panel.data() + node.width;
    update(loop, rows, positive, 1, below, height, 0, work.update.data(), rows);
    if (node.multipliers > 0)
      update(loop, rows, node.multipliers, -1, below + at(0, positive, height), height, 1, work.update.data(), rows);
    for (const int child : symbolic_.children[s]) addToUpdate(child, node, work, loop);
    for (const int child : symbolic_.children[s])
      if (child >= work.range.begin) work.stack.pop(symbolic_.supernodes[child].rowCount);
    double* const kept = work.stack.push(rows);
    updates_[s] = kept;
    loop(blockCount(rows), [&](int block) {
      for (int j = block * kBlock; j < std::min(rows, (block + 1) * kBlock); ++j)
        std::copy_n(work.update.data() + at(j, j, rows), rows - j, kept + triangleColumn(j, rows) + j);
    });
  }

  void addEntries(const Supernode& node, Workspace& work)
  {
    const int height = node.height();
    for (int k = 0; k < node.width; ++k) {
      const int column = node.firstColumn + k;
      work.panel[at(k, k, height)] += diagonal_[column];
      for (int e = symbolic_.pattern.start[column]; e < symbolic_.pattern.start[column + 1]; ++e)
        work.panel[at(work.placeOf[symbolic_.pattern.row[e]], k, height)] +=
            lower_.valuePtr()[symbolic_.pattern.source[e]];
    }
  }

  /// The rows of the child's update in the front of its parent; returns how many of them are columns of the parent.
  int findPlaces(int child, const Supernode& node, Workspace& work)
  {
    work.places.clear();
    for (const int row : symbolic_.rowsOf(symbolic_.supernodes[child])) work.places.push_back(work.placeOf[row]);
    return static_cast<int>(std::lower_bound(work.places.begin(), work.places.end(), node.width) - work.places.begin());
  }

  void addToPanel(int child, const Supernode& node, Workspace& work, const Loop& loop)
  {
    const int own = findPlaces(child, node, work);
    addColumns(child, 0, own, {work.panel.data(), node.height(), 0}, work, loop);
  }

  void addToUpdate(int child, const Supernode& node, Workspace& work, const Loop& loop)
  {
    const int own = findPlaces(child, node, work);
    addColumns(child, own, static_cast<int>(work.places.size()), {work.update.data(), node.rowCount, node.width}, work,
               loop);
  }

  /// Columns of a front, without rows and columns before `first`.
  struct FrontPart {
    double* numbers = nullptr;
    int height = 0;
    int first = 0;
  };

  /// Adds columns [begin, end) of the child's update to its parent's front.
  void addColumns(int child, int begin, int end, const FrontPart& part, const Workspace& work, const Loop& loop)
  {
    const int size = static_cast<int>(work.places.size());
    loop(blockCount(end - begin), [&](int block) {
      const int firstColumn = begin + block * kBlock;
      for (int j = firstColumn; j < std::min(end, firstColumn + kBlock); ++j) {
        double* const to = part.numbers + at(0, work.places[j] - part.first, part.height);
        const double* const from = updates_[child] + triangleColumn(j, size);
        for (int i = j; i < size; ++i) to[work.places[i] - part.first] += from[i];
      }
    });
  }

  const SymbolicFactor& symbolic_;
  const SparseMatrix& lower_;
  std::vector<double> diagonal_;
  std::vector<const double*> updates_;  // of each supernode, as long as it is needed
  std::unique_ptr<PackedFactor> result_;
  std::function<bool()> isLeftBehind_ = leftBehindCheck();
  std::atomic<int> badPivot_{kAllPositive};
};

}  // namespace

Result<std::unique_ptr<const PackedFactor>> factorizeMultifrontal(const std::shared_ptr<const SymbolicFactor>& symbolic,
                                                                  const SparseMatrix& lower)
{
  Multifrontal multifrontal(symbolic, lower);
  if (const int bad = multifrontal.run(); bad != kAllPositive)
    return {nullptr, fmt::format("the normal equations are not positive definite in doubles (pivot {} of {})", bad + 1,
                                 symbolic->size())};
  return {multifrontal.result()};
}

}  // namespace holdfast
