#include "holdfast/factor/packed_factor.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

#include <sys/mman.h>

#include <holdfast/base/parallel.h>
#include <holdfast/factor/triangular_kernels.h>

namespace holdfast {
namespace {

/// Memory in pages of 2 MiB where the system has them: the solves walk through all of it, and would wait for the table
/// of small pages.
double* allocate(std::size_t count)
{
  constexpr std::size_t kPage = std::size_t{2} << 20U;
  const std::size_t bytes = (count * sizeof(double) + kPage - 1) / kPage * kPage;
  void* const numbers = std::aligned_alloc(kPage, std::max(bytes, kPage));
  if (numbers == nullptr) throw std::bad_alloc();
  ::madvise(numbers, bytes, MADV_HUGEPAGE);
  return static_cast<double*>(numbers);
}

}  // namespace

void PackedFactor::Free::operator()(double* numbers) const
{
  std::free(numbers);
}

PackedFactor::PackedFactor(std::shared_ptr<const SymbolicFactor> symbolic) : symbolic_(std::move(symbolic))
{
  const int topColumn = symbolic_->topColumn();
  for (const Supernode& node : symbolic_->supernodes) {
    firstChunk_.push_back(static_cast<int>(chunks_.size()));
    const auto firstRow = static_cast<std::int64_t>(rows_.size());
    for (int column = 0; column < node.width; ++column) {
      rows_.push_back(node.firstColumn + column);
      if (column >= node.width - node.multipliers) negative_.push_back(node.firstColumn + column);
    }
    const std::span<const int> below = symbolic_->rowsOf(node);
    rows_.insert(rows_.end(), below.begin(), below.end());
    const auto high = std::lower_bound(rows_.begin() + firstRow, rows_.end(), topColumn) - rows_.begin();
    for (int column = 0; column < node.width; column += kChunkWidth) {
      const int width = std::min(kChunkWidth, node.width - column);
      const std::int64_t behind = firstRow + column + width;
      const int rowCount = node.height() - column - width;
      chunks_.push_back({size_, node.firstColumn + column, width, behind,
                         static_cast<int>(std::max<std::int64_t>(0, high - behind)), rowCount});
      size_ += static_cast<std::size_t>(width) * static_cast<std::size_t>(width + rowCount);
    }
  }
  firstChunk_.push_back(static_cast<int>(chunks_.size()));
  numbers_.reset(allocate(size_));
}

void PackedFactor::store(int supernode, const double* panel)
{
  const Supernode& node = symbolic_->supernodes[supernode];
  const auto height = static_cast<std::size_t>(node.height());
  for (int c = firstChunk_[supernode]; c < firstChunk_[supernode + 1]; ++c) {
    const FactorChunk& chunk = chunks_[c];
    const int first = chunk.firstColumn - node.firstColumn;
    const double* const corner = panel + static_cast<std::size_t>(first) * height + static_cast<std::size_t>(first);
    double* to = numbers_.get() + chunk.offset;
    for (int i = 0; i < chunk.width + chunk.rowCount; ++i)
      for (int j = 0; j < chunk.width; ++j, ++to) {
        const double number = corner[static_cast<std::size_t>(j) * height + static_cast<std::size_t>(i)];
        *to = i > j ? number : i == j ? 1 / number : 0;
      }
  }
}

std::span<const FactorChunk> PackedFactor::chunksOf(const SupernodeRange& range) const
{
  return std::span(chunks_).subspan(static_cast<std::size_t>(firstChunk_[range.begin]),
                                    static_cast<std::size_t>(firstChunk_[range.end] - firstChunk_[range.begin]));
}

void PackedFactor::solve(std::vector<double>& x) const
{
  const std::vector<SupernodeRange>& subtrees = symbolic_->subtrees;
  const auto topStart = 4 * static_cast<std::ptrdiff_t>(symbolic_->topColumn());
  const std::size_t topSize = x.size() - static_cast<std::size_t>(topStart);
  std::vector<std::vector<double>> top(subtrees.size());
  const SolveView view{numbers_.get(), rows_.data(), x.data(), x.data() + topStart, symbolic_->topColumn()};
  parallelFor(static_cast<Index>(subtrees.size()), [&](Index k) {
    top[k].assign(topSize, 0);
    SolveView own = view;
    own.top = top[k].data();
    solveForward(chunksOf(subtrees[k]), own);
  });
  for (const std::vector<double>& sum : top)
    for (std::size_t k = 0; k < topSize; ++k) x[static_cast<std::size_t>(topStart) + k] += sum[k];
  solveForward(chunksOf(symbolic_->top), view);
  for (const int column : negative_)
    for (std::size_t k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(column) + k] *= -1;
  solveBackward(chunksOf(symbolic_->top), view);
  parallelFor(static_cast<Index>(subtrees.size()), [&](Index k) { solveBackward(chunksOf(subtrees[k]), view); });
}

}  // namespace holdfast
