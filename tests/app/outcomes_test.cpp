// What a run comes to: met, conflicts, numerical failure; its exit code, its words, its files and its report.

#include <algorithm>
#include <limits>
#include <sstream>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/batch.h"
#include "app/report_schema.h"
#include "support/meshes.h"
#include "support/residual_verifier.h"

namespace holdfast::test {
namespace {

/// How many lines begin so.
Index linesOf(const std::string& text, std::string_view start)
{
  Index count = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(start)) ++count;
  return count;
}

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::Not;

constexpr int kConflicts = 4;
constexpr int kNumerical = 5;

class Outcome : public BatchTest {
 protected:
  [[nodiscard]] Json report() const { return Json::parse(bytesOf(output("report.json"))); }

  void expectStatuses(const std::vector<std::string>& expected) const
  {
    const Json report = this->report();
    std::vector<std::string> statuses;
    for (const Json& constraint : report["constraints"]) statuses.push_back(constraint["status"]);
    EXPECT_EQ(statuses, expected);
  }
};

TEST_F(Outcome, MetConstraintsAreReportedAsMet)
{
  EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0);
  const Json report = this->report();
  EXPECT_TRUE(isReport(report, SolveState::Solved));
  EXPECT_EQ(report["mesh"]["vertices"], 162);
  EXPECT_EQ(report["mesh"]["faces"], 320);
  EXPECT_EQ(report["mesh"]["components"], 1);
  EXPECT_EQ(report["solve"]["status"], "ok");
  EXPECT_EQ(report["solve"]["weights"], "cotangent");
  EXPECT_EQ(report["solve"]["solver"], "hard");
  EXPECT_LE(report["solve"]["max_residual_relative"], kPromisedResidual);
  ASSERT_EQ(report["constraints"].size(), 3U);
  for (const Json& constraint : report["constraints"]) EXPECT_EQ(constraint["status"], "met") << constraint;
}

TEST_F(Outcome, EverySolverAndWeightIsReportedByItsName)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> options{
      {"--weights", {"cotangent", "cotangent-paper", "uniform"}},
      {"--solver", {"hard", "soft", "lagrange"}},
      {"--backend", {"eigen"}}};
  for (const auto& [option, values] : options)
    for (const std::string& value : values) {
      SCOPED_TRACE(testing::Message() << option << " " << value);
      const ProcessResult result = runBatch(deform(mesh(), constraints(), {option, value}));
      EXPECT_EQ(result.exitCode, 0) << result.err;
      EXPECT_TRUE(isReport(report(), SolveState::Solved));
      EXPECT_EQ(report()["solve"][option.substr(2)], value);
    }
}

TEST_F(Outcome, SoftConstraintsThatAreMissedAreNotCalledMet)
{
  EXPECT_EQ(runBatch(deform(mesh(), constraints(), {"--solver", "soft"})).exitCode, 0);
  EXPECT_GT(report()["solve"]["max_residual_relative"], kPromisedResidual);
  EXPECT_EQ(report()["constraints"][1]["status"], "missed");
  EXPECT_FALSE(meetsConstraints(mesh(), output("out.obj"), constraints()));
}

TEST_F(Outcome, NeitherSizeNorUnitsMatter)
{
  for (const double scale : {1e-300, 1e-100, 1e100, 1e300}) {
    SCOPED_TRACE(scale);
    Mesh sheet = grid(8, 8);
    sheet.positions *= scale;
    const std::string file = in_.file("sheet.obj", objText(sheet)).string();
    std::ostringstream shift;
    shift << R"("move": [0, 0, )" << scale << "]}";
    const std::string task =
        in_.file(
               "task.json",
               constraintText({R"({"type": "fixed", "select": {"vertices": [0, 1, 2, 3, 4, 5, 6, 7, 8]}})",
                               R"({"type": "point", "at": {"vertex": 80}, )" + shift.str(),
                               R"({"type": "point", "at": {"face": 70, "weights": [0.2, 0.3, 0.5]}, )" + shift.str()}))
            .string();
    const ProcessResult result = runBatch(deform(file, task));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(meetsConstraints(file, output("out.obj"), task));
    EXPECT_EQ(report()["mesh"]["findings"].size(), 1U) << "the border, and no needle: " << report()["mesh"]["findings"];
  }
}

