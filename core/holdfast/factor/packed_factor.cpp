#include "holdfast/factor/packed_factor.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <new>
#include <utility>

#include <holdfast/base/parallel.h>
#include <holdfast/base/sparse_products.h>
#include <holdfast/factor/strips.h>
#include <holdfast/factor/triangular_kernels.h>

namespace holdfast {
namespace {

// Columns with few entries are solved for so many at a time: L is read that much less often, and a chunk stays in the
// cache for all of them.
constexpr int kQuads = 4;
constexpr Index kSolvedAtOnce = 4 * kQuads;

using Zeros = std::unique_ptr<double[], decltype([](double* numbers) { std::free(numbers); })>;

/// They take memory where they are changed.
Zeros zeros(std::size_t count)
{
  Zeros result(static_cast<double*>(std::calloc(count, sizeof(double))));
  if (result == nullptr) throw std::bad_alloc();
  return result;
}

}  // namespace

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
  numbers_ = largeArray(size_);
}

void PackedFactor::store(int supernode, const double* panel)
{
  const Supernode& node = symbolic_->supernodes[supernode];
  static_assert(kStripWidth % kChunkWidth == 0);
  for (int c = firstChunk_[supernode]; c < firstChunk_[supernode + 1]; ++c) {
    const FactorChunk& chunk = chunks_[c];
    const int first = chunk.firstColumn - node.firstColumn;
    const double* const corner = panel + placeInStrips(first, first, node.height());
    const auto apart = static_cast<std::size_t>(node.height() - stripOf(first));
    double* to = numbers_.get() + chunk.offset;
    for (int i = 0; i < chunk.width + chunk.rowCount; ++i)
      for (int j = 0; j < chunk.width; ++j, ++to) {
        const double number = corner[static_cast<std::size_t>(j) * apart + static_cast<std::size_t>(i)];
        *to = i > j ? number : i == j ? 1 / number : 0;
      }
  }
}

std::span<const FactorChunk> PackedFactor::chunksOf(const SupernodeRange& range) const
{
  return std::span(chunks_).subspan(static_cast<std::size_t>(firstChunk_[range.begin]),
                                    static_cast<std::size_t>(firstChunk_[range.end] - firstChunk_[range.begin]));
}

void PackedFactor::gather(const Columns3& b, std::vector<double>& x) const
{
  const std::vector<int>& order = symbolic_->order;
  x.resize(4 * order.size());
  parallelBlocks(static_cast<Index>(order.size()), [&](Index k) { std::ranges::copy(b.row(order[k]), &x[4 * k]); });
}

Columns3 PackedFactor::scattered(const std::vector<double>& x) const
{
  const std::vector<int>& order = symbolic_->order;
  Columns3 z(static_cast<Index>(order.size()), 3);
  parallelBlocks(z.rows(), [&](Index k) { z.row(order[k]) = Eigen::Map<const Eigen::RowVector3d>(&x[4 * k]); });
  return z;
}

void PackedFactor::solve(std::vector<double>& x) const
{
  solveForward(x);
  solveBackward(x);
}

void PackedFactor::solveForward(std::vector<double>& x) const
{
  const std::vector<SupernodeRange>& subtrees = symbolic_->subtrees;
  const SolveView view = viewOf(x.data());
  const auto topSize = static_cast<std::size_t>(x.data() + x.size() - view.top);
  std::vector<std::vector<double>> top(subtrees.size());
  parallelFor(static_cast<Index>(subtrees.size()), [&](Index k) {
    top[k].assign(topSize, 0);
    SolveView own = view;
    own.top = top[k].data();
    holdfast::solveForward(chunksOf(subtrees[k]), own);
  });
  for (const std::vector<double>& sum : top)
    for (std::size_t k = 0; k < topSize; ++k) view.top[k] += sum[k];
  holdfast::solveForward(chunksOf(symbolic_->top), view);
}

