// More points with tolerances than are solved together: along each coordinate by itself.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

constexpr double kLargestOff = 0.05;

/// A grid that is held along one side; all other places of a checkerboard are measured, with noise.
struct ManyMeasured {
  static constexpr Index kColumns = 80;
  Mesh mesh = test::grid(kColumns, 56);
  std::vector<Constraint> list;
  std::vector<Vector3> targets;  // of the points, in their order

  explicit ManyMeasured(const PointTolerance& within)
  {
    std::vector<Index> side;
    for (Index v = 0; v <= kColumns; ++v) side.push_back(v);
    list.push_back(test::hold(side));
    test::Random random(19);
    for (Index v = kColumns + 1; v < mesh.vertexCount(); v += 2) {
      const Vector3 at = mesh.positions.row(v);
      targets.push_back(at + Vector3(0.1 * at.y(), 0, 0.004 * at.y() * at.y()) +
                        test::randomVector(random, kLargestOff));
      list.push_back({"", true, PointConstraint{AtVertex{v}, Target{targets.back()}, within}});
    }
  }

  [[nodiscard]] DeformResult result(const DeformOptions& options = {}) const
  {
    return test::deformed(mesh, test::listOf(list), options);
  }
};

TEST(ManyTolerances, OfBoxesHaveForcesAcrossTheirBoundsAlone)
{
  const Vector3 half(0.02, 0.05, 0.03);
  const ManyMeasured measured(WithinBox{half});
  ASSERT_GT(measured.targets.size(), kMostTolerantPoints);
  const DeformResult result = measured.result();
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  const auto& rows = result.details->system.tolerant;
  const Columns3& forces = result.details->multipliers.get().ofRows;
  const double largest = forces.cwiseAbs().maxCoeff();
  int atBound = 0;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (Index axis = 0; axis < 3; ++axis) {
      const double offset = result.details->system.rows[rows[k].row].target[axis] - rows[k].target[axis];
      const double force = forces(rows[k].row, axis);
      EXPECT_LE(std::abs(offset), half[axis] + 4e-14);
      if (std::abs(force) < 1e-7 * largest) continue;
      ++atBound;
      EXPECT_NEAR(std::abs(offset), half[axis], 1e-9);
      EXPECT_LT(offset * force, 0) << "a bound pushes inwards";
    }
  EXPECT_GT(atBound, 1000);
}

/// Points in faces have huge weights on three vertices each, where they are at their bounds.
TEST(ManyTolerances, OfPointsInFacesHaveForcesAcrossTheirBoundsAlone)
{
  constexpr double kHalf = 0.01;
  const Mesh mesh = test::grid(80, 56);
  std::vector<Index> side;
  for (Index v = 0; v <= 80; ++v) side.push_back(v);
  std::vector<Constraint> list{test::hold(side)};
  test::Random random(23);
  for (Index face = 200; face < mesh.faces.size(); face += 4)
    list.push_back({"", true,
                    PointConstraint{AtFace{face, {0.25, 0.25, 0.5}}, Move{test::randomVector(random, 0.1)},
                                    WithinBox{Vector3::Constant(kHalf)}}});
  ASSERT_GT(list.size(), kMostTolerantPoints);
  const DeformResult result = test::deformed(mesh, test::listOf(list), {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  const Columns3& forces = result.details->multipliers.get().ofRows;
  const double largest = forces.cwiseAbs().maxCoeff();
  for (const TolerantRow& row : result.details->system.tolerant)
    for (Index axis = 0; axis < 3; ++axis) {
      const double offset = result.details->system.rows[row.row].target[axis] - row.target[axis];
      const double force = forces(row.row, axis);
      EXPECT_LE(std::abs(offset), kHalf + 4e-14);
      EXPECT_LE((1 - std::abs(offset) / kHalf) * std::abs(force) / largest, 1e-8) << "either room or force";
      if (std::abs(force) < 1e-6 * largest) continue;
      EXPECT_LT(offset * force, 0) << "a bound pushes inwards";
    }
}

/// All points soft: the soft solver is an oracle.
TEST(ManyTolerances, OfWeightsAreThoseOfSoftConstraints)
{
  constexpr double kWeight = 20;
  ManyMeasured measured(Weighted{kWeight});
  measured.list.erase(measured.list.begin());
  const DeformResult result = measured.result();
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (Constraint& constraint : measured.list) std::get<PointConstraint>(constraint.what).within = Exactly{};
  const DeformResult soft = measured.result({Weights::Cotangent, {SolverKind::Soft, Backend::Holdfast, kWeight}});
  EXPECT_LT(test::distance(result.positions, soft.positions), 1e-7);
}

/// With room everywhere nothing pushes.
TEST(ManyTolerances, WithMuchRoomLeaveTheSurfaceAtRest)
{
  const DeformResult result = ManyMeasured(WithinBox{{20, 20, 20}}).result();
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT(test::distance(result.positions, test::grid(ManyMeasured::kColumns, 56).positions), 1e-6);
}

TEST(ManyTolerances, OfOneSideOnlyPushOneWay)
{
  ManyMeasured measured(WithinSlab{-kLargestOff, std::numeric_limits<double>::infinity(), Vector3(0, 0, -2)});
  const DeformResult result = measured.result();
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (std::size_t k = 0; k < measured.targets.size(); ++k)
    EXPECT_LE(result.positions(ManyMeasured::kColumns + 1 + 2 * static_cast<Index>(k), 2),
              measured.targets[k].z() + kLargestOff + 4e-14);
}

TEST(ManyTolerances, OfASlideLeaveTheSurfaceWhereItIsAlongThePlane)
{
  const Mesh mesh = test::grid(60, 40);
  SlideConstraint slide{{AllOf{}}, OnPlane{Vector3(0, 0, 0.5), Vector3::UnitZ()}, false, WithinBall{0.125}};
  const DeformResult result = test::deformed(mesh, test::listOf({{"near", true, std::move(slide)}}), {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(result.positions.row(v).head<2>(), mesh.positions.row(v).head<2>());
    EXPECT_NEAR(result.positions(v, 2), 0.5, 0.125 + 1e-15);
  }
}

TEST(ManyTolerances, FollowExactPointsInOneEdit)
{
  const ManyMeasured boxes(WithinBox{{0.02, 0.05, 0.03}});
  Deformer deformer(makeModel(boxes.mesh), {}, DeformerMode::Interactive);
  static_cast<void>(deformer.deform(test::listOf(ManyMeasured(Exactly{}).list)));
  const DeformResult result = deformer.deform(test::listOf(boxes.list));
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT(test::distance(result.positions, boxes.result().positions), 1e-9);
}

TEST(ManyTolerances, AreRefusedWhereABallIsAmongThem)
{
  ManyMeasured measured(WithinBox{{1, 1, 1}});
  std::get<PointConstraint>(measured.list.back().what).within = WithinBall{1};
  try {
    static_cast<void>(measured.result());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.reason(), HasSubstr("More than 2000 are solved together only where all have boxes"));
    EXPECT_THAT(error.reason(), HasSubstr("\"P2268\" has none of these"));
  }
}

TEST(ManyTolerances, AreRefusedWherePointsFollowFromOthers)
{
  ManyMeasured measured(WithinBox{{1, 1, 1}});
  Constraint again = measured.list.back();
  again.name = "again";
  measured.list.push_back(again);
  const DeformResult result = measured.result();
  EXPECT_EQ(result.report.solve.status, SolveStatus::Failed);
  EXPECT_THAT(result.report.solve.message, HasSubstr("some of them follow from others"));
}

}  // namespace
}  // namespace holdfast