TEST_F(Outcome, AFileOfSinglePrecisionIsNotCalledExact)
{
  const std::vector<std::string> command{"deform",          mesh(),     "--constraints",      constraints(), "--out",
                                         output("out.stl"), "--report", output("report.json")};
  const ProcessResult result = runBatch(command);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: " + output("out.stl") + ": STL stores single precision"));
  EXPECT_THAT(report()["solve"]["message"].get<std::string>(), HasSubstr("misses them by up to"));
  EXPECT_GT(report()["solve"]["max_residual_relative"], kPromisedResidual);
  EXPECT_EQ(report()["constraints"][1]["status"], "missed");
}

TEST_F(Outcome, AResultThatIsNotFineWarnsAndEndsWithSuccess)
{
  const std::string sheet = in_.file("sheet.obj", objText(grid(6, 6))).string();
  const std::string task =
      in_.file(
             "over.json",
             constraintText({R"({"type": "fixed", "name": "rim", "select": {"vertices": [0, 1, 2, 3, 4, 5, 6, 7, 13, 14,
                                20, 21, 27, 28, 34, 35, 41, 42, 43, 44, 45, 46, 47, 48]}})",
                             R"({"type": "point", "name": "middle", "at": {"vertex": 24}, "move": [2.5, 0, 0]})"}))
          .string();
  const ProcessResult result = runBatch(deform(sheet, task));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("warning: 2 faces are turned over against the surface around"));
  EXPECT_THAT(result.out, HasSubstr("result       doubtful: folded faces"));
  EXPECT_EQ(report()["result"]["status"], "doubtful");
  EXPECT_EQ(report()["result"]["inverted_faces"], 2);
  EXPECT_EQ(report()["solve"]["status"], "ok");
}

class ConflictingConstraints : public Outcome {
 protected:
  [[nodiscard]] const std::string& conflicts() const { return conflicts_; }

  void expectConflictsOnStandardError(const ProcessResult& result) const
  {
    EXPECT_EQ(result.exitCode, kConflicts) << result.err;
    EXPECT_THAT(result.err, HasSubstr("conflict: \"torn off\" cannot hold with \"base\": off by 0.5 mm (0, 0, 0.5); "
                                      "disable \"torn off\", or give it the target ("));
    EXPECT_THAT(result.err, HasSubstr("conflict: \"too far\" cannot hold with \"top\": off by 0.75 mm (0, 0, 0.75); "
                                      "disable \"too far\", or give it the target ("));
    EXPECT_THAT(result.err,
                HasSubstr("conflict: 2 constraints in all; with all of them disabled no conflict is left\n"));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 3) << result.err;
  }

 private:
  std::string conflicts_ =
      in_.file("conflicts.json",
               constraintText({R"({"type": "fixed", "name": "base", "select": {"vertices": [0, 1, 2]}})",
                               R"({"type": "point", "name": "top", "at": {"vertex": 3}, "move": [0, 0, 0.25]})",
                               R"({"type": "point", "name": "top again", "at": {"vertex": 3}, "move": [0, 0, 0.25]})",
                               R"({"type": "point", "name": "torn off", "at": {"vertex": 1}, "move": [0, 0, 0.5]})",
                               R"({"type": "point", "name": "too far", "at": {"vertex": 3}, "move": [0, 0, 1]})",
                               R"({"type": "point", "name": "not asked", "at": {"vertex": 9}, "move": [0, 0, 1],
                                   "enabled": false})"}))
          .string();
};

TEST_F(ConflictingConstraints, AreNamedAndEverythingIsWritten)
{
  expectConflictsOnStandardError(runBatch(deform(mesh(), conflicts())));
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  EXPECT_TRUE(meetsConstraints(mesh(), output("out.obj"), conflicts(), {"torn off", "too far"}));
  EXPECT_FALSE(meetsConstraints(mesh(), output("out.obj"), conflicts(), {"torn off"}));
}

