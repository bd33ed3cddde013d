#include "holdfast/factor/packed_factor.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <holdfast/factor/strips.h>
#include <holdfast/matrices/sparse_products.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// Columns with few entries are solved for so many at a time: L is read that much less often, and a chunk stays in the
// cache for all of them.
constexpr int kQuads = 4;
constexpr Index kSolvedAtOnce = Index{4} * kQuads;

}  // namespace

PackedFactor::PackedFactor(std::shared_ptr<const SymbolicFactor> symbolic) : symbolic_(std::move(symbolic))
{
  const int topColumn = symbolic_->topColumn();
  for (const Supernode& node : symbolic_->supernodes) {
    firstChunk_.push_back(static_cast<int>(chunks_.size()));
    for (int column = node.end() - node.multipliers; column < node.end(); ++column) negative_.push_back(column);
    const auto first = symbolic_->rows.begin() + node.firstRow;
    const auto high = std::lower_bound(first, first + node.height(), topColumn) - symbolic_->rows.begin();
    for (int column = 0; column < node.width; column += kChunkWidth) {
      const int width = std::min(kChunkWidth, node.width - column);
      const std::int64_t behind = node.firstRow + column + width;
      const int rowCount = node.height() - column - width;
      chunks_.push_back({size_, node.firstColumn + column, width, behind,
                         static_cast<int>(std::max<std::int64_t>(0, high - behind)), rowCount});
      size_ += static_cast<std::size_t>(width) * static_cast<std::size_t>(width + rowCount);
    }
  }
  firstChunk_.push_back(static_cast<int>(chunks_.size()));
  numbers_ = largeArray(size_);
  top_ = TopSolve(chunksOf(symbolic_->top));
}

void PackedFactor::store(int supernode, int strip, const double* panel)
{
  const Supernode& node = symbolic_->supernodes[supernode];
  static_assert(kStripWidth % kChunkWidth == 0);
  constexpr int kChunks = kStripWidth / kChunkWidth;
  const int begin = firstChunk_[supernode] + strip * kChunks;
  for (int c = begin; c < std::min(begin + kChunks, firstChunk_[supernode + 1]); ++c) {
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
  top_.forward(view);
}

void PackedFactor::solveBackward(std::vector<double>& x) const
{
  const SolveView view = viewOf(x.data());
  for (const int column : negative_)
    for (std::size_t k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(column) + k] *= -1;
  top_.backward(view);
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
  // Each thread has the same number of turns, of few columns.
  const Index rounds = (b.cols() + kSolvedAtOnce * threadCount() - 1) / (kSolvedAtOnce * threadCount());
  const Index turns = rounds * threadCount();
  std::vector<SparseEntries> found(columns.size());
  parallelFor(turns, [&](Index k) {
    const auto firstOf = [&](Index turn) { return static_cast<std::size_t>(turn * b.cols() / turns); };
    solveForward(std::span(columns).subspan(firstOf(k), firstOf(k + 1) - firstOf(k)), found);
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

void PackedFactor::solveForward(std::span<const FewEntries> columns, std::vector<SparseEntries>& found) const
{
  std::vector<int> named;
  for (const FewEntries& column : columns)
    for (const auto& [row, value] : column.entries) named.push_back(row);
  const std::vector<int> nodes = symbolic_->withAncestors(named);
  // The columns of these supernodes alone, which are few, one after the other: they stay in the cache.
  std::vector<int> placeOf(symbolic_->supernodes.size());  // of the first column of each
  std::size_t size = 0;
  for (const int node : nodes) {
    placeOf[node] = static_cast<int>(size);
    size += static_cast<std::size_t>(symbolic_->supernodes[node].width);
  }
  std::vector<double> x(std::size_t{4} * kQuads * size);
  const auto at = [&](std::size_t column, int place) -> double& {
    return x[4 * (column / 4 * size + static_cast<std::size_t>(place)) + column % 4];
  };
  const auto placeIn = [&](int node, int row) { return placeOf[node] + row - symbolic_->supernodes[node].firstColumn; };
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (const auto& [row, value] : columns[c].entries) at(c, placeIn(symbolic_->supernodeOf(row), row)) = value;
  std::vector<int> places;  // of the rows of a supernode, as in `SymbolicFactor::rows`
  for (const int node : nodes) {
    const Supernode& own = symbolic_->supernodes[node];
    std::vector<SolveView> views;
    places.clear();
    for (int k = 0; k < own.width; ++k) places.push_back(placeOf[node] + k);
    int above = node;
    for (const int row : symbolic_->rowsOf(own)) {
      while (row >= symbolic_->supernodes[above].end()) above = symbolic_->supernodes[above].parent;
      places.push_back(placeIn(above, row));
    }
    for (double* quad = x.data(); quad < x.data() + x.size(); quad += 4 * size) {
      const double* const first = quad + 4 * static_cast<std::ptrdiff_t>(placeOf[node]);
      if (std::any_of(first, first + 4 * static_cast<std::ptrdiff_t>(own.width), std::identity()))
        views.push_back({numbers_.get(), places.data(), quad, quad, 0});
    }
    for (FactorChunk chunk : chunksOf({node, node + 1})) {
      chunk.firstColumn = placeIn(node, chunk.firstColumn);
      chunk.firstRow -= own.firstRow;
      for (const SolveView& view : views) holdfast::solveForward({&chunk, 1}, view);
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (int k = 0; k < own.width; ++k)
        if (const double value = at(c, placeOf[node] + k); value != 0) {
          found[columns[c].column].places.push_back(own.firstColumn + k);
          found[columns[c].column].values.push_back(value);
        }
  }
}

SolveView PackedFactor::viewOf(double* x) const
{
  const int topColumn = symbolic_->topColumn();
  return {numbers_.get(), symbolic_->rows.data(), x, x + 4 * static_cast<std::ptrdiff_t>(topColumn), topColumn};
}

}  // namespace holdfast
