// Sessions as constraint files: their options count where the command line says nothing, and the summary says so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/batch.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SessionOptions : public BatchTest {
 protected:
  /// A session of this test's constraints with `options`, the text of an object.
  [[nodiscard]] std::string session(const std::string& options) const
  {
    Json json = Json::parse(bytesOf(constraints()));
    json["mesh"] = {{"path", "sphere.obj"}};
    json["options"] = Json::parse(options);
    return in_.file("s.holdfast", json.dump()).string();
  }

  /// What the report of a run says of its solution.
  [[nodiscard]] Json solved(const std::string& constraintPath, const std::vector<std::string>& more) const
  {
    const ProcessResult result = runBatch(deform(mesh(), constraintPath, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return Json::parse(bytesOf(output("report.json"))).at("solve");
  }
};

TEST_F(SessionOptions, CountWhereTheCommandLineSaysNothing)
{
  const std::string path = session(R"({"weights": "uniform", "solver": "soft", "soft_weight": 7, "backend": "eigen"})");
  const Json solve = solved(path, {});
  EXPECT_EQ(solve.at("weights"), "uniform");
  EXPECT_EQ(solve.at("solver"), "soft");
  EXPECT_EQ(solve.at("soft_weight"), 7);
  EXPECT_EQ(solve.at("backend"), "eigen");
}

TEST_F(SessionOptions, GiveTheMeshThatTheSameOptionsOnTheCommandLineGive)
{
  static_cast<void>(solved(session(R"({"weights": "uniform", "solver": "soft", "soft_weight": 7})"), {}));
  const std::string bySession = bytesOf(output("out.obj"));
  static_cast<void>(solved(constraints(), {"--weights", "uniform", "--solver", "soft", "--soft-weight", "7"}));
  EXPECT_TRUE(bytesOf(output("out.obj")) == bySession);
  static_cast<void>(solved(constraints(), {}));
  EXPECT_FALSE(bytesOf(output("out.obj")) == bySession);
}

TEST_F(SessionOptions, WeldAndTellWhichPlacesAreFar)
{
  const std::string seam = in_.file("seam.off",
                                    "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1.000000001 0 0\n2 0 0\n2 1 0\n"
                                    "1.000000001 1 0\n4 0 1 2 3\n4 4 5 6 7\n")
                               .string();
  const auto findingsOf = [&](const std::string& path, const std::vector<std::string>& more) {
    std::vector<std::string> command{"check", seam, "--constraints", path, "--report", output("report.json")};
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult result = runBatch(command);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    std::vector<std::string> kinds;
    const Json report = Json::parse(bytesOf(output("report.json")));
    for (const Json& finding : report["mesh"]["findings"]) kinds.push_back(finding["kind"]);
    return kinds;
  };
  const std::string list = constraintText({R"({"type": "point", "at": {"near": [0.5, 0.5, 0.2]}, "move": [0, 0, 0]})"});
  const std::string plain = in_.file("near.json", list).string();
  EXPECT_THAT(findingsOf(plain, {}), testing::IsSupersetOf({"nearly_coincident_vertices", "places_off_surface"}));
  EXPECT_THAT(runBatch({"check", seam, "--constraints", plain}).err,
              AllOf(HasSubstr("warning: 2 vertices at open edges nearly coincide"),
                    HasSubstr("warning: 1 constraint names a place"), HasSubstr("\"point 1\"")));
  EXPECT_THAT(runBatch({"check", seam, "--constraints", plain}).out, HasSubstr("at most 0.2 mm from the surface"));
  const std::vector<std::string> good = findingsOf(plain, {"--weld", "1e-8", "--near-limit", "0.5"});
  EXPECT_THAT(good, testing::Contains("welded_near_vertices"));
  EXPECT_THAT(good, Not(testing::Contains("places_off_surface")));
  Json json = Json::parse(list);
  json["mesh"] = {{"path", "seam.off"}};
  json["options"] = {{"weld", 1e-8}, {"near_limit", 0.5}};
  EXPECT_EQ(findingsOf(in_.file("seam.holdfast", json.dump()).string(), {}), good);
}

TEST_F(SessionOptions, FindRotations)
{
  const Json bySession = solved(session(R"({"rotations": "found", "rotation_change": 1e-7})"), {});
  EXPECT_EQ(bySession.at("rotations"), "found");
  EXPECT_EQ(bySession.at("rotation_stop"), "converged");
  EXPECT_LE(bySession.at("rotation_change"), 1e-7);
  const std::string mesh = bytesOf(output("out.obj"));
  static_cast<void>(solved(constraints(), {"--rotations", "found", "--rotation-change", "1e-7"}));
  EXPECT_TRUE(bytesOf(output("out.obj")) == mesh);
  EXPECT_EQ(solved(constraints(), {"--rotations", "found-smooth"}).at("rotations"), "found-smooth");
  EXPECT_FALSE(bytesOf(output("out.obj")) == mesh);
  const Json given = solved(session(R"({"rotations": "found"})"), {"--rotations", "given"});
  EXPECT_EQ(given.at("rotations"), "given");
  EXPECT_TRUE(given.at("rotation_stop").is_null());
}

TEST_F(SessionOptions, GiveWayToTheCommandLineOneByOne)
{
  const std::string path = session(R"({"weights": "uniform", "solver": "soft", "soft_weight": 7})");
  const Json solve = solved(path, {"--weights", "cotangent", "--soft-weight", "5"});
  EXPECT_EQ(solve.at("weights"), "cotangent");
  EXPECT_EQ(solve.at("solver"), "soft");
  EXPECT_EQ(solve.at("soft_weight"), 5);
}

TEST_F(SessionOptions, AreNamedInTheSummaryWithTheSession)
{
  const std::string path = session(R"({"weights": "uniform", "solver": "soft", "soft_weight": 7})");
  EXPECT_THAT(runBatch(deform(mesh(), path)).out,
              HasSubstr("options      weights uniform, solver soft, soft weight 7: taken from " + path + "\n"));
  EXPECT_THAT(runBatch(deform(mesh(), path, {"--solver", "hard", "--soft-weight", "5"})).out,
              HasSubstr("options      weights uniform: taken from " + path + "\n"));
  EXPECT_THAT(runBatch(deform(mesh(), path, {"--solver", "hard", "--soft-weight", "5", "--weights", "cotangent"})).out,
              Not(HasSubstr("options ")));
  EXPECT_THAT(runBatch(deform(mesh(), constraints())).out, Not(HasSubstr("options ")));
  const std::string found = session(R"({"rotations": "found", "rotation_change": 0.001})");
  EXPECT_THAT(runBatch(deform(mesh(), found)).out,
              AllOf(HasSubstr("options      rotations found, rotation change 0.001: taken from " + found + "\n"),
                    HasSubstr("\nrotations    found in ")));
}

TEST_F(SessionOptions, ThatDoNotExistAreRefusedByTheirPlace)
{
  expectRefusedWithoutTrace(deform(mesh(), session(R"({"solver": "firm"})")), 3,
                            {"s.holdfast: options.solver: \"firm\" is not known here"});
}

TEST_F(SessionOptions, ForcesNeedTheSolverHardWhoeverChoseAnother)
{
  if (!kHasVtk) GTEST_SKIP() << "pictures need a build with VTK";
  expectRefusal(runBatch(deform(mesh(), session(R"({"solver": "soft"})"),
                                {"--snapshot", output("p.png"), "--color-by", "force"})),
                2, {"--color-by: forces are known with --solver hard only"});
}

}  // namespace
}  // namespace holdfast::test
