#include "bench/machine.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/mman.h>

#include <holdfast/base/parallel.h>

#include "bench/measure.h"

extern "C" void dgemm_(const char* transA, const char* transB, const int* m, const int* n, const int* k,
                       const double* alpha, const double* A, const int* ldA, const double* B, const int* ldB,
                       const double* beta, double* C, const int* ldC);

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
  const std::vector<double> factor(kSize * kSize, 0.5);
  const double seconds = shortest(3, [&] {
    parallelFor(threadCount(), [&](Index) {
      std::vector<double> product(kSize * kSize);
      const double one = 1;
      const double zero = 0;
      dgemm_("N", "T", &kSize, &kSize, &kSize, &one, factor.data(), &kSize, factor.data(), &kSize, &zero,
             product.data(), &kSize);
    });
  });
  return static_cast<double>(threadCount()) * 2e9 / seconds;
}

}  // namespace holdfast::bench
