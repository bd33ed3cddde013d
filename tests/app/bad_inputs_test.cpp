// Meshes and constraint files that cannot be used: exit code 3, what is wrong and where, and nothing written.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "app/batch.h"

namespace holdfast::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kInput = 3;

/// A file that is refused, and what the refusal says besides the name of the file.
struct BadFile {
  std::string what;  ///< letters and digits: the name of the test
  std::string name;
  std::string bytes;
  std::vector<std::string> messages;
};

std::ostream& operator<<(std::ostream& stream, const BadFile& file)
{
  return stream << file.what;
}

std::string nameOf(const testing::TestParamInfo<BadFile>& info)
{
  return info.param.what;
}

const std::string kPlyHeader =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

class BadMesh : public BatchTest, public testing::WithParamInterface<BadFile> {};

TEST_F(BatchTest, SkippedRowsAreNamedInMessagesAndReport)
{
  const std::string list =
      in_.file("list.csv",
               "name;x;y;z;target_x;target_y;target_z\nA;1;0;0;1,5;0;0\nB;0;1;0;NaN;NaN;NaN\nC;0;0;1;0;0;1\n")
          .string();
  expectRefusedWithoutTrace(deform(mesh(), list), kInput, {"list.csv:3: column target_x: \"NaN\" is not a number"});
  expectRefusedWithoutTrace(deform(mesh(), constraints(), {"--skip-bad-rows"}), kInput, {"no point list"});
  const ProcessResult result = runBatch(deform(mesh(), list, {"--skip-bad-rows"}));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const std::string fault = "column target_x: \"NaN\" is not a number; correct it";
  EXPECT_THAT(result.err, testing::HasSubstr("list.csv:3: \"B\" is skipped: " + fault));
  EXPECT_THAT(result.out, testing::HasSubstr("1 bad row of the point list"));
  const auto report = nlohmann::json::parse(bytesOf(output("report.json")));
  EXPECT_EQ(report["skipped_rows"], (nlohmann::json{{{"line", 3}, {"name", "B"}, {"fault", fault}}}));
  EXPECT_EQ(report["constraints"].size(), 2U);
  EXPECT_THAT(runBatch({"check", mesh(), "--constraints", list, "--skip-bad-rows"}).err,
              testing::HasSubstr("\"B\" is skipped"));
}