void PackedFactor::solveBackward(std::vector<double>& x) const
{
  const SolveView view = viewOf(x.data());
  for (const int column : negative_)
    for (std::size_t k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(column) + k] *= -1;
  holdfast::solveBackward(chunksOf(symbolic_->top), view);
  const std::vector<SupernodeRange>& subtrees = symbolic_->subtrees;
  parallelFor(static_cast<Index>(subtrees.size()),
              [&](Index k) { holdfast::solveBackward(chunksOf(subtrees[k]), view); });
}

SparseMatrix PackedFactor::solveForward(const SparseMatrix& b) const
{
  std::vector<int> place(symbolic_->order.size());
  for (std::size_t k = 0; k < place.size(); ++k) place[symbolic_->order[k]] = static_cast<int>(k);
  std::vector<FewEntries> columns(static_cast<std::size_t>(b.cols()));
  for (Index k = 0; k < b.cols(); ++k) {
    columns[k].column = static_cast<int>(k);
    for (SparseMatrix::InnerIterator entry(b, k); entry; ++entry)
      columns[k].entries.emplace_back(place[entry.row()], entry.value());
    std::ranges::sort(columns[k].entries);
  }
  // Neighbours have most of their way up the tree in common.
  std::ranges::sort(columns, {}, &FewEntries::entries);
  const Index turns = (b.cols() + kSolvedAtOnce - 1) / kSolvedAtOnce;
  std::vector<Zeros> x(static_cast<std::size_t>(threadCount()));
  std::vector<SparseEntries> found(columns.size());
  parallelFor(turns, [&](Index k, Index thread) {
    if (x[thread] == nullptr) x[thread] = zeros(kSolvedAtOnce * place.size());
    const auto rest = std::span<const FewEntries>(columns).subspan(static_cast<std::size_t>(k * kSolvedAtOnce));
    solveForward(rest.first(std::min<std::size_t>(kSolvedAtOnce, rest.size())), x[thread].get(), found);
  });
  SparseMatrix result(b.rows(), b.cols());
  for (Index k = 0; k < b.cols(); ++k) {
    result.startVec(k);
    for (std::size_t e = 0; e < found[k].places.size(); ++e)
      result.insertBack(found[k].places[e], k) = found[k].values[e];
  }
  result.finalize();
  return result;
}

void PackedFactor::solveForward(std::span<const FewEntries> columns, double* x, std::vector<SparseEntries>& found) const
{
  const std::size_t size = 4 * symbolic_->order.size();
  const auto at = [&](std::size_t column, int row) -> double& {
    return x[column / 4 * size + 4 * static_cast<std::size_t>(row) + column % 4];
  };
  std::vector<int> rows;
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (const auto& [row, value] : columns[c].entries) {
      at(c, row) = value;
      rows.push_back(row);
    }
  for (const int node : symbolic_->withAncestors(rows)) {
    const Supernode& own = symbolic_->supernodes[node];
    std::vector<SolveView> views;
    for (double* quad = x; quad < x + kQuads * size; quad += size)
      if (std::any_of(quad + 4 * own.firstColumn, quad + 4 * (own.firstColumn + own.width), std::identity()))
        views.push_back(viewOf(quad));
    for (const FactorChunk& chunk : chunksOf({node, node + 1}))
      for (const SolveView& view : views) holdfast::solveForward({&chunk, 1}, view);
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (int row = own.firstColumn; row < own.firstColumn + own.width; ++row)
        if (const double value = std::exchange(at(c, row), 0); value != 0) {
          found[columns[c].column].places.push_back(row);
          found[columns[c].column].values.push_back(value);
        }
  }
}

SolveView PackedFactor::viewOf(double* x) const
{
  const int topColumn = symbolic_->topColumn();
  return {numbers_.get(), rows_.data(), x, x + 4 * static_cast<std::ptrdiff_t>(topColumn), topColumn};
}

}  // namespace holdfast
