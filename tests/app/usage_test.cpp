// The command line: what is refused with exit code 2 before any work, and what is merely answered.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/batch.h"

namespace holdfast::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::StartsWith;

constexpr int kUsage = 2;

class Usage : public BatchTest {
 protected:
  /// `deform` with these options more.
  void expectRefusedOptions(const std::vector<std::string>& options, const std::vector<std::string>& messages) const
  {
    expectRefusedWithoutTrace(deform(mesh(), constraints(), options), kUsage, messages);
  }
};

TEST_F(Usage, ACommandIsNeeded)
{
  expectRefusal(runBatch({}), kUsage, {"--help"});
  expectRefusal(runBatch({"bend", mesh()}), kUsage, {"\"bend\" is not known.", "--help"});
  expectRefusal(runBatch({"defrom", mesh()}), kUsage, {"\"defrom\" is not known; did you mean deform?"});
}

TEST_F(Usage, AMeshIsNeeded)
{
  expectRefusal(runBatch({"deform", "--constraints", constraints()}), kUsage, {"mesh", "--help"});
  expectRefusal(runBatch({"check"}), kUsage, {"mesh", "--help"});
}

TEST_F(Usage, ConstraintsAreNeeded)
{
  expectRefusedWithoutTrace({"deform", mesh(), "--out", output("out.obj")}, kUsage, {"--constraints is required"});
}

TEST_F(Usage, UnknownOptionsAreNamed)
{
  expectRefusedOptions({"--wieghts", "uniform"}, {"\"--wieghts\" is not known; did you mean --weights?"});
  expectRefusedOptions({"surplus"}, {"surplus"});
  expectRefusal(runBatch({"check", mesh(), "--solver", "uniform"}), kUsage, {"--solver"});
}

TEST_F(Usage, UnknownValuesAreAnsweredWithTheKnownOnes)
{
  expectRefusedOptions({"--weights", "cotan"}, {"--weights: \"cotan\"", "cotangent, cotangent-paper, uniform"});
  expectRefusedOptions({"--solver", "firm"}, {"--solver: \"firm\"", "hard, soft, lagrange"});
  expectRefusedOptions({"--backend", "mumps"}, {"--backend: \"mumps\"", "eigen"});
}

TEST_F(Usage, SoftWeightsArePositiveNumbers)
{
  for (const std::string value : {"0", "-1", "nan", "inf"})
    expectRefusedOptions({"--solver", "soft", "--soft-weight", value}, {"--soft-weight: ", "not a positive number"});
  expectRefusedOptions({"--soft-weight", "much"}, {"--soft-weight", "much"});
  expectRefusedOptions({"--rotation-change", "0"}, {"--rotation-change: ", "not a positive number"});
  expectRefusedOptions({"--near-limit", "-1"}, {"--near-limit: ", "not a positive number"});
  expectRefusedOptions({"--weld", "0"}, {"--weld: ", "not a positive number"});
  expectRefusedOptions({"--rotations", "guessed"}, {"--rotations: \"guessed\" is not one of given, found"});
}

TEST_F(Usage, OptionsNeedTheirValues)
{
  expectRefusedOptions({"--weights"}, {"--weights"});
}

TEST_F(Usage, OutputsNeedAKnownExtension)
{
  expectRefusedWithoutTrace({"deform", mesh(), "--constraints", constraints(), "--out", output("out.step")}, kUsage,
                            {"--out: ", "out.step", ".obj, .ply, .off, .stl, .vtp, .vtk"});
  expectRefusedWithoutTrace({"deform", mesh(), "--constraints", constraints(), "--out", output("out")}, kUsage,
                            {"--out: "});
}

TEST_F(Usage, FieldsAreVtp)
{
  expectRefusedWithoutTrace({"deform", mesh(), "--constraints", constraints(), "--fields", output("fields.obj")},
                            kUsage, {"--fields: ", "does not end in .vtp"});
}

TEST_F(Usage, TwoOutputsNeedTwoNames)
{
  const std::string both = output("both.obj");
  const std::string again = (out_.path() / ".." / out_.path().filename() / "both.obj").string();
  for (const std::string& report : {both, again})
    expectRefusal(runBatch({"deform", mesh(), "--constraints", constraints(), "--out", both, "--report", report}),
                  kUsage, {"--out and --report name the same file"});
  EXPECT_THAT(out_.names(), testing::IsEmpty());
}

TEST_F(Usage, OutputsThatAreNotThereYetAreComparedByWhereTheyWillBe)
{
  const std::string name = "holdfast_usage_test_" + out_.path().filename().string() + ".obj";
  for (const std::string& report : {"./" + name, fs::absolute(name).string()})
    expectRefusal(runBatch({"deform", mesh(), "--constraints", constraints(), "--out", name, "--report", report}),
                  kUsage, {"--out and --report name the same file"});
  EXPECT_FALSE(fs::exists(name));
}

