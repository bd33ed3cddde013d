#include "holdfast/ordering/minimum_degree.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

#include <Eigen/OrderingMethods>

namespace holdfast {
namespace {

constexpr int kBits = 64;

/// Which vertices each one is tied to while vertices are eliminated: a row of bits for each.
class BitGraph {
 public:
  BitGraph(int rows, int columns)
      : words_((columns + kBits - 1) / kBits), bits_(static_cast<std::size_t>(rows) * words_, 0)
  {
  }

  void add(int row, int column) { word(row, column) |= bit(column); }
  void remove(int row, int column) { word(row, column) &= ~bit(column); }

  [[nodiscard]] int degree(int row) const
  {
    const auto its = bits_.begin() + begin(row);
    return std::transform_reduce(its, its + words_, 0, std::plus(),
                                 [](std::uint64_t word) { return std::popcount(word); });
  }

  /// Ties all that `row` is tied to to `other`, too.
  void merge(int row, int other)
  {
    std::transform(bits_.begin() + begin(row), bits_.begin() + begin(row) + words_, bits_.begin() + begin(other),
                   bits_.begin() + begin(other), std::bit_or());
  }

  /// Calls `visit(column)` for the columns below `end` that `row` is tied to.
  template <class Visit>
  void forEach(int row, int end, const Visit& visit) const
  {
    for (int first = 0; first < end; first += kBits)
      for (std::uint64_t left = bits_[begin(row) + first / kBits]; left != 0; left &= left - 1)
        if (const int column = first + std::countr_zero(left); column < end) visit(column);
  }

 private:
  [[nodiscard]] std::ptrdiff_t begin(int row) const { return static_cast<std::ptrdiff_t>(row) * words_; }
  [[nodiscard]] std::uint64_t& word(int row, int column) { return bits_[begin(row) + column / kBits]; }
  [[nodiscard]] static std::uint64_t bit(int column) { return std::uint64_t{1} << (column % kBits); }

  int words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<int> minimumDegreeOrder(const SparseMatrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

std::vector<int> PieceOrder::operator()(std::span<const int> piece)
{
  std::vector<int> near(piece.begin(), piece.end());
  const int size = static_cast<int>(near.size());
  for (int k = 0; k < size; ++k) placeOf_[near[k]] = k;
  const auto forEachNear = [&](int vertex, const auto& visit) {
    graph_.forEachEdge(vertex, [&](int u, int /*weight*/) {
      visit(u);
      graph_.forEachEdge(u, [&](int w, int /*weight*/) { visit(w); });
    });
  };
  for (const int vertex : piece)
    forEachNear(vertex, [&](int u) {
      if (placeOf_[u] >= 0) return;
      placeOf_[u] = static_cast<int>(near.size());
      near.push_back(u);
    });
  BitGraph ties(size, static_cast<int>(near.size()));
  for (int k = 0; k < size; ++k) {
    forEachNear(piece[k], [&](int u) { ties.add(k, placeOf_[u]); });
    ties.remove(k, k);
  }
  for (const int vertex : near) placeOf_[vertex] = -1;

  std::vector<int> degree(piece.size());
  for (int k = 0; k < size; ++k) degree[k] = ties.degree(k);
  std::vector<int> order;
  while (static_cast<int>(order.size()) < size) {
    const int next = static_cast<int>(std::ranges::min_element(degree) - degree.begin());
    order.push_back(piece[next]);
    degree[next] = std::numeric_limits<int>::max();
    ties.forEach(next, size, [&](int k) {
      ties.merge(next, k);
      ties.remove(k, k);
      ties.remove(k, next);
      degree[k] = ties.degree(k);
    });
  }
  return order;
}

}  // namespace holdfast
