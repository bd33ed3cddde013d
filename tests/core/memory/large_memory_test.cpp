#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <holdfast/memory/available_memory.h>
#include <holdfast/memory/large_memory.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr std::size_t kMany = std::size_t{1} << 20U;

std::size_t residentBytes()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(LargeArray, TakesTheMemoryOfAnEarlierOneOfItsSize)
{
  LargeArray first = largeArray(kMany);
  const double* const place = first.get();
  first.reset();
  const LargeArray larger = largeArray(16 * kMany);
  EXPECT_NE(larger.get(), place);
  EXPECT_EQ(largeArray(kMany - 1).get(), place);
}

#ifndef __SANITIZE_ADDRESS__  // the allocator of that keeps what is freed
TEST(LargeArray, IsFreedWhereLeastMemoryIsWanted)
{
  const LeastMemory memory;
  const std::size_t before = residentBytes();
  LargeArray array = largeArray(8 * kMany);
  std::fill_n(array.get(), 8 * kMany, 1.0);
  EXPECT_GT(residentBytes(), before + 6 * kMany * sizeof(double));
  array.reset();
  EXPECT_LT(residentBytes(), before + 2 * kMany * sizeof(double));
}
#endif

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their allocators do otherwise
long pageFaults()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Takes 64 MiB in four arrays twice; exits with how many pages in a hundred were new the second time. Small things
/// that outlive arrays are taken first: one between two arrays would divide what these leave.
[[noreturn]] void exitWithNewPages()
{
  constexpr std::size_t kArrays = 4;
  constexpr long kPages = 4 * 4096;  // of 4 KiB
  long before = 0;
  for (int turn = 0; turn < 2; ++turn) {
    before = pageFaults();
    std::vector<std::vector<double>> arrays;
    arrays.reserve(kArrays);
    std::thread([&] {
      for (std::size_t k = 0; k < kArrays; ++k) arrays.emplace_back(2 * kMany, 1.0);
    }).join();
  }
  std::_Exit(static_cast<int>(100 * (pageFaults() - before) / kPages));
}

TEST(KeepFreedMemory, LeavesPagesForWhatIsTakenNext)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // in a program that has not started threads
  EXPECT_EXIT((keepFreedMemory(), exitWithNewPages()), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(
      exitWithNewPages(), [](int status) { return WIFEXITED(status) && WEXITSTATUS(status) > 50; }, "");
}
#endif

/// An array full of one number.
class Marked {
 public:
  Marked(ReusedMemory& memory, std::size_t count, double mark) : array_(memory.take(count)), count_(count), mark_(mark)
  {
    std::fill_n(array_.get(), count_, mark_);
  }

  [[nodiscard]] bool isWhole() const
  {
    return std::all_of(array_.get(), array_.get() + count_, [&](double number) { return number == mark_; });
  }

 private:
  ReusedMemory::Array array_;
  std::size_t count_;
  double mark_;
};

TEST(ReusedMemory, KeepsArraysApartHoweverTheyComeAndGo)
{
  ReusedMemory memory(5000);
  std::minstd_rand random(1);
  std::vector<Marked> arrays;
  for (int step = 0; step < 5000; ++step) {
    if (arrays.size() > 30 || (!arrays.empty() && random() % 2 == 0)) {
      const std::size_t gone = random() % arrays.size();
      ASSERT_TRUE(arrays[gone].isWhole()) << step;
      std::swap(arrays[gone], arrays.back());
      arrays.pop_back();
    } else {
      arrays.emplace_back(memory, random() % 1000, step);  // together more than was foreseen
    }
  }
  for (const Marked& array : arrays) EXPECT_TRUE(array.isWhole());
}

TEST(ReusedMemory, TakesTheLowestPlaceAndJoinsGaps)
{
  ReusedMemory memory(1000);
  ReusedMemory::Array a = memory.take(100);
  ReusedMemory::Array b = memory.take(100);
  ReusedMemory::Array c = memory.take(100);
  const ReusedMemory::Array d = memory.take(100);
  const double* const lowest = a.get();
  c.reset();
  a.reset();
  b.reset();
  EXPECT_EQ(memory.take(300).get(), lowest);
}

TEST(ReusedMemory, ServesThreads)
{
  ReusedMemory memory(10000);
  std::vector<int> bad(8, 0);
  parallelFor(8, [&](Index k) {
    for (int step = 0; step < 500; ++step) {
      const Marked one(memory, static_cast<std::size_t>(50 * k + step), static_cast<double>(k));
      const Marked other(memory, 100, static_cast<double>(-k));
      if (!one.isWhole() || !other.isWhole()) ++bad[k];
    }
  });
  EXPECT_EQ(bad, std::vector<int>(8, 0));
}

TEST(ReusedMemory, ReturnsGapsWhereLeastMemoryIsWanted)
{
  const LeastMemory least;
  ReusedMemory memory(16 * kMany);
  const Marked kept(memory, 1000, 1);
  ReusedMemory::Array large = memory.take(8 * kMany);
  const Marked keptToo(memory, 1000, 2);
  const std::size_t before = residentBytes();
  std::fill_n(large.get(), 8 * kMany, 1.0);
  large.reset();
  memory.returnGaps();
  EXPECT_LT(residentBytes(), before + 2 * kMany * sizeof(double));
  EXPECT_TRUE(kept.isWhole());
  EXPECT_TRUE(keptToo.isWhole());
}

}  // namespace
}  // namespace holdfast
