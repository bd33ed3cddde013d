// Outputs that cannot be written: exit code 6, and whatever stood in the folder stands there still.

#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/batch.h"
#include "support/meshes.h"
#include "support/residual_verifier.h"

namespace holdfast::test {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr int kOutput = 6;

class Outputs : public BatchTest {
 protected:
  /// `deform` with one output.
  [[nodiscard]] std::vector<std::string> deformTo(const std::string& option, const std::string& path) const
  {
    return {"deform", mesh(), "--constraints", constraints(), option, path};
  }
};

TEST_F(Outputs, AllAreWrittenAndNamed)
{
  const ProcessResult result = runBatch(deform(mesh(), constraints()));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, testing::Not(HasSubstr("warning"))) << "progress is told there where it takes long";
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  for (const std::string& name : allOutputs()) EXPECT_THAT(result.out, HasSubstr("wrote        " + output(name)));
  EXPECT_TRUE(meetsConstraints(mesh(), output("out.obj"), constraints()));
}

TEST_F(Outputs, OldOnesAreReplaced)
{
  putOldOutputs();
  EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0);
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  EXPECT_TRUE(meetsConstraints(mesh(), output("out.obj"), constraints()));
}

TEST_F(Outputs, AMissingFolderIsNamed)
{
  for (const std::string option : {"--out", "--report"}) {
    const std::string path = output("none/out.obj");
    expectRefusedWithoutTrace(deformTo(option, path), kOutput, {path + ": ", "make the folder first"});
  }
  expectRefusal(runBatch({"check", mesh(), "--report", output("none/report.json")}), kOutput, {"make the folder"});
}

TEST_F(Outputs, ADirectoryIsNotReplaced)
{
  fs::create_directory(out_.path() / "folder.obj");
  for (const std::string option : {"--out", "--report"})
    expectRefusal(runBatch(deformTo(option, output("folder.obj"))), kOutput,
                  {output("folder.obj") + ": is a directory: name a file in it"});
  EXPECT_THAT(out_.names(), ElementsAre("folder.obj"));
  EXPECT_TRUE(fs::is_empty(out_.path() / "folder.obj"));
}

TEST_F(Outputs, OneThatFailsLeavesTheOthersAsTheyWere)
{
  putOldOutputs();
  const std::vector<std::string> command{
      "deform",          mesh(),     "--constraints",           constraints(), "--out",
      output("out.obj"), "--report", output("none/report.json")};
  expectRefusal(runBatch(command), kOutput, {"make the folder first"});
  expectOldOutputs();
}

TEST_F(Outputs, AFolderThatMustNotBeWrittenToIsNamed)
{
  ProcessOptions options;
  options.obeysPermissions = true;
  ASSERT_EQ(::chmod(out_.path().c_str(), 0555), 0);
  const ProcessResult result = runBatch(deform(mesh(), constraints()), options);
  ASSERT_EQ(::chmod(out_.path().c_str(), 0755), 0);
  if (result.exitCode == kNotStarted) GTEST_SKIP() << "root here may not give up the right to ignore permissions";
  expectRefusal(result, kOutput, {output("out.obj") + ": cannot be written (Permission denied)", "permissions"});
  EXPECT_THAT(out_.names(), testing::IsEmpty());
}

TEST_F(Outputs, AFullDiskLeavesWhatWasThere)
{
  ProcessOptions options;
  options.largestFile = 1000;
  expectRefusedWithoutTrace(deform(mesh(), constraints()), kOutput,
                            {output("out.obj") + ": cannot be written (File too large)", "ulimit -f"}, options);
}

TEST_F(Outputs, ADiskFullForTheReportAloneLeavesWhatWasThere)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  putOldOutputs();
  const std::vector<std::string> command{"deform",          mesh(),     "--constraints", constraints(), "--out",
                                         output("out.obj"), "--report", "/dev/full"};
  expectRefusal(runBatch(command), kOutput, {"/dev/full: cannot be written (No space left on device)"});
  expectOldOutputs();
}

TEST_F(Outputs, ADiskFullForTheMeshAloneLeavesWhatWasThere)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  fs::create_symlink("/dev/full", in_.path() / "full.obj");
  putOldOutputs();
  const std::vector<std::string> command{"deform",        mesh(),
                                         "--constraints", constraints(),
                                         "--report",      output("report.json"),
                                         "--out",         (in_.path() / "full.obj").string()};
  expectRefusal(runBatch(command), kOutput, {"cannot be written (No space left on device)"});
  expectOldOutputs();
}

TEST_F(Outputs, AMeshThatDoesNotFitItsFormatNamesTheFile)
{
  const std::string far = in_.file("far.json", constraintText({R"({"type": "handle", "select": {"component": 0},
                                                                   "translate": [1e39, 0, 0]})"}))
                              .string();
  const std::string path = output("out.stl");
  expectRefusal(runBatch({"deform", mesh(), "--constraints", far, "--out", path}), kOutput,
                {path + ": the coordinate 1e+39 is too large for single precision"});
  EXPECT_THAT(out_.names(), testing::IsEmpty());
}

TEST_F(Outputs, TheReportCanGoToStandardOutput)
{
  const ProcessResult result = runBatch(deformTo("--report", "/dev/stdout"));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\"holdfast-report\""));
}