TEST_P(BadMesh, IsRefusedByName)
{
  const std::string file = in_.file(GetParam().name, GetParam().bytes).string();
  std::vector<std::string> messages = GetParam().messages;
  messages.push_back(file + ":");
  expectRefusedWithoutTrace(deform(file, constraints()), kInput, messages);
  expectRefusal(runBatch({"check", file, "--report", output("report.json")}), kInput, messages);
  EXPECT_THAT(out_.names(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Deform, BadMesh,
    testing::Values(
        BadFile{"CutInALine", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1", {"m.obj:3: "}},
        BadFile{"CutInTheCoordinates", "m.ply", kPlyHeader + std::string(30, '\0'), {"byte "}},
        BadFile{"CutInTheHeader", "m.ply", kPlyHeader.substr(0, kPlyHeader.find("end_header")), {"end_header"}},
        BadFile{"MoreVerticesClaimedThanThere", "m.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"m.off:"}},
        BadFile{"MoreFacesClaimedThanThere", "m.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"face"}},
        BadFile{"HugeCount", "m.off", "OFF\n1000000000000 1 0\n0 0 0\n", {"m.off:"}},
        BadFile{"NegativeCount", "m.off", "OFF\n-3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"m.off:2: "}},
        BadFile{"IndexOutOfRange", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", {"m.obj:4: ", "4"}},
        BadFile{"IndexZero", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", {"m.obj:4: ", "1"}},
        BadFile{"IndexOutOfRangeInOff", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"m.off:6: ", "3"}},
        BadFile{"OnlyFacesOfTwoCorners", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", {"no faces of three corners"}},
        BadFile{"NotANumber", "m.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"m.obj:1: ", "zero"}},
        BadFile{"EmptyFile", "m.obj", "", {"the file is empty"}},
        BadFile{"NoFaces", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"no faces"}},
        BadFile{"NoSize", "m.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", {"in one place"}},
        BadFile{"TooLargeForDoubles", "m.obj", "v -1e308 0 0\nv 1e308 0 0\nv 0 1 0\nf 1 2 3\n", {"scale it down"}},
        BadFile{"UnknownExtension", "m.step", "ISO-10303-21;\n", {"'.step'", ".obj"}},
        BadFile{"NoExtension", "mesh", "v 0 0 0\n", {"extension", ".obj"}},
        BadFile{"AnotherFormatThanItsName", "m.ply", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"ply"}}),
    nameOf);

class BadConstraints : public BatchTest, public testing::WithParamInterface<BadFile> {};

TEST_P(BadConstraints, AreRefusedByPlace)
{
  const std::string file = in_.file(GetParam().name, GetParam().bytes).string();
  std::vector<std::string> messages = GetParam().messages;
  messages.push_back(file + ":");
  expectRefusedWithoutTrace(deform(mesh(), file), kInput, messages);
  expectRefusal(runBatch({"check", mesh(), "--constraints", file, "--report", output("report.json")}), kInput,
                messages);
  EXPECT_THAT(out_.names(), IsEmpty());
}

/// A constraint file whose second constraint is the bad one.
BadFile second(const std::string& what, const std::string& constraint, const std::vector<std::string>& messages)
{
  return {what, "c.json",
          constraintText({R"({"type": "fixed", "name": "base", "select": {"vertices": [0]}})", constraint}), messages};
}

INSTANTIATE_TEST_SUITE_P(
    Deform, BadConstraints,
    testing::Values(
        BadFile{"NotJson", "c.json", "{\"format\": \"holdfast-constraints\",\n\"version\": 1,\n oops}", {"c.json:3"}},
        BadFile{"Empty", "c.json", "", {"c.json"}},
        BadFile{"AnotherFormat", "c.json", R"({"format": "holdfast-report", "version": 1})", {"format"}},
        BadFile{"ALaterVersion",
                "c.json",
                R"({"format": "holdfast-constraints", "version": 3, "constraints": []})",
                {"version"}},
        BadFile{"PointListWithoutAColumn", "c.csv", "name,x,y,z\nP,0,0,0\n", {"c.csv:1", "target_x"}},
        BadFile{"PointListWithWords",
                "c.csv",
                "name,x,y,z,target_x,target_y,target_z\nP,0,0,zero,0,0,0\n",
                {"c.csv:2", "zero"}},
        second("UnknownKey", R"({"type": "point", "name": "P", "at": {"vertex": 3}, "targt": [0, 0, 0]})",
               {"constraints[1]", "targt"}),
        second("UnknownType", R"({"type": "spring", "name": "P"})", {"constraints[1].type", "spring"}),
        second("WrongType", R"({"type": "point", "name": "P", "at": {"vertex": "3"}, "target": [0, 0, 0]})",
               {"constraints[1].at.vertex"}),
        second("TwoCoordinates", R"({"type": "point", "name": "P", "at": {"vertex": 3}, "target": [0, 0]})",
               {"constraints[1].target"}),
        second("WeightsThatDoNotSumToOne",
               R"({"type": "point", "name": "P", "at": {"face": 3, "weights": [0.5, 0.25, 0]}, "target": [0, 0, 0]})",
               {"constraints[1].at.weights", "sum to 0.75"}),
        second("NegativeWeight",
               R"({"type": "point", "name": "P", "at": {"face": 3, "weights": [-0.5, 1, 0.5]}, "target": [0, 0, 0]})",
               {"constraints[1].at.weights[0]", "-0.5"}),
        second("WeightsForAnotherFace",
               R"({"type": "point", "name": "P", "at": {"face": 3, "weights": [0.5, 0.5]}, "target": [0, 0, 0]})",
               {"constraints[1].at.weights", "3 corners"}),
        second("VertexOutOfRange", R"({"type": "point", "name": "P", "at": {"vertex": 162}, "target": [0, 0, 0]})",
               {"constraints[1].at.vertex", "162 vertices"}),
        second("FaceOutOfRange",
               R"({"type": "point", "name": "P", "at": {"face": 320, "weights": [1, 0, 0]}, "target": [0, 0, 0]})",
               {"constraints[1].at.face", "320 faces"}),
        second("SelectedVertexOutOfRange", R"({"type": "fixed", "name": "F", "select": {"vertices": [1, 162]}})",
               {"constraints[1].select.vertices", "162"}),
        second("NoSuchEdge", R"({"type": "point", "name": "P", "at": {"edge": [0, 1], "t": 0.5}, "target": [0, 0, 0]})",
               {"constraints[1].at.edge", "0 and 1"}),
        second("EmptySelection",
               R"({"type": "fixed", "name": "F", "select": {"sphere": {"center": [9, 9, 9], "radius": 1}}})",
               {"constraints[1].select", "selects no vertex"}),
        second("ATargetThatIsTooLarge",
               R"({"type": "point", "name": "P", "at": {"vertex": 3}, "target": [1e999, 0, 0]})", {"c.json:3"}),
        second("RepeatedName", R"({"type": "fixed", "name": "base", "select": {"vertices": [1]}})",
               {"constraints[1].name", "base"})),
    nameOf);

TEST_F(BatchTest, AnUnknownFormatIsAnsweredWithAllThatAreKnown)
{
  for (const std::string name : {"m.step", "mesh"})
    expectRefusal(runBatch({"check", in_.file(name, "ISO-10303-21;\n").string()}), kInput,
                  {name + ": ", "use .obj, .ply, .off, .stl, .vtp\n"});
}

class MissingFile : public BatchTest {};

TEST_F(MissingFile, AMissingMeshIsNamed)
{
  const std::string missing = (in_.path() / "missing.obj").string();
  expectRefusedWithoutTrace(deform(missing, constraints()), kInput, {missing, "there is no such file"});
}

TEST_F(MissingFile, MissingConstraintsAreNamed)
{
  const std::string missing = (in_.path() / "missing.json").string();
  expectRefusedWithoutTrace(deform(mesh(), missing), kInput, {missing, "there is no such file"});
}

TEST_F(MissingFile, ADirectoryIsNoMesh)
{
  const std::filesystem::path folder = in_.path() / "folder.obj";
  std::filesystem::create_directory(folder);
  expectRefusedWithoutTrace(deform(folder.string(), constraints()), kInput, {folder.string(), "directory"});
  expectRefusedWithoutTrace(deform(in_.path().string(), constraints()), kInput, {in_.path().string(), "directory"});
}

TEST_F(MissingFile, WhatIsNoFileIsNoMeshInAnyFormat)
{
  namespace fs = std::filesystem;
  ProcessOptions options;
  options.timeout = std::chrono::seconds(30);
  const auto expectRefused = [&](const fs::path& path, const std::string& reason) {
    expectRefusal(runBatch({"check", path.string()}, options), kInput, {path.string() + ": ", reason});
  };
  for (const std::string extension : {".obj", ".vtp"}) {
    const fs::path pipe = in_.path() / ("pipe" + extension);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expectRefused(pipe, "is not a regular file");
    fs::create_symlink("/dev/zero", in_.path() / ("zero" + extension));
    expectRefused(in_.path() / ("zero" + extension), "is not a regular file");
    fs::create_symlink("loop" + extension, in_.path() / ("loop" + extension));
    expectRefused(in_.path() / ("loop" + extension), "Too many levels of symbolic links");
    expectRefused(std::string(5000, 'n') + extension, "File name too long");
  }
}

TEST_F(MissingFile, ADirectoryIsNoConstraintFile)
{
  expectRefusedWithoutTrace(deform(mesh(), in_.path().string()), kInput, {in_.path().string(), "directory"});
}

class NonFiniteMesh : public BatchTest {
 protected:
  [[nodiscard]] std::string brokenMesh(const std::string& coordinate) const
  {
    return in_.file("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 " + coordinate + " 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n").string();
  }
};

TEST_F(NonFiniteMesh, IsRefusedByTheVertex)
{
  for (const std::string coordinate : {"nan", "inf", "-inf"}) {
    const std::string file = brokenMesh(coordinate);
    expectRefusal(runBatch(deform(file, constraints())), kInput, {file + ": vertex 2: ", "not a finite number"});
    EXPECT_THAT(out_.names(), IsEmpty());
  }
}

TEST_F(NonFiniteMesh, IsCheckedAndReported)
{
  const std::string file = brokenMesh("nan");
  expectRefusal(runBatch({"check", file, "--report", output("report.json")}), kInput, {file + ": vertex 2: "});
  EXPECT_THAT(out_.names(), ElementsAre("report.json"));
  const auto report = nlohmann::json::parse(bytesOf(output("report.json")));
  EXPECT_EQ(report.at("mesh").at("vertices"), 4);
  const auto& finding = report.at("mesh").at("findings").at(0);
  EXPECT_EQ(finding.at("kind"), "non_finite_coordinates");
  EXPECT_EQ(finding.at("count"), 1);
  EXPECT_EQ(finding.at("ids"), nlohmann::json::array({2}));
}

}  // namespace
}  // namespace holdfast::test