TEST_F(ConflictingConstraints, AreNamedEvenWhenQuiet)
{
  const ProcessResult result = runBatch(deform(mesh(), conflicts(), {"--quiet"}));
  expectConflictsOnStandardError(result);
  EXPECT_EQ(result.out, "");
}

TEST_F(ConflictingConstraints, AreFoundByCheckToo)
{
  expectConflictsOnStandardError(
      runBatch({"check", mesh(), "--constraints", conflicts(), "--report", output("report.json")}));
  EXPECT_THAT(out_.names(), ElementsAre("report.json"));
  EXPECT_TRUE(isReport(report(), SolveState::NotRun));
  expectStatuses({"independent", "independent", "redundant", "conflicting", "conflicting", "disabled"});
}

TEST_F(ConflictingConstraints, AreCountedInTheSummary)
{
  const std::string dependent = ", 1 redundant, 2 conflicting, 1 disabled\n";
  EXPECT_THAT(runBatch(deform(mesh(), conflicts())).out, HasSubstr("rows, 2 met" + dependent));
  EXPECT_THAT(runBatch({"check", mesh(), "--constraints", conflicts()}).out,
              HasSubstr("rows, 2 independent" + dependent));
}

TEST_F(ConflictingConstraints, AreReportedWithPartnersAndGap)
{
  EXPECT_EQ(runBatch(deform(mesh(), conflicts())).exitCode, kConflicts);
  const Json report = this->report();
  EXPECT_TRUE(isReport(report, SolveState::Solved));
  EXPECT_EQ(report["solve"]["status"], "conflicts");
  const Json& list = report["constraints"];
  expectStatuses({"met", "met", "redundant", "conflicting", "conflicting", "disabled"});
  EXPECT_EQ(list[2]["depends_on"], Json::array({"top"}));
  EXPECT_EQ(list[4]["depends_on"], Json::array({"top"}));
  EXPECT_DOUBLE_EQ(list[4]["gap"], 0.75);
  EXPECT_DOUBLE_EQ(list[4]["residual"], 0.75);
  EXPECT_LE(report["solve"]["max_residual_relative"], kPromisedResidual) << "what was left out does not count";
}

TEST_F(ConflictingConstraints, AreMetOnceTheRepairIsMade)
{
  EXPECT_EQ(runBatch(deform(mesh(), conflicts())).exitCode, kConflicts);
  const Json report = this->report();
  Json repaired = Json::parse(bytesOf(conflicts()));
  for (std::size_t k : {3U, 4U}) {
    const Json& conflictSets = report["constraints"][k]["clashes"];
    ASSERT_EQ(conflictSets.size(), 1U);
    Json& constraint = repaired["constraints"][k];
    constraint.erase("move");
    constraint["target"] = conflictSets[0]["repair"]["consistent_target"];
  }
  const std::string task = in_.file("repaired.json", repaired.dump()).string();
  EXPECT_EQ(runBatch(deform(mesh(), task)).exitCode, 0);
  expectStatuses({"met", "met", "redundant", "redundant", "redundant", "disabled"});
}

TEST_F(ConflictingConstraints, MakeASoftSolutionACompromiseThatSaysSo)
{
  const ProcessResult result = runBatch(deform(mesh(), conflicts(), {"--solver", "soft"}));
  expectConflictsOnStandardError(result);
  EXPECT_THAT(result.out, HasSubstr("a compromise: 2 of 6 constraints conflict"));
  EXPECT_THAT(report()["solve"]["message"].get<std::string>(), HasSubstr("a compromise: 2 of 6 constraints conflict"));
  EXPECT_EQ(report()["constraints"][1]["status"], "missed") << "a soft constraint gives way to what contradicts it";
}

