// Acceptance on meshes that are no part of the project: large, scanned, tessellated, broken. The folder is set by
// HOLDFAST_MESH_LIBRARY when the project is configured; without it these tests are skipped.

#include <algorithm>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/generated_task.h"
#include "support/plain_mesh.h"

namespace holdfast::test {
namespace {

namespace fs = std::filesystem;

const fs::path kLibrary = HOLDFAST_MESH_LIBRARY;

/// Files of a folder of the library, as paths relative to it; one empty path where there are none.
std::vector<std::string> meshesIn(const std::string& folder)
{
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(kLibrary / folder, missing))
    names.push_back(folder + "/" + entry.path().filename().string());
  std::sort(names.begin(), names.end());
  if (names.empty()) names.emplace_back();
  return names;
}

std::string libraryMeshName(const testing::TestParamInfo<std::string>& info)
{
  std::string name = info.param.empty() ? "absent" : fs::path(info.param).stem().string();
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }),
             name.end());
  return name;
}

class LibraryMesh : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override
  {
    if (GetParam().empty())
      GTEST_SKIP() << "no meshes in " << kLibrary << ": set HOLDFAST_MESH_LIBRARY to a folder with real/ and dirty/";
    mesh_ = kLibrary / GetParam();
#ifndef HOLDFAST_WITH_CHOLMOD
    constexpr std::size_t kMostVertices = 50'000;
    if (readPlainMesh(mesh_).positions.size() > kMostVertices)
      GTEST_SKIP() << mesh_ << " is too large for a build without CHOLMOD";
#endif
  }

  fs::path mesh_;
};

class RealMesh : public LibraryMesh {};

TEST_P(RealMesh, IsSolvedExactlyAndAtLeastEnergy)
{
  const GeneratedTask task(mesh_);
  task.expectSolved(Weights::Cotangent);
  task.expectSolved(Weights::Uniform);
  if (!HasFatalFailure()) task.expectBothLeast(Weights::Cotangent, Weights::Uniform);
}

TEST_P(RealMesh, IsSolvedOrRefusedWithTheFormulaAsPrinted)
{
  GeneratedTask(mesh_).expectSolvedOrRefused(Weights::CotangentPaper);
}

INSTANTIATE_TEST_SUITE_P(MeshLibrary, RealMesh, testing::ValuesIn(meshesIn("real")), libraryMeshName);

/// What the name of a file says is wrong with it, as the kind of a finding; empty where nothing need be found.
std::string promisedFinding(const std::string& stem)
{
  const std::map<std::string, std::string> kinds{{"bar_slivers", "capped_cotangents"},
                                                 {"flipped_face", "flipped_neighbours"},
                                                 {"isolated_vertices", "unreferenced_vertices"},
                                                 {"moebius", "flipped_neighbours"},
                                                 {"nonmanifold_edge", "non_manifold_edges"},
                                                 {"nonmanifold_vertex", "non_manifold_vertices"},
                                                 {"plane_caps", "capped_cotangents"},
                                                 {"triangle_soup", "welded_vertices"},
                                                 {"two_components", "components"},
                                                 {"zero_area", "zero_area_faces"}};
  const auto found = kinds.find(stem);
  return found == kinds.end() ? "" : found->second;
}

class DirtyMesh : public LibraryMesh {};

TEST_P(DirtyMesh, IsSolvedAndSaysWhatIsWrong)
{
  const GeneratedTask task(mesh_);
  task.expectSolved(Weights::Cotangent);
  if (HasFatalFailure()) return;
  const nlohmann::json report = task.report(Weights::Cotangent);
  std::vector<std::string> kinds;
  for (const nlohmann::json& finding : report["mesh"]["findings"]) kinds.push_back(finding["kind"]);
  const std::string promised = promisedFinding(mesh_.stem().string());
  if (!promised.empty()) {
    EXPECT_THAT(kinds, testing::Contains(promised));
  }
}

TEST_P(DirtyMesh, IsSolvedOrRefusedWithTheFormulaAsPrinted)
{
  GeneratedTask(mesh_).expectSolvedOrRefused(Weights::CotangentPaper);
}

INSTANTIATE_TEST_SUITE_P(MeshLibrary, DirtyMesh, testing::ValuesIn(meshesIn("dirty")), libraryMeshName);

}  // namespace
}  // namespace holdfast::test
