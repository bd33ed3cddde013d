#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

/// What a run of holdfast-batch left behind.
struct Outcome {
  int exitCode = -1;
  std::string messages;
};

/// The bar of the examples, deformed in `folder`. `environment` goes before the program, `options` after.
Outcome deformBar(const test::TemporaryFolder& folder, const std::string& environment, const std::string& options)
{
  const std::string data = test::dataFolder();
  const std::string messages = (folder.path() / "stderr").string();
  const std::string command = "cd '" + folder.path().string() + "' && " + environment +
                              " '" HOLDFAST_BATCH "' deform '" + data + "/bar.obj' --constraints '" + data +
                              "/bar.constraints.json' --quiet " + options + " 2>'" + messages + "'";
  const int status = std::system(command.c_str());
  Outcome run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::bytesOf(messages)};
  std::filesystem::remove(messages);
  return run;
}

std::size_t bigEndian(const std::string& bytes, std::size_t at)
{
  std::size_t value = 0;
  for (std::size_t k = at; k < at + 4; ++k) value = 256 * value + static_cast<unsigned char>(bytes[k]);
  return value;
}

TEST(SnapshotOption, WritesAPngOfTheSizeThatWasAskedFor)
{
  const test::TemporaryFolder folder;
  const Outcome run = deformBar(folder, "", "--snapshot bar.png --color-by detail --size 200x120");
  EXPECT_EQ(run.exitCode, 0) << run.messages;
  const std::string bytes = test::bytesOf(folder.path() / "bar.png");
  ASSERT_GT(bytes.size(), 24);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(bigEndian(bytes, 16), 200);
  EXPECT_EQ(bigEndian(bytes, 20), 120);
}

TEST(SnapshotOption, SameBytesOnEveryRun)
{
  const test::TemporaryFolder folder;
  EXPECT_EQ(deformBar(folder, "", "--snapshot a.png --size 320x240").exitCode, 0);
  EXPECT_EQ(deformBar(folder, "", "--snapshot b.png --size 320x240").exitCode, 0);
  EXPECT_EQ(test::bytesOf(folder.path() / "a.png"), test::bytesOf(folder.path() / "b.png"));
}

TEST(SnapshotOption, WithoutADisplayNothingIsWrittenAndTheRemedyIsNamed)
{
  for (const char* const environment : {"env -u DISPLAY", "env DISPLAY=", "env DISPLAY=:9999"}) {
    const test::TemporaryFolder folder;
    const Outcome run = deformBar(folder, environment, "--snapshot bar.png --out bar.obj");
    EXPECT_EQ(run.exitCode, 6) << environment;
    EXPECT_NE(run.messages.find("bar.png: pictures need an X server"), std::string::npos) << run.messages;
    EXPECT_NE(run.messages.find("xvfb-run"), std::string::npos) << run.messages;
    EXPECT_TRUE(folder.names().empty()) << environment;
  }
}

TEST(SnapshotOption, WithoutADisplayAllElseStillWorks)
{
  const test::TemporaryFolder folder;
  EXPECT_EQ(deformBar(folder, "env -u DISPLAY", "--out bar.obj").exitCode, 0);
}

TEST(SnapshotOption, MistakesAreUsageErrorsThatSayWhatToWrite)
{
  const test::TemporaryFolder folder;
  const auto expectUsage = [&](const std::string& options, const std::string& hint) {
    const Outcome run = deformBar(folder, "", options);
    EXPECT_EQ(run.exitCode, 2) << options;
    EXPECT_NE(run.messages.find(hint), std::string::npos) << run.messages;
  };
  expectUsage(
      "--snapshot p.png --color-by angles",
      "none, constraint-residual, rotation, angle, displacement, detail, force, displacement-x, displacement-y, "
      "displacement-z, displacement-normal, area-change, edge-change");
  expectUsage("--snapshot p.png --color-by force --solver soft", "--solver hard only");
  expectUsage("--snapshot p.jpg", "does not end in .png");
  for (const char* const size : {"15x100", "100x16385", "100", "100x", "x100", "100x100x", "-20x30", "1e3x100", "''"})
    expectUsage(std::string("--snapshot p.png --size ") + size, "such as 1280x960");
  expectUsage("--snapshot p.png --size 16384x16384", "67108864 pixels, for which drawing takes 2.5 GiB");
  expectUsage("--color-by none", "--snapshot");
  expectUsage("--snapshot p.png --report p.png", "name the same file");
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace holdfast
