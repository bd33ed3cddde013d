// Generated constraints on the meshes of data/, and damage that their judges must not pass.

#include "app/generated_task.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/batch.h"
#include "app/energy_check.h"
#include "support/residual_verifier.h"
#include "support/source_tree.h"

namespace holdfast::test {
namespace {

class GeneratedTaskOnData : public testing::TestWithParam<const char*> {};

TEST_P(GeneratedTaskOnData, IsSolvedExactlyAndAtLeastEnergy)
{
  const GeneratedTask task(dataFolder() + "/" + GetParam());
  task.expectSolved(Weights::Cotangent);
  task.expectSolved(Weights::Uniform);
  task.expectSolved(Weights::CotangentPaper);
  task.expectBothLeast(Weights::Cotangent, Weights::Uniform);
  task.expectBothLeast(Weights::CotangentPaper, Weights::Uniform);
}

std::string meshName(const testing::TestParamInfo<const char*>& info)
{
  return {info.param, std::strcspn(info.param, "._")};
}

INSTANTIATE_TEST_SUITE_P(Deform, GeneratedTaskOnData,
                         testing::Values("bar.obj", "bracket.obj", "head.ply", "plate_unsymmetric.off", "quads.obj"),
                         meshName);

class EnergyJudgeOnHead : public testing::Test {
 protected:
  EnergyJudgeOnHead() : check_(task_.mesh(), task_.constraints(), Weights::Cotangent)
  {
    EXPECT_EQ(task_.deform(Weights::Cotangent).exitCode, 0);
    best_ = readPlainMesh(task_.out(Weights::Cotangent));
  }

  GeneratedTask task_{dataFolder() + "/head.ply"};
  EnergyCheck check_;
  PlainMesh best_;
};

TEST_F(EnergyJudgeOnHead, SeesAFreeVertexOutOfPlaceByTheTwelfthDigit)
{
  const FreeGradient atBest = check_.freeGradient(best_);
  EXPECT_LE(atBest.largest, atBest.bound);
  const double step = 1e-11 * diagonalOf(best_);
  // Every tenth vertex: most of them are free.
  for (std::size_t v = 0; v < best_.positions.size(); v += 10) best_.positions[v][0] += step;
  const FreeGradient damaged = check_.freeGradient(best_);
  EXPECT_GT(damaged.largest, damaged.bound);
}

TEST_F(EnergyJudgeOnHead, SeesThatAnotherMinimumIsNotThisOne)
{
  EXPECT_EQ(task_.deform(Weights::Uniform).exitCode, 0);
  const PlainMesh other = readPlainMesh(task_.out(Weights::Uniform));
  EXPECT_TRUE(meetsConstraints(task_.mesh(), task_.out(Weights::Uniform), task_.constraints()));
  const FreeGradient gradient = check_.freeGradient(other);
  EXPECT_GT(gradient.largest, gradient.bound);
  EXPECT_LT(check_.cosineTowards(other, best_), -1e-3);
}

/// The bar with one handle, that moves in every way that turns the surface: places of the handle alone do not say the
/// least energy, and the last two of these have the same.
TEST(EnergyJudge, TellsTheMotionsOfHandlesApart)
{
  const TemporaryFolder folder;
  const std::string mesh = dataFolder() + "/bar.obj";
  std::vector<std::string> files;
  std::vector<PlainMesh> solutions;
  for (const char* const motion :
       {R"("turn": "about-fixed", "translate": [20, 0, -10])", R"("frame": {"to": {"x": [0, 1, 0], "y": [-1, 0, 0]}})",
        R"("frame": {"to": {"x": [0, 1, 0], "y": [-1, 0, 0]}, "turns": 1})"}) {
    files.push_back(
        folder
            .file(
                std::to_string(files.size()) + ".json",
                constraintText(
                    {R"({"type": "fixed", "name": "foot", "select": {"halfspace": {"point": [0, 0, 5], "normal": [0, 0, -1]}}})",
                     R"({"type": "handle", "name": "top", "select": {"halfspace": {"point": [0, 0, 95], "normal": [0, 0, 1]}}, )" +
                         std::string(motion) + "}"}))
            .string());
    const std::string out = (folder.path() / "out.obj").string();
    ASSERT_EQ(runBatch({"deform", mesh, "--constraints", files.back(), "--out", out}).exitCode, 0);
    EXPECT_TRUE(meetsConstraints(mesh, out, files.back()));
    solutions.push_back(readPlainMesh(out));
  }
  for (std::size_t f = 0; f < files.size(); ++f)
    for (std::size_t s = 0; s < solutions.size(); ++s) {
      const FreeGradient gradient = EnergyCheck(mesh, files[f], Weights::Cotangent).freeGradient(solutions[s]);
      EXPECT_EQ(gradient.largest <= gradient.bound, f == s) << f << ", " << s << ": " << gradient.largest;
    }
}

TEST_F(EnergyJudgeOnHead, SeesSmoothErrors)
{
  EXPECT_EQ(task_.deform(Weights::Uniform).exitCode, 0);
  const PlainMesh other = readPlainMesh(task_.out(Weights::Uniform));
  PlainMesh mixed = best_;
  for (std::size_t v = 0; v < mixed.positions.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) mixed.positions[v][k] += 1e-9 * (other.positions[v][k] - best_.positions[v][k]);
  EXPECT_LE(std::abs(check_.cosineTowards(best_, other)), kRightAngle);
  EXPECT_GT(std::abs(check_.cosineTowards(mixed, other)), kRightAngle);
}

}  // namespace
}  // namespace holdfast::test
