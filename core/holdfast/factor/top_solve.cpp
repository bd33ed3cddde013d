#include "holdfast/factor/top_solve.h"

#include <algorithm>
#include <array>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr std::size_t kChunks = 16;  // of a block: a triangle takes some microseconds
constexpr int kRows = 512;           // of a part: what is solved on them stays in the cache

std::int64_t rowsEnd(const FactorChunk& chunk)
{
  return chunk.firstRow + chunk.rowCount;
}

/// Up to `most` rows of a chunk, from one of the factor's on.
FactorChunk rowsFrom(std::int64_t first, int most, const FactorChunk& chunk)
{
  const std::int64_t skipped = first - chunk.firstRow;
  const std::int64_t before = (chunk.hasTriangle ? chunk.width : 0) + skipped;
  return {chunk.offset + static_cast<std::size_t>(before * chunk.width),
          chunk.firstColumn,
          chunk.width,
          first,
          0,
          std::min(most, chunk.rowCount - static_cast<int>(skipped)),
          false};
}

}  // namespace

TopSolve::TopSolve(std::span<const FactorChunk> chunks)
{
  for (std::size_t first = 0, end = 0; first < chunks.size(); first = end) {
    while (end < std::min(chunks.size(), first + kChunks) && rowsEnd(chunks[end]) == rowsEnd(chunks[first])) ++end;
    const std::int64_t behind = chunks[end - 1].firstRow;
    Block& block = blocks_.emplace_back();
    for (FactorChunk chunk : chunks.subspan(first, end - first)) {
      if (behind < rowsEnd(chunk)) block.below.push_back(rowsFrom(behind, chunk.rowCount, chunk));
      chunk.rowCount = static_cast<int>(behind - chunk.firstRow);
      block.triangle.push_back(chunk);
    }
  }
}

void TopSolve::forward(const SolveView& view) const
{
  const auto partCount = [&](Index step) {
    return blocks_[step].below.empty() ? 0 : (blocks_[step].below.front().rowCount + kRows - 1) / kRows;
  };
  const auto reduce = [&](Index step, Index part) {
    std::array<FactorChunk, kChunks> chunks;
    const auto rowsOfPart = [&](const FactorChunk& chunk) {
      return rowsFrom(chunk.firstRow + part * kRows, kRows, chunk);
    };
    solveForward({chunks.begin(), std::ranges::transform(blocks_[step].below, chunks.begin(), rowsOfPart).out}, view);
  };
  leadSteps(
      static_cast<Index>(blocks_.size()), [&](Index step) { solveForward(blocks_[step].triangle, view); }, partCount,
      reduce);
}

void TopSolve::backward(const SolveView& view) const
{
  const auto count = static_cast<Index>(blocks_.size());  // the last one has nothing below it
  const auto blockOf = [&](Index step) -> const Block& { return blocks_[count - 1 - step]; };
  leadSteps(
      count, [&](Index step) { solveBackward(blockOf(step).triangle, view); },
      [&](Index step) { return step + 1 < count ? static_cast<Index>(blockOf(step + 1).below.size()) : 0; },
      [&](Index step, Index part) {
        solveBackward({&blockOf(step + 1).below[part], 1}, view);
      });
}

}  // namespace holdfast
