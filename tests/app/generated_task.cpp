#include "app/generated_task.h"

#include <cmath>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/batch.h"
#include "app/energy_check.h"
#include "app/generated_constraints.h"
#include "app/report_schema.h"
#include "support/residual_verifier.h"

namespace holdfast::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint32_t kSeed = 2006;

std::string generated(const fs::path& mesh)
{
  Random random(kSeed);
  return generatedConstraints(readPlainMesh(mesh), random);
}

/// One line for people who compare meshes.
void print(const std::string& meshName, const ProcessResult& result, const Json& solve)
{
  std::cout << meshName << ": " << solve["weights"].get<std::string>() << ", exit " << result.exitCode << ", residual "
            << solve["max_residual_relative"] << ", accuracy " << solve["accuracy"] << ", steps "
            << solve["refinement_steps"] << ", " << solve["method"] << ", non-zeros " << solve["factor_nonzeros"]
            << ", " << solve["seconds"].dump() << "\n";
}

}  // namespace

GeneratedTask::GeneratedTask(const fs::path& mesh)
    : mesh_(mesh), constraints_(folder_.file("constraints.json", generated(mesh)))
{
}

fs::path GeneratedTask::out(Weights weights) const
{
  return folder_.path() / (std::string(name(weights)) + mesh_.extension().string());
}

fs::path GeneratedTask::reportPath(Weights weights) const
{
  return folder_.path() / (std::string(name(weights)) + ".json");
}

ProcessResult GeneratedTask::deform(Weights weights) const
{
  ProcessOptions options;
  options.timeout = std::chrono::minutes(20);
  return runBatch({"deform", mesh_.string(), "--constraints", constraints_.string(), "--out", out(weights).string(),
                   "--report", reportPath(weights).string(), "--weights", std::string(name(weights))},
                  options);
}

Json GeneratedTask::report(Weights weights) const
{
  return Json::parse(bytesOf(reportPath(weights)));
}

void GeneratedTask::expectMet(Weights weights, const ProcessResult& result) const
{
  ASSERT_EQ(result.exitCode, 0) << "signal " << result.signal << ", time-out " << result.isTimedOut << "\n"
                                << result.err;
  const Json report = this->report(weights);
  print(mesh_.filename().string(), result, report["solve"]);
  EXPECT_TRUE(isReport(report, SolveState::Solved));
  EXPECT_EQ(report["solve"]["status"], "ok");
  EXPECT_LE(report["solve"]["max_residual_relative"], kPromisedResidual);
  EXPECT_TRUE(meetsConstraints(mesh_, out(weights), constraints_));
}

void GeneratedTask::expectSolved(Weights weights) const
{
  SCOPED_TRACE(name(weights));
  expectMet(weights, deform(weights));
  if (testing::Test::HasFatalFailure()) return;
  const EnergyCheck check(mesh_, constraints_, weights);
  const FreeGradient gradient = check.freeGradient(readPlainMesh(out(weights)));
  EXPECT_LE(gradient.largest, gradient.bound);
}

void GeneratedTask::expectBothLeast(Weights a, Weights b) const
{
  const PlainMesh byA = readPlainMesh(out(a));
  const PlainMesh byB = readPlainMesh(out(b));
  const double atA = EnergyCheck(mesh_, constraints_, a).cosineTowards(byA, byB);
  const double atB = EnergyCheck(mesh_, constraints_, b).cosineTowards(byB, byA);
  std::cout << mesh_.filename().string() << ": cosines " << atA << ", " << atB << "\n";
  EXPECT_LE(std::abs(atA), kRightAngle) << name(a);
  EXPECT_LE(std::abs(atB), kRightAngle) << name(b);
}

void GeneratedTask::expectSolvedOrRefused(Weights weights) const
{
  SCOPED_TRACE(name(weights));
  const ProcessResult result = deform(weights);
  if (result.exitCode == 0) return expectMet(weights, result);
  ASSERT_EQ(result.exitCode, 5) << "signal " << result.signal << ", time-out " << result.isTimedOut << "\n"
                                << result.err;
  const Json report = this->report(weights);
  print(mesh_.filename().string(), result, report["solve"]);
  std::cout << "  " << report["solve"]["message"].get<std::string>() << "\n";
  EXPECT_TRUE(isReport(report, SolveState::Failed));
  EXPECT_THAT(report["solve"]["message"].get<std::string>(), testing::HasSubstr("\"cotangent\""));
  EXPECT_FALSE(fs::exists(out(weights)));
}

}  // namespace holdfast::test
