// What docs/paper.md says of Table 1 and of what lies beyond the paper, as orderings and bounds.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/operators/laplacian.h>
#include <holdfast/operators/operators.h>

#include "bench/paper/causes.h"
#include "bench/paper/intrinsic_delaunay.h"
#include "bench/paper/limited.h"
#include "bench/paper/rotation_methods.h"
#include "paper/paper_test.h"

namespace holdfast::paper {
namespace {

/// What is promised of hard constraints, as a share of the diagonal.
constexpr double kHardResidual = 1e-12;

using PaperTable = PaperTest;

TEST_F(PaperTable, OneIsSolvedByTheProductAndNotAsPrinted)
{
  const auto numbers = sectionOf(stabilityOfOwnMeshes).numbers;
  EXPECT_EQ(numbers.at("systems"), 4 * 3 * 12);
  EXPECT_EQ(numbers.at("lost by product"), 0);
  EXPECT_GT(numbers.at("lost in double"), 0);
  EXPECT_GT(numbers.at("lost in single"), 0.5 * numbers.at("systems"));
  EXPECT_LT(numbers.at("hard error, product"), 1e-15);
  EXPECT_GT(numbers.at("hard error, double"), 1e4 * numbers.at("hard error, product"));
  EXPECT_GT(numbers.at("hard error, single"), 1e4 * numbers.at("hard error, double"));
  EXPECT_LT(numbers.at("hard residual, product"), kHardResidual);
  EXPECT_LT(numbers.at("reference error"), 1e-24) << "what errors are measured by";
}

TEST_F(PaperTable, OneLosesDigitsWithTheSquareOfTheWeight)
{
  const BentMesh bent = bentByEnds(soundPlate());
  const BentProblem problem = bentProblem(bent, Weights::Uniform);
  const auto conditionAt = [&](double weight) {
    const auto reduced = reducedProblem(bent, problem, {SolverKind::Soft, weight});
    return conditionOf(reduced.value);
  };
  EXPECT_NEAR(conditionAt(1e4) / conditionAt(1e3), 100, 10);
}

/// Errors and conditions of plates of `cause`, 1e-6.
class PaperCause : public PaperTest {
 protected:
  static CauseOutcome outcome(Cause cause, const std::string& recipe)
  {
    for (const Recipe& candidate : allRecipes())
      if (candidate.name == recipe) return outcomeOf(bentByEnds(badPlate(cause, 1e-6)), candidate);
    throw std::out_of_range(recipe);
  }
};

TEST_F(PaperCause, SmallAnglesAreCuredByTheGuardAndNotByFlips)
{
  EXPECT_GT(outcome(Cause::SmallAngle, "as printed").printed.error, kLostError);
  EXPECT_GT(outcome(Cause::SmallAngle, "intrinsic Delaunay").printed.error, kLostError);
  EXPECT_LT(outcome(Cause::SmallAngle, "guarded cotangents").printed.error, 1e-8);
}

TEST_F(PaperCause, FlatAnglesAreCuredByTheGuardAndByFlips)
{
  const double printed = outcome(Cause::FlatAngle, "as printed").condition;
  EXPECT_LT(outcome(Cause::FlatAngle, "guarded cotangents").condition, 1e-3 * printed);
  EXPECT_LT(outcome(Cause::FlatAngle, "intrinsic Delaunay").condition, 1e-3 * printed);
}

TEST_F(PaperCause, AreasOfDifferentSizesAreCuredByRowsWeightedByThem)
{
  for (const Cause cause : {Cause::SmallAreas, Cause::LargeAreas}) {
    const double printed = outcome(cause, "as printed").condition;
    EXPECT_LT(outcome(cause, "rows by area").condition, 1e-3 * printed) << name(cause);
    EXPECT_GT(outcome(cause, "guarded cotangents").condition, 0.9 * printed) << name(cause);
  }
}

TEST_F(PaperCause, AreasThatCancelAreCuredByMixedOnes)
{
  EXPECT_GT(outcome(Cause::CancellingArea, "as printed").printed.error, kLostError);
  EXPECT_LT(outcome(Cause::CancellingArea, "mixed areas").printed.error, 1e-8);
}

TEST_F(PaperCause, DefaultSolvesThemAll)
{
  for (const Cause cause : allCauses()) {
    const CauseOutcome made = outcome(cause, "default");
    EXPECT_LT(made.condition, 1e10) << name(cause);
    EXPECT_LT(made.corrected.error, 1e-13) << name(cause);
    EXPECT_LT(made.augmented.error, 1e-11) << name(cause);
  }
}

/// `makeOperators` and the study build the same rows, each in its own way.
TEST_F(PaperCause, DefaultAndPrintedAreThoseOfTheProduct)
{
  const BentMesh bent = bentByEnds(badPlate(Cause::FlatAngle, 1e-2));
  const auto difference = [&](const char* recipe, Weights weights) {
    const SparseMatrix rows = weightedRows(makeOperators(bent.model.solverMesh, weights)).matrix();
    for (const Recipe& candidate : allRecipes())
      if (candidate.name == std::string(recipe))
        return (laplacianRows(bent.model.solverMesh, candidate) - rows).norm() / rows.norm();
    return 1.0;
  };
  EXPECT_LT(difference("default", Weights::Cotangent), 1e-9);
  EXPECT_LT(difference("as printed", Weights::CotangentPaper), 1e-9);
}

TEST(IntrinsicDelaunay, KeepsAreaAndLeavesNoNegativeSum)
{
  const Mesh plate = badPlate(Cause::FlatAngle, 1e-2);
  std::vector<Triangle> triangles;
  for (Index f = 0; f < plate.faces.size(); ++f)
    triangles.push_back({plate.faces[f][0], plate.faces[f][1], plate.faces[f][2]});
  const auto areaOf = [](const IntrinsicTriangles& mesh) {
    double sum = 0;
    for (const auto& lengths : mesh.lengths) sum += area(lengths);
    return sum;
  };
  const auto leastWeight = [](const IntrinsicTriangles& mesh) {
    std::vector<CornerCotangents> all;
    for (const auto& lengths : mesh.lengths) all.push_back(cotangents(lengths));
    double least = 0;
    for (const EdgeWeight& edge : cotangentEdgeWeights(mesh.triangles, all)) least = std::min(least, edge.weight);
    return least;
  };
  const IntrinsicTriangles before = intrinsicTriangles(plate.positions, triangles);
  const IntrinsicTriangles after = delaunay(before);
  EXPECT_NEAR(areaOf(after), areaOf(before), 1e-12 * areaOf(before));
  EXPECT_LT(leastWeight(before), -1);
  // The border has one cotangent an edge, of right or acute angles in this plate.
  EXPECT_GT(leastWeight(after), -1e-9);
}

TEST(BadPlates, HaveTheirCauseAndNoOther)
{
  const auto largestCotangent = [](Cause cause) {
    const BentMesh bent = bentByEnds(badPlate(cause, 1e-4));
    double largest = 0;
    for (const CornerCotangents& corner : cornerCotangents(bent.model.solverMesh.rest, bent.model.solverMesh.triangles))
      for (const double value : corner) largest = std::max(largest, std::abs(value));
    return largest;
  };
  EXPECT_GT(largestCotangent(Cause::SmallAngle), 1e3);
  EXPECT_GT(largestCotangent(Cause::FlatAngle), 1e3);
  for (const Cause cause : {Cause::SmallAreas, Cause::LargeAreas, Cause::CancellingArea})
    EXPECT_LT(largestCotangent(cause), 5) << name(cause);
}

TEST_F(PaperTest, TasksOfTheSurveyKeepEdgesBestWhereRotationsAreFound)
{
  const auto numbers = tasksBy(ownMethods()).numbers;
  for (const SurveyTask& task : {bentBar(), bentCactus(), twistedCylinder(), liftedPlane()}) {
    const auto at = [&](const std::string& what) { return numbers.at(task.name + ": " + what); };
    EXPECT_LT(at("found edges"), 0.7 * at("given edges")) << task.name;
    EXPECT_LT(at("found-smooth edges"), at("given edges")) << task.name;
    EXPECT_LE(at("found-smooth jump"), at("found jump")) << task.name;
    for (const RotationMethod& method : ownMethods())
      EXPECT_LT(at(method.name + " residual"), kHardResidual) << task.name << ", " << method.name;
  }
}

/// Outcomes of `task` by the methods in their order.
std::vector<RotationOutcome> outcomesBy(const std::vector<RotationMethod>& methods, const SurveyTask& task)
{
  std::vector<RotationOutcome> outcomes;
  for (const RotationMethod& method : methods) outcomes.push_back(method.run({task}, kFoundChange).front());
  return outcomes;
}

TEST(RotationMethods, KeepEdgesBetterTheMoreTheyFind)
{
  for (const double degrees : {90.0, 180.0})
    for (const SurveyTask& task : {bentBar(degrees), twistedBar(degrees)}) {
      const std::vector<RotationOutcome> outcomes = outcomesBy(ownMethods(), task);
      for (const RotationOutcome& outcome : outcomes) EXPECT_LT(outcome.residual, kHardResidual) << task.name;
      EXPECT_GT(outcomes[0].edges, outcomes[1].edges) << task.name << ": none, given";
      EXPECT_GT(outcomes[1].edges, outcomes[3].edges) << task.name << ": given, found smooth";
      EXPECT_GT(outcomes[3].edges, outcomes[2].edges) << task.name << ": found smooth, found";
    }
}

TEST(RotationMethods, OfCgalKeepEdgesAsFoundOnesDoWhereNothingFolds)
{
  std::vector<RotationMethod> cgal;
  try {
    cgal = cgalMethods();
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  const SurveyTask task = twistedBar(30);
  const double found = outcomesBy(ownMethods(), task)[2].edges;
  const std::vector<RotationOutcome> outcomes = outcomesBy(cgal, task);
  EXPECT_NEAR(outcomes[0].edges, found, 0.02 * found) << "the same energy";
  for (const RotationOutcome& outcome : outcomes) {
    EXPECT_TRUE(outcome.isConverged);
    EXPECT_LT(outcome.residual, 1e-15) << "control vertices are copied";
  }
}

/// A rigid motion changes none of them; a scaling by 2 doubles edges and has eight times the volume.
TEST(TaskMeasures, AreOfShapeAlone)
{
  const SurveyTask task = bentBar();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Positions moved = (task.rest * R.transpose()).rowwise() + Eigen::RowVector3d(5, 6, 7);
  EXPECT_LT(edgeError(task, moved), 1e-13);
  EXPECT_LT(std::abs(volumeError(task, moved)), 1e-12);
  EXPECT_LT(dihedralError(task, moved).largest, 1e-6);
  EXPECT_NEAR(edgeError(task, 2 * task.rest), 1, 1e-13);
  EXPECT_NEAR(volumeError(task, 2 * task.rest), 7, 1e-12);
  EXPECT_GT(residual(task, task.rest), 0.1);
  EXPECT_EQ(residual(task, task.targets()), 0);
}

/// Of four bytes.
std::string failureWithin(const Limits& limits, const std::function<Ending(std::span<std::byte>)>& compute)
{
  std::array<std::byte, 4> result{};
  return limited(limits, result, compute);
}

TEST(Limited, HandsOverItsResult)
{
  std::array<std::byte, 3> result{};
  const std::string failure = limited({60, 64}, result, [](std::span<std::byte> bytes) {
    std::ranges::fill(bytes, std::byte{7});
    return Ending::Done;
  });
  EXPECT_EQ(failure, "");
  EXPECT_THAT(result, testing::Each(std::byte{7}));
}

TEST(Limited, TellsWhatEndedIt)
{
  EXPECT_EQ(failureWithin({60, 64}, [](auto) { return Ending::Failed; }), "fails");
  EXPECT_EQ(failureWithin({60, 64}, [](auto) -> Ending { throw std::runtime_error("bad"); }), "fails");
  EXPECT_EQ(failureWithin({60, 64}, [](auto) -> Ending { std::abort(); }), "fails");
  EXPECT_EQ(failureWithin({1, 64},
                          [](auto) {
                            for (std::atomic<bool> isRunning = true; isRunning;) {
                            }
                            return Ending::Done;
                          }),
            "stopped after 1 s");
}

TEST(Limited, EndsWhereMemoryDoes)
{
  const auto takeTooMuch = [](auto) {
    ::operator delete(::operator new(8'000'000'000));
    return Ending::Done;
  };
  EXPECT_EQ(failureWithin({60, 8}, takeTooMuch), "out of memory at 8 GB");
}

}  // namespace
}  // namespace holdfast::paper