TEST_F(Outputs, AnAnswerThatIsNotReadIsAnErrorOfWriting)
{
  ProcessOptions options;
  options.isOutUnread = true;
  expectRefusedWithoutTrace(deform(mesh(), constraints()), kOutput,
                            {"standard output: cannot be written (Broken pipe)"}, options);
  expectRefusal(runBatch({"--version"}, options), kOutput, {"Broken pipe"});
  const std::vector<std::string> quietly{"check", mesh(), "--report", "/dev/stdout", "--quiet"};
  expectRefusal(runBatch(quietly, options), kOutput, {"/dev/stdout: cannot be written (Broken pipe)"});
}

/// Standard output or standard error goes to a disk without room.
class FullStreams : public Outputs {
 protected:
  void SetUp() override
  {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    outIsFull_.outPath = "/dev/full";
    errIsFull_.errPath = "/dev/full";
  }

  ProcessOptions outIsFull_;
  ProcessOptions errIsFull_;
};

TEST_F(FullStreams, AnAnswerThatIsLostIsAnError)
{
  const std::vector<std::vector<std::string>> questions{
      {"--version"}, {"--help"}, {"deform", "--help"}, {"check", mesh()}};
  for (const auto& question : questions)
    expectRefusal(runBatch(question, outIsFull_), kOutput,
                  {"standard output: cannot be written (No space left on device)"});
}

TEST_F(FullStreams, ASummaryThatIsLostLeavesWhatWasThere)
{
  expectRefusedWithoutTrace(deform(mesh(), constraints()), kOutput, {"standard output: cannot be written"}, outIsFull_);
  const std::vector<std::string> check{"check", mesh(), "--report", output("report.json")};
  expectRefusedWithoutTrace(check, kOutput, {"standard output: cannot be written"}, outIsFull_);
}

TEST_F(FullStreams, AReportThatIsLostIsAnError)
{
  const std::vector<std::string> quietly{"check", mesh(), "--report", "/dev/stdout", "--quiet"};
  expectRefusal(runBatch(quietly, outIsFull_), kOutput, {"/dev/stdout: cannot be written (No space left on device)"});
}

TEST_F(FullStreams, QuietNeedsNoStandardOutput)
{
  EXPECT_EQ(runBatch(deform(mesh(), constraints(), {"--quiet"}), outIsFull_).exitCode, 0);
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
}

TEST_F(FullStreams, MessagesThatAreLostKeepTheExitCode)
{
  constexpr int kUsage = 2;
  EXPECT_EQ(runBatch({"bend"}, errIsFull_).exitCode, kUsage);
  EXPECT_EQ(runBatch({"check", output("none.obj")}, errIsFull_).exitCode, 3);
}

/// Inputs whose work takes many seconds: a sheet of 250,000 vertices, one side held, the other lifted.
class LongWork : public BatchTest {
 protected:
  LongWork()
  {
    sheet_ = in_.file("sheet.obj", objText(grid(500, 500))).string();
    lift_ =
        in_.file("lift.json",
                 constraintText({R"({"type": "fixed", "select": {"box": {"min": [0, 0, 0], "max": [0, 500, 0]}}})",
                                 R"({"type": "handle", "select": {"box": {"min": [500, 0, 0], "max": [500, 500, 0]}},
                                         "translate": [0, 0, 100]})"}))
            .string();
  }

  std::string sheet_;
  std::string lift_;
};

TEST_F(LongWork, AnInterruptLeavesOldOutputsAndNothingElse)
{
  ProcessOptions options;
  options.signal = SIGINT;
  options.signalAt = " s] ";
  putOldOutputs();
  const ProcessResult result = runBatch(deform(sheet_, lift_), options);
  EXPECT_EQ(result.signal, SIGINT) << result.err;
  EXPECT_EQ(result.out, "");
  expectOldOutputs();
}

TEST_F(LongWork, TerminationWhileOutputsAreWrittenLeavesEachOldOrWhole)
{
  ProcessOptions options;
  options.signal = SIGTERM;
  options.signalAt = "writing the mesh";
  putOldOutputs();
  const ProcessResult result = runBatch(deform(sheet_, lift_), options);
  EXPECT_TRUE(result.signal == SIGTERM || result.exitCode == 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("writing the mesh"));
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  const std::string written = bytesOf(output("out.obj"));
  EXPECT_TRUE(written == "an old file" || meetsConstraints(sheet_, output("out.obj"), lift_));
}

TEST_F(LongWork, WhatIsLeftByAProgramThatWasKilledIsRemovedByTheNext)
{
  ProcessOptions options;
  options.signal = SIGKILL;
  options.signalAt = "writing fields";
  EXPECT_EQ(runBatch(deform(sheet_, lift_), options).signal, SIGKILL);
  EXPECT_EQ(out_.names().size(), 1U);
  EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0);
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
}

TEST_F(LongWork, QuietIsQuietHoweverLong)
{
  const ProcessResult result = runBatch({"deform", sheet_, "--constraints", lift_, "--quiet"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out + result.err, "");
}

}  // namespace
}  // namespace holdfast::test
