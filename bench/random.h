#pragma once
/// \file
/// Random numbers that are the same on every run.

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast::bench {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// From 0 to `count` - 1.
  [[nodiscard]] Index below(Index count) { return static_cast<Index>(unit() * static_cast<double>(count)); }

  /// 0 .. `count` - 1 in random order. (std::shuffle differs between libraries.)
  [[nodiscard]] std::vector<Index> permutation(Index count)
  {
    std::vector<Index> order(static_cast<std::size_t>(count));
    for (Index k = 0; k < count; ++k) order[k] = k;
    for (Index k = count - 1; k > 0; --k) std::swap(order[k], order[below(k + 1)]);
    return order;
  }

 private:
  [[nodiscard]] double unit() { return static_cast<double>(engine_()) / 4294967296.0; }

  std::mt19937 engine_;
};

}  // namespace holdfast::bench
