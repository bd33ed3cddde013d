#include "bench/machine.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <vector>

#include <benchmark/benchmark.h>
#include <cblas.h>
#include <sys/mman.h>

#include <holdfast/threads/parallel.h>

#include "bench/measure.h"

namespace holdfast::bench {

double bytesReadPerSecond()
{
  constexpr std::size_t kHugePage = std::size_t{2} << 20U;
  constexpr std::size_t kBytes = std::size_t{512} << 20U;
  constexpr Index kParts = 64;
  const std::unique_ptr<std::uint64_t, decltype(&std::free)> memory(
      static_cast<std::uint64_t*>(std::aligned_alloc(kHugePage, kBytes)), &std::free);
  ::madvise(memory.get(), kBytes, MADV_HUGEPAGE);
  const std::size_t count = kBytes / sizeof(std::uint64_t);
  std::iota(memory.get(), memory.get() + count, std::uint64_t{1});
  std::vector<std::uint64_t> sums(kParts);
  const double seconds = shortest(5, [&] {
    parallelFor(kParts, [&](Index part) {
      const std::uint64_t* const first = memory.get() + part * (count / kParts);
      sums[part] = std::accumulate(first, first + count / kParts, std::uint64_t{0});
    });
  });
  benchmark::DoNotOptimize(sums);
  return static_cast<double>(kBytes) / seconds;
}

double operationsPerSecond()
{
  constexpr int kSize = 1000;
  const Eigen::MatrixXd factor = Eigen::MatrixXd::Constant(kSize, kSize, 0.5);
  const double seconds = shortest(3, [&] {
    parallelFor(threadCount(), [&](Index) {
      Eigen::MatrixXd product(kSize, kSize);
      cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, kSize, kSize, kSize, 1, factor.data(), kSize, factor.data(),
                  kSize, 0, product.data(), kSize);
    });
  });
  return static_cast<double>(threadCount()) * 2e9 / seconds;
}

}  // namespace holdfast::bench