TEST_F(ConflictingConstraints, OfManyPointsAreNamedInNoMoreThanAFewLines)
{
  std::vector<std::string> task;
  for (const char* vertex : {"0", "1", "2", "3", "4", "5", "6", "7", "8"})
    task.push_back(std::string(R"({"type": "point", "move": [0, 0, 0], "name": "P)") + vertex +
                   R"(", "at": {"vertex": )" + vertex + "}}");
  task.emplace_back(R"({"type": "handle", "name": "whole", "translate": [0, 0, 1],
                        "select": {"halfspace": {"point": [0, 0, -9], "normal": [0, 0, 1]}}})");
  const ProcessResult result = runBatch(deform(mesh(), in_.file("many.json", constraintText(task)).string()));
  EXPECT_EQ(result.exitCode, kConflicts) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("conflict: \"whole\" cannot hold with \"P0\" in 1 of its 162 rows: off by up to 1 mm "
                        "(0, 0, 1); disable \"whole\"\n"));
  EXPECT_THAT(result.err, HasSubstr("conflict: \"whole\" cannot hold in 4 more ways; the report lists them\n"));
  EXPECT_EQ(linesOf(result.err, "conflict: "), 6) << result.err;
}

TEST_F(Outcome, TheConstraintsThatPullHardestAreNamed)
{
  const ProcessResult result = runBatch(deform(mesh(), constraints()));
  Json list = report()["constraints"];
  std::stable_sort(list.begin(), list.end(), [](const Json& a, const Json& b) { return a["force"] > b["force"]; });
  EXPECT_GT(list[0]["force"], 0);
  EXPECT_THAT(result.out, HasSubstr("pull         hardest: \"" + list[0]["name"].get<std::string>() + "\" "));
  EXPECT_THAT(runBatch(deform(mesh(), constraints(), {"--solver", "soft"})).out, Not(HasSubstr("hardest")));
}

class FailedNumerics : public Outcome {
 protected:
  /// A sheet with a triangle whose corners lie on one line.
  [[nodiscard]] std::string flatTriangle() const
  {
    Mesh mesh = grid(6, 6);
    mesh.faces.add({0, 2, 1});
    return in_.file("flat.obj", objText(mesh)).string();
  }
  [[nodiscard]] std::string corners() const
  {
    return in_
        .file("corners.json",
              constraintText({R"({"type": "fixed", "select": {"box": {"min": [0, 0, 0], "max": [0, 6, 0]}}})",
                              R"({"type": "point", "at": {"vertex": 48}, "move": [0, 0, 1]})"}))
        .string();
  }
};

TEST_F(FailedNumerics, LeaveAReportWithTheReasonAndNoMesh)
{
  const ProcessResult result = runBatch(deform(flatTriangle(), corners(), {"--weights", "cotangent-paper"}));
  EXPECT_EQ(result.exitCode, kNumerical) << result.err;
  EXPECT_THAT(result.err, HasSubstr("error: the weights \"cotangent-paper\" are not finite at 3 vertices"));
  EXPECT_THAT(result.err, HasSubstr("vertex 0"));
  EXPECT_THAT(result.err,
              HasSubstr("; use the weights \"cotangent\", which are guarded against that, or repair those faces\n"));
  EXPECT_THAT(out_.names(), ElementsAre("report.json"));
  EXPECT_TRUE(isReport(report(), SolveState::Failed));
  expectStatuses({"independent", "independent"});
  EXPECT_THAT(result.out, HasSubstr(", 2 independent\n"));
  EXPECT_THAT(result.err, HasSubstr(report()["solve"]["message"].get<std::string>()));
}

TEST_F(FailedNumerics, KeepTheOldMesh)
{
  putOldOutputs();
  const ProcessResult result = runBatch(deform(flatTriangle(), corners(), {"--weights", "cotangent-paper"}));
  EXPECT_EQ(result.exitCode, kNumerical) << result.err;
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  EXPECT_EQ(bytesOf(output("out.obj")), "an old file");
  EXPECT_NE(bytesOf(output("report.json")), "an old file");
}

TEST_F(FailedNumerics, DoNotHappenWithGuardedWeights)
{
  EXPECT_EQ(runBatch(deform(flatTriangle(), corners())).exitCode, 0);
  EXPECT_TRUE(meetsConstraints(flatTriangle(), output("out.obj"), corners()));
}

