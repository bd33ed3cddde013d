// What comes from outside (names, paths, values of options) reaches the terminal on one line, escaped and cut.

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/batch.h"
#include "support/meshes.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Clears the screen, forges a line, turns the direction of writing.
const std::string kHostile = "P\x1B[2J\r\nconflict: none\n\xE2\x80\xAE";
const std::string kHarmless = R"(P\x1b[2J\x0d\x0aconflict: none\x0a\xe2\x80\xae)";

/// Expects lines of a few thousand bytes at most, without control characters, of which none was forged.
void expectHarmless(const ProcessResult& result)
{
  const std::string all = result.out + result.err;
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](unsigned char c) { return (c < ' ' && c != '\n') || c == 0x7F; }))
      << all;
  EXPECT_THAT(all, Not(HasSubstr("\xE2\x80\xAE")));
  EXPECT_THAT("\n" + all, Not(HasSubstr("\nconflict: none")));
  EXPECT_LT(all.size(), 20000U);
}

class HostileTexts : public BatchTest {
 protected:
  /// A constraint file of two points at one vertex, which conflict, and a rigid region of one vertex, all of names that
  /// begin with `name`, with `name` as the unit as well.
  [[nodiscard]] std::string conflicting(const std::string& name) const
  {
    const auto point = [&](const std::string& suffix, int z) {
      return Json{{"type", "point"}, {"name", name + suffix}, {"at", {{"vertex", 0}}}, {"target", {0, 0, z}}};
    };
    const Json region{{"type", "rigid"}, {"name", name + "3"}, {"select", {{"vertices", {7}}}}};
    const Json file{{"format", "holdfast-constraints"},
                    {"version", 1},
                    {"units", name},
                    {"constraints", {point("1", 1), point("2", 2), region}}};
    return in_.file("hostile.json", file.dump()).string();
  }
};

TEST_F(HostileTexts, NamesAndUnitsAreEscapedWhereConflictsAndResultsAreTold)
{
  const std::vector<std::vector<std::string>> commands{deform(mesh(), conflicting(kHostile)),
                                                       {"check", mesh(), "--constraints", conflicting(kHostile)}};
  for (const auto& command : commands) {
    const ProcessResult result = runBatch(command);
    EXPECT_EQ(result.exitCode, 4) << result.err;
    expectHarmless(result);
    EXPECT_THAT(result.err, HasSubstr("conflict: \"" + kHarmless + "2\" cannot hold with \"" + kHarmless + "1\""));
    EXPECT_THAT(result.out, HasSubstr("diagonal 3.464 " + kHarmless + "\n")) << "the unit";
  }
}

TEST_F(HostileTexts, TheReportHasNamesAsTheyAre)
{
  EXPECT_EQ(runBatch(deform(mesh(), conflicting(kHostile))).exitCode, 4);
  const Json report = Json::parse(bytesOf(output("report.json")));
  EXPECT_EQ(report.at("constraints").at(0).at("name"), kHostile + "1");
}

TEST_F(HostileTexts, LongNamesAreCutBetweenCharacters)
{
  std::string name;
  for (int k = 0; k < 50000; ++k) name += "ö";
  const ProcessResult result = runBatch(deform(mesh(), conflicting(name)));
  EXPECT_EQ(result.exitCode, 4) << result.err;
  expectHarmless(result);
  EXPECT_THAT(result.err, HasSubstr("conflict: \"" + name.substr(0, 60) + "...\" cannot hold"));
}

TEST_F(HostileTexts, PathsAreEscaped)
{
  const std::string hostileMesh = in_.file(kHostile + ".obj", objText(icosphere(1))).string();
  const ProcessResult met =
      runBatch({"deform", hostileMesh, "--constraints", constraints(), "--out", output(kHostile + ".stl")});
  EXPECT_EQ(met.exitCode, 0) << met.err;
  expectHarmless(met);
  EXPECT_THAT(met.out, HasSubstr(kHarmless + ".obj: 42 vertices"));
  EXPECT_THAT(met.out, HasSubstr("wrote        " + output(kHarmless + ".stl")));
  for (const std::filesystem::path& path : {in_.path() / (kHostile + ".none"), in_.path() / kHostile / "none.obj"}) {
    const ProcessResult refused = runBatch({"check", path.string()});
    EXPECT_EQ(refused.exitCode, 3);
    expectHarmless(refused);
    EXPECT_THAT(refused.err, HasSubstr(kHarmless));
  }
}

TEST_F(HostileTexts, ValuesOfOptionsAreEscaped)
{
  const std::string longValue(100000, 'x');
  for (const std::string& value : {kHostile, longValue}) {
    const std::vector<std::string> options{"--weights", "--solver", "--backend",  "--soft-weight", "--rotations",
                                           "--out",     "--fields", "--snapshot", "--" + value,    value};
    for (const std::string& option : options) {
      const ProcessResult result = runBatch({"deform", mesh(), "--constraints", constraints(), option, value});
      EXPECT_EQ(result.exitCode, 2) << option << result.err;
      expectHarmless(result);
    }
  }
}

TEST_F(HostileTexts, KeysAndValuesOfFilesAreEscaped)
{
  const std::string key = Json(kHostile).dump();
  const std::vector<std::string> constraintTexts{
      "{" + key + ": 1}", R"({"type": )" + key + "}",
      R"({"type": "point", "name": )" + key + R"(, "at": {"vertex": 99999}, "target": [0, 0, 0]})"};
  for (const std::string& text : constraintTexts) {
    const ProcessResult result = runBatch(deform(mesh(), in_.file("c.json", constraintText({text})).string()));
    EXPECT_EQ(result.exitCode, 3) << result.err;
    expectHarmless(result);
  }
  for (const std::string extension : {".obj", ".ply", ".off", ".stl"}) {
    const ProcessResult result = runBatch({"check", in_.file("m" + extension, kHostile).string()});
    EXPECT_EQ(result.exitCode, 3) << result.err;
    expectHarmless(result);
  }
}

}  // namespace
}  // namespace holdfast::test
