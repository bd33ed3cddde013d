// Every constraint file and point list in data/ on its mesh: solved, met, and met in the file that is read again.

#include <algorithm>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/batch.h"
#include "app/report_schema.h"
#include "support/residual_verifier.h"
#include "support/source_tree.h"

namespace holdfast::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<std::string> constraintFiles()
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(dataFolder())) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".constraints.json") || name.ends_with(".measured.csv")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The mesh that a constraint file belongs to: the same name up to the first dot.
fs::path meshOf(const std::string& file)
{
  for (const char* extension : {".obj", ".off", ".ply", ".stl"})
    if (fs::path mesh = fs::path(dataFolder()) / (file.substr(0, file.find('.')) + extension); fs::exists(mesh))
      return mesh;
  return {};
}

std::string exampleName(const testing::TestParamInfo<std::string>& info)
{
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '_'; }, 'X');
  return name;
}

class ExampleData : public testing::TestWithParam<std::string> {
 protected:
  TemporaryFolder out_;
};

/// Names of the constraints that are left out; the example says so in the name of each.
std::set<std::string> conflicting(const Json& report)
{
  std::set<std::string> names;
  for (const Json& constraint : report["constraints"]) {
    const std::string name = constraint["name"];
    const bool isMeantTo = name.find("(conflicting)") != std::string::npos;
    EXPECT_EQ(constraint["status"] == "conflicting", isMeantTo) << constraint;
    EXPECT_EQ(constraint["status"] == "redundant", name.find("(redundant)") != std::string::npos) << constraint;
    if (isMeantTo) names.insert(name);
  }
  return names;
}

TEST_P(ExampleData, IsMet)
{
  const fs::path mesh = meshOf(GetParam());
  // Binary STL cannot hold what is promised.
  const fs::path out = out_.path() / ("out" + (mesh.extension() == ".stl" ? ".obj" : mesh.extension().string()));
  const fs::path reportFile = out_.path() / "report.json";
  const fs::path constraints = fs::path(dataFolder()) / GetParam();
  const ProcessResult result = runBatch({"deform", mesh.string(), "--constraints", constraints.string(), "--out",
                                         out.string(), "--report", reportFile.string()});
  const bool hasConflicts = GetParam().find(".conflict.") != std::string::npos;
  ASSERT_EQ(result.exitCode, hasConflicts ? 4 : 0) << result.err;

  const Json report = Json::parse(bytesOf(reportFile));
  EXPECT_TRUE(isReport(report, SolveState::Solved));
  EXPECT_EQ(report["result"]["status"], "fine") << report["result"];
  const std::set<std::string> leftOut = conflicting(report);
  EXPECT_EQ(leftOut.empty(), !hasConflicts);
  EXPECT_TRUE(meetsConstraints(mesh, out, constraints, leftOut));
}

INSTANTIATE_TEST_SUITE_P(Deform, ExampleData, testing::ValuesIn(constraintFiles()), exampleName);

}  // namespace
}  // namespace holdfast::test