TEST_F(Usage, LinksToOneFileAreOneOutput)
{
  const std::string target = output("target.obj");
  const std::string link = output("link.obj");
  fs::create_symlink("target.obj", link);
  const std::vector<std::string> both{"deform", mesh(), "--constraints", constraints(),
                                      "--out",  link,   "--report",      target};
  expectRefusal(runBatch(both), kUsage, {"--out and --report name the same file"});
  fs::remove(link);
  static_cast<void>(out_.file("target.obj", "old"));
  fs::create_hard_link(target, link);
  expectRefusal(runBatch(both), kUsage, {"--out and --report name the same file"});
  EXPECT_EQ(bytesOf(target), "old");
}

TEST_F(Usage, AnInputIsNeverOverwritten)
{
  const std::string meshBytes = bytesOf(mesh());
  const std::string constraintBytes = bytesOf(constraints());
  const std::string link = output("link.obj");
  fs::create_symlink(mesh(), link);
  const std::string hardLink = output("hard_link.obj");
  fs::create_hard_link(mesh(), hardLink);
  for (const std::string& out : {mesh(), link, hardLink})
    expectRefusal(runBatch({"deform", mesh(), "--constraints", constraints(), "--out", out}), kUsage,
                  {"--out would overwrite the input"});
  expectRefusal(runBatch({"deform", mesh(), "--constraints", constraints(), "--report", constraints()}), kUsage,
                {"--report would overwrite the input"});
  expectRefusal(runBatch({"check", mesh(), "--report", mesh()}), kUsage, {"--report would overwrite the input"});
  EXPECT_EQ(bytesOf(mesh()), meshBytes);
  EXPECT_EQ(bytesOf(constraints()), constraintBytes);
  EXPECT_THAT(in_.names(), testing::ElementsAre("constraints.json", "sphere.obj"));
}

/// Tells whether a run with these arguments loads a library of VTK.
bool loadsVtk(const std::vector<std::string>& arguments)
{
  std::vector<std::string> command{"env", "LD_DEBUG=files", HOLDFAST_BATCH_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return runProcess(command).err.find("libvtk") != std::string::npos;
}

TEST_F(Usage, VtkIsLoadedWhereItIsNeededAlone)
{
  EXPECT_FALSE(loadsVtk(deform(mesh(), constraints())));
  EXPECT_TRUE(fs::exists(output("fields.vtp")));
  EXPECT_FALSE(loadsVtk({"check", mesh()}));
  EXPECT_FALSE(loadsVtk({"check", output("fields.vtp")}));
  const std::vector<std::vector<std::string>> more{
      {"--snapshot", output("picture.png")}, {"--no-such-option"}, {"--help"}};
  for (const std::vector<std::string>& options : more) {
    std::vector<std::string> whole{"deform", mesh(), "--constraints", constraints()};
    whole.insert(whole.end(), options.begin(), options.end());
    EXPECT_EQ(loadsVtk(whole), kHasVtk) << options.front();
  }
}

TEST_F(Usage, WithoutTheProgramBesideItThereIsNoVtk)
{
  const std::string alone = output("alone");
  std::filesystem::copy_file(HOLDFAST_BATCH_PROGRAM, alone);
  EXPECT_EQ(runProcess({alone, "check", mesh()}).exitCode, 0);
  expectRefusal(
      runProcess({alone, "deform", mesh(), "--constraints", constraints(), "--snapshot", output("picture.png")}),
      kUsage, {"--snapshot: there is no VTK to draw"});
}

TEST_F(Usage, HelpIsAnAnswer)
{
  const std::vector<std::vector<std::string>> questions{{"--help"}, {"deform", "--help"}, {"check", "--help"}};
  for (const auto& question : questions) {
    const ProcessResult result = runBatch(question);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Usage:"));
    EXPECT_EQ(result.err, "");
  }
  EXPECT_THAT(runBatch({"--help"}).out, HasSubstr("Exit codes: 0 all met, 2 usage"));
  EXPECT_THAT(runBatch({"deform", "--help"}).out, HasSubstr("--soft-weight"));
}

TEST_F(Usage, VersionIsAnAnswerEverywhere)
{
  const std::vector<std::vector<std::string>> questions{{"--version"}, {"deform", "--version"}, {"check", "--version"}};
  for (const auto& question : questions) {
    const ProcessResult result = runBatch(question);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, StartsWith("holdfast-batch "));
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(Usage, QuietPrintsNothingWhereverItStands)
{
  const std::vector<std::vector<std::string>> commands{
      deform(mesh(), constraints(), {"--quiet"}), {"check", mesh(), "--quiet"}, {"--quiet", "check", mesh()}};
  for (const auto& command : commands) {
    const ProcessResult result = runBatch(command);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
  }
  EXPECT_THAT(out_.names(), testing::ElementsAreArray(allOutputs()));
}

}  // namespace
}  // namespace holdfast::test
