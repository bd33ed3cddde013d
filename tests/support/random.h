#pragma once
/// \file
/// Seeded random numbers for tests: the seed is printed with every failure.

#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace holdfast::test {

/// A generator for one test, seeded by `seed` alone: the same numbers on every run and every machine with the same
/// standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed)
      : trace_(__FILE__, __LINE__, testing::Message() << "random seed " << seed), engine_(seed)
  {
  }

  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// From `low` to `high`, both included.
  [[nodiscard]] long integer(long low, long high)
  {
    return low + static_cast<long>(unit() * static_cast<double>(high - low + 1));
  }

 private:
  [[nodiscard]] double unit() { return static_cast<double>(engine_()) / 4294967296.0; }

  testing::ScopedTrace trace_;
  std::mt19937 engine_;
};

}  // namespace holdfast::test