TEST_F(FailedNumerics, NameConstraintsThatAreTooCloseToTellApart)
{
  const std::string task =
      in_.file(
             "close.json",
             constraintText({R"({"type": "fixed", "select": {"box": {"min": [0, 0, 0], "max": [0, 6, 0]}}})",
                             R"({"type": "point", "name": "A", "at": {"edge": [24, 25], "t": 0.3}, "move": [0, 0, 0]})",
                             R"({"type": "point", "name": "B", "at": {"edge": [24, 25], "t": 0.30000001},
                                   "move": [0, 0, 1]})"}))
          .string();
  const std::string sheet = in_.file("sheet.obj", objText(grid(6, 6))).string();
  const ProcessResult result = runBatch(deform(sheet, task));
  EXPECT_EQ(result.exitCode, kNumerical) << result.err;
  EXPECT_THAT(result.err, testing::ContainsRegex("error: \"[AB]\" is missed by [^ ]*, more than its limit"));
  EXPECT_THAT(result.err, HasSubstr("leave one of them out, or move them apart"));
  EXPECT_THAT(out_.names(), ElementsAre("report.json"));
  EXPECT_TRUE(isReport(report(), SolveState::Failed));
  expectStatuses({"independent", "independent", "independent"});
}

TEST_F(FailedNumerics, OfTheRotationFieldAreFoundByCheckToo)
{
  const std::string task = in_.file("turned.json", constraintText({R"({"type": "fixed", "select": {"vertices": [42]}})",
                                                                   R"({"type": "handle", "select": {"vertices": [48]},
                                   "rotate": {"axis": [0, 0, 1], "degrees": 30}})"}))
                               .string();
  const std::vector<std::string> check{"check", flatTriangle(), "--constraints",
                                       task,    "--report",     output("report.json")};
  std::vector<std::string> literal = check;
  literal.insert(literal.end(), {"--weights", "cotangent-paper"});
  const ProcessResult result = runBatch(literal);
  EXPECT_EQ(result.exitCode, kNumerical) << result.err;
  EXPECT_THAT(result.err, HasSubstr("error: the rotation field cannot be solved: the weight of the edge"));
  EXPECT_THAT(result.out, HasSubstr("solve        failed: the rotation field cannot be solved"));
  EXPECT_TRUE(isReport(report(), SolveState::Failed));
  EXPECT_EQ(report()["solve"]["weights"], "cotangent-paper");
  EXPECT_EQ(runBatch(check).exitCode, 0) << "guarded weights";
  EXPECT_TRUE(isReport(report(), SolveState::NotRun));
}

TEST_F(Outcome, RotationsThatDisagreeInARigidRegionAreToldOfWithTheirConstraints)
{
  const std::string task =
      in_.file("disagreeing.json",
               constraintText({R"({"type": "fixed", "name": "base", "select": {"vertices": [0, 8]}})",
                               R"({"type": "rigid", "name": "eye", "select": {"vertices": [8, 9, 10]}})",
                               R"({"type": "handle", "name": "turned", "select": {"vertices": [10]},
                                   "rotate": {"axis": [0, 0, 1], "degrees": 40}})"}))
          .string();
  const std::string sheet = in_.file("sheet.obj", objText(grid(6, 6))).string();
  const std::string told = "give rotations inside one rigid region that differ by up to 40 degrees";
  for (const auto& command : {deform(sheet, task), std::vector<std::string>{"check", sheet, "--constraints", task,
                                                                            "--report", output("report.json")}}) {
    const ProcessResult result = runBatch(command);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(told));
    EXPECT_THAT(result.out, HasSubstr("by the first: \"base\" and \"turned\"\n"));
    EXPECT_NEAR(report()["solve"]["rotation_disagreement_degrees"].get<double>(), 40, 1e-12);
    EXPECT_LE(report()["solve"]["rotation_accuracy"], 1e-9);
  }
}

TEST_F(Outcome, TheAccuracyStandsBesideOk)
{
  const ProcessResult result = runBatch(deform(mesh(), constraints()));
  EXPECT_THAT(result.out,
              testing::ContainsRegex("solve        ok: all constraints are met; accuracy [0-9.]*e-1[0-9]\n"));
  EXPECT_THAT(result.err, testing::Not(HasSubstr("warning"))) << "progress is told there where it takes long";
}

TEST_F(Outcome, ASolutionOfDoubtfulAccuracyIsWarnedOfEvenWhenQuiet)
{
  // The longer a strip that is held at one end, the fewer digits its far end has.
  int doubtful = 0;
  for (const Index length : {100, 12000, 14000, 18000}) {
    if (doubtful > 0) break;  // longer strips take Eigen minutes
    const std::string strip = in_.file("strip.obj", objText(grid(length, 1))).string();
    const std::string end = std::to_string(length);
    const std::string start = R"({"type": "fixed", "select": {"vertices": [0, )" + std::to_string(length + 1) + "]}}";
    const std::string task =
        in_.file("ends.json", constraintText({start, R"({"type": "point", "at": {"vertex": )" + end +
                                                         R"(}, "move": [0, 0, )" + end + "]}"}))
            .string();
    const ProcessResult result = runBatch(deform(strip, task, {"--quiet"}));
    if (result.exitCode == kNumerical) continue;
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const bool isDoubtful = report()["solve"]["accuracy"] > 1e-9;
    doubtful += isDoubtful ? 1 : 0;
    EXPECT_EQ(result.err.starts_with("warning: the solution is accurate to "), isDoubtful) << result.err;
  }
  EXPECT_GT(doubtful, 0) << "the test has met no doubtful solution";
}

TEST_F(Outcome, EachConstraintIsReportedWithItsOwnLimit)
{
  const std::string task =
      in_.file("far.json", constraintText({R"({"type": "fixed", "select": {"vertices": [0, 1, 2]}})",
                                           R"({"type": "point", "at": {"vertex": 9}, "target": [0, 0, 1e9]})"}))
          .string();
  EXPECT_EQ(runBatch(deform(mesh(), task)).exitCode, 0);
  const Json report = this->report();
  const double diagonal = report["mesh"]["bbox_diagonal"];
  EXPECT_DOUBLE_EQ(report["constraints"][0]["limit"], 1e-12 * diagonal);
  EXPECT_DOUBLE_EQ(report["constraints"][1]["limit"], 8 * std::numeric_limits<double>::epsilon() * 1e9);
}

TEST_F(Outcome, CheckTellsOfMeshAndConstraintsAndSolvesNothing)
{
  const ProcessResult result =
      runBatch({"check", mesh(), "--constraints", constraints(), "--report", output("report.json")});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("162 vertices, 320 faces"));
  EXPECT_THAT(result.out, Not(HasSubstr("solve ")));
  EXPECT_TRUE(isReport(report(), SolveState::NotRun));
  EXPECT_EQ(report()["constraints"].size(), 3U);
}

TEST_F(Outcome, CheckOfAMeshAloneReportsNoConstraints)
{
  EXPECT_EQ(runBatch({"check", mesh(), "--report", output("report.json")}).exitCode, 0);
  EXPECT_TRUE(isReport(report(), SolveState::NotRun));
  EXPECT_EQ(report()["constraints"], Json::array());
}

TEST_F(Outcome, NoConstraintsLeaveTheMeshByteForByte)
{
  const std::string none = in_.file("none.json", constraintText({})).string();
  EXPECT_EQ(runBatch(deform(mesh(), none)).exitCode, 0);
  EXPECT_EQ(bytesOf(output("out.obj")), bytesOf(mesh()));
}

TEST_F(Outcome, TheSameRunWritesTheSameBytes)
{
  EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0);
  const std::string first = bytesOf(output("out.obj"));
  EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0);
  EXPECT_EQ(bytesOf(output("out.obj")), first);
}

}  // namespace
}  // namespace holdfast::test
