#include "holdfast/factor/triangular_kernels.h"

#include <cstring>
#include <type_traits>
#include <utility>

namespace holdfast {
namespace {

// Three right-hand sides and one that is not used: four doubles are what a register holds since AVX. Elsewhere the
// compiler takes two registers.
using Quad = double __attribute__((vector_size(4 * sizeof(double))));

#define HOLDFAST_INLINE inline __attribute__((always_inline))

HOLDFAST_INLINE void load(Quad& quad, const double* from)
{
  std::memcpy(&quad, from, sizeof(Quad));
}

HOLDFAST_INLINE void store(const Quad& quad, double* to)
{
  std::memcpy(to, &quad, sizeof(Quad));
}

// The numbers that are asked for next lie far ahead: the hardware does not see where a chunk ends.
constexpr std::ptrdiff_t kAhead = 256;  // numbers
constexpr std::ptrdiff_t kLine = 8;

/// x_r <- x_r - L_r y for rows r, two at a time: their sums do not wait for one another. `x` begins with row `begin`.
template <int W>
HOLDFAST_INLINE void reduceRows(const double* L, const int* rows, int count, const Quad* y, double* x, int begin = 0)
{
  int r = 0;
  for (; r + 1 < count; r += 2, L += std::ptrdiff_t{2} * W) {
    double* const first = x + 4 * static_cast<std::ptrdiff_t>(rows[r] - begin);
    double* const second = x + 4 * static_cast<std::ptrdiff_t>(rows[r + 1] - begin);
    __builtin_prefetch(L + kAhead);
    __builtin_prefetch(L + kAhead + kLine);
    Quad a;
    Quad b;
    load(a, first);
    load(b, second);
    Quad a2{};
    Quad b2{};
    for (int j = 0; j + 1 < W; j += 2) {
      a -= L[j] * y[j];
      b -= L[W + j] * y[j];
      a2 -= L[j + 1] * y[j + 1];
      b2 -= L[W + j + 1] * y[j + 1];
    }
    if constexpr (W % 2 == 1) {
      a -= L[W - 1] * y[W - 1];
      b -= L[2 * W - 1] * y[W - 1];
    }
    store(a + a2, first);
    store(b + b2, second);
  }
  if (r == count) return;
  double* const last = x + 4 * static_cast<std::ptrdiff_t>(rows[r] - begin);
  Quad a;
  load(a, last);
  for (int j = 0; j < W; ++j) a -= L[j] * y[j];
  store(a, last);
}

/// y <- y - sum of L_r^T x_r over rows r, the last one first: memory is read backwards.
template <int W>
HOLDFAST_INLINE void gatherRows(const double* L, const int* rows, int count, Quad* y, const double* x)
{
  L += static_cast<std::ptrdiff_t>(count) * W;
  Quad y2[W] = {};
  int r = count;
  for (; r > 1; r -= 2) {
    L -= std::ptrdiff_t{2} * W;
    Quad a;
    Quad b;
    load(a, x + 4 * static_cast<std::ptrdiff_t>(rows[r - 2]));
    load(b, x + 4 * static_cast<std::ptrdiff_t>(rows[r - 1]));
    __builtin_prefetch(L - kAhead);
    __builtin_prefetch(L - kAhead - kLine);
    for (int j = 0; j < W; ++j) {
      y[j] -= L[j] * a;
      y2[j] -= L[W + j] * b;
    }
  }
  for (int j = 0; j < W; ++j) y[j] += y2[j];
  if (r == 0) return;
  Quad a;
  load(a, x + 4 * static_cast<std::ptrdiff_t>(rows[0]));
  for (int j = 0; j < W; ++j) y[j] -= (L - W)[j] * a;
}

struct Forward {
  template <int W>
  static HOLDFAST_INLINE void solve(const FactorChunk& chunk, const SolveView& view)
  {
    double* const own = view.x + 4 * static_cast<std::ptrdiff_t>(chunk.firstColumn);
    const double* L = view.numbers + chunk.offset;
    Quad y[W];
    for (std::ptrdiff_t i = 0; i < W; ++i) load(y[i], own + 4 * i);
    if (chunk.hasTriangle) {
      for (std::ptrdiff_t i = 0; i < W; ++i, L += W) {
        for (std::ptrdiff_t j = 0; j < i; ++j) y[i] -= L[j] * y[j];
        y[i] *= L[i];
        store(y[i], own + 4 * i);
      }
    }
    const int* const rows = view.rows + chunk.firstRow;
    reduceRows<W>(L, rows, chunk.lowRows, y, view.x);
    reduceRows<W>(L + static_cast<std::ptrdiff_t>(chunk.lowRows) * W, rows + chunk.lowRows,
                  chunk.rowCount - chunk.lowRows, y, view.top, view.topColumn);
  }
};

struct Backward {
  template <int W>
  static HOLDFAST_INLINE void solve(const FactorChunk& chunk, const SolveView& view)
  {
    double* const own = view.x + 4 * static_cast<std::ptrdiff_t>(chunk.firstColumn);
    const double* const triangle = view.numbers + chunk.offset;
    Quad y[W];
    for (std::ptrdiff_t i = 0; i < W; ++i) load(y[i], own + 4 * i);
    gatherRows<W>(triangle + (chunk.hasTriangle ? std::ptrdiff_t{W} * W : 0), view.rows + chunk.firstRow,
                  chunk.rowCount, y, view.x);
    for (std::ptrdiff_t i = W - 1; i >= 0; --i) {
      if (chunk.hasTriangle) {
        y[i] *= triangle[i * W + i];
        for (std::ptrdiff_t j = 0; j < i; ++j) y[j] -= triangle[i * W + j] * y[i];
      }
      store(y[i], own + 4 * i);
    }
  }
};

/// Most chunks are as wide as they may be: that width is tried first.
template <class Direction, int... Less>
HOLDFAST_INLINE void solveChunk(const FactorChunk& chunk, const SolveView& view,
                                std::integer_sequence<int, Less...> /*less*/)
{
  static_cast<void>(
      ((chunk.width == kChunkWidth - Less && (Direction::template solve<kChunkWidth - Less>(chunk, view), true)) ||
       ...));
}

template <class Direction>
HOLDFAST_INLINE void solveAll(std::span<const FactorChunk> chunks, const SolveView& view)
{
  constexpr std::make_integer_sequence<int, kChunkWidth> widths;
  if constexpr (std::is_same_v<Direction, Forward>)
    for (const FactorChunk& chunk : chunks) solveChunk<Direction>(chunk, view, widths);
  else
    for (std::size_t k = chunks.size(); k-- > 0;) solveChunk<Direction>(chunks[k], view, widths);
}

#if defined(__x86_64__)
template <class Direction>
__attribute__((target("avx2,fma"))) void solveAvx2(std::span<const FactorChunk> chunks, const SolveView& view)
{
  solveAll<Direction>(chunks, view);
}

bool hasAvx2()
{
  static const bool kHas = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return kHas;
}
#endif

template <class Direction>
void solve(std::span<const FactorChunk> chunks, const SolveView& view)
{
#if defined(__x86_64__)
  if (hasAvx2()) return solveAvx2<Direction>(chunks, view);
#endif
  solveAll<Direction>(chunks, view);
}

}  // namespace

void solveForward(std::span<const FactorChunk> chunks, const SolveView& view)
{
  solve<Forward>(chunks, view);
}

void solveBackward(std::span<const FactorChunk> chunks, const SolveView& view)
{
  solve<Backward>(chunks, view);
}

}  // namespace holdfast
