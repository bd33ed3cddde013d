// Little address space: the program ends, and says why. Large files: it begins anew, with large pages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/batch.h"
#include "support/meshes.h"

namespace holdfast::test {
namespace {

using testing::HasSubstr;

constexpr int kShortOfMemory = 5;
constexpr long kMebibyte = 1024L * 1024;

class LittleMemory : public BatchTest {
 protected:
  void SetUp() override
  {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers need terabytes of address space";
#endif
  }

  static ProcessOptions within(long mebibytes)
  {
    ProcessOptions options;
    options.addressSpace = mebibytes * kMebibyte;
    options.timeout = std::chrono::seconds(60);
    return options;
  }
};

TEST_F(LittleMemory, IsNamedWhereItIsNotEnoughToBegin)
{
  const ProcessResult result = runBatch({"--version"}, within(200));
  EXPECT_EQ(result.exitCode, kShortOfMemory) << "signal " << result.signal;
  EXPECT_THAT(result.err, HasSubstr("limited to 200 MiB (ulimit -v)"));
}

TEST_F(LittleMemory, IsEnoughForAnAnswerWhereTheMessageAllowsIt)
{
  const ProcessResult result = runBatch({"--version"}, within(500));
  EXPECT_EQ(result.exitCode, 0) << "signal " << result.signal << "\n" << result.err;
}

/// The steps are smaller than the 128 MiB that OpenBLAS asks for in one piece, so that some limit leaves less.
TEST_F(LittleMemory, IsNamedWhereItIsNotEnough)
{
  const std::string sheet = in_.file("sheet.obj", objText(grid(250, 250))).string();
  const std::string lift =
      in_.file("lift.json",
               constraintText({R"({"type": "fixed", "select": {"box": {"min": [0, 0, 0], "max": [0, 250, 0]}}})",
                               R"({"type": "point", "at": {"vertex": 62000}, "move": [0, 0, 1]})"}))
          .string();
  int refused = 0;
  bool isEnough = false;
  for (long mebibytes = 200; !isEnough && mebibytes < 2000; mebibytes += 60) {
    const ProcessResult result =
        runBatch({"deform", sheet, "--constraints", lift, "--out", output("out.obj")}, within(mebibytes));
    isEnough = result.exitCode == 0;
    if (isEnough) continue;
    ++refused;
    EXPECT_EQ(result.exitCode, kShortOfMemory) << mebibytes << " MiB, signal " << result.signal << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("not enough memory")) << mebibytes;
    EXPECT_THAT(out_.names(), testing::IsEmpty()) << mebibytes;
  }
  EXPECT_TRUE(isEnough);
  EXPECT_GT(refused, 0);
}

/// How often the program began: the loader shows each time what it begins with.
Index timesBegun(const std::string& mesh)
{
  const ProcessResult result =
      runProcess({"env", "-u", "GLIBC_TUNABLES", "LD_SHOW_AUXV=1", HOLDFAST_BATCH_PROGRAM, "check", mesh});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  constexpr std::string_view kShown = "AT_EXECFN:";
  Index count = 0;
  for (std::size_t at = result.out.find(kShown); at != std::string::npos; at = result.out.find(kShown, at + 1)) ++count;
  return count;
}

using LargeFiles = BatchTest;

TEST_F(LargeFiles, AreReadByAProgramThatBeganAnew)
{
  EXPECT_EQ(timesBegun(in_.file("small.obj", objText(grid(10, 10))).string()), 1);
  EXPECT_EQ(timesBegun(in_.file("large.obj", objText(grid(300, 300))).string()), 2);
}

}  // namespace
}  // namespace holdfast::test
