// Regions that stay flat rotate about their normal alone.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

const Vector3 kTurnAxis(1, 1, 0.3);

/// A bar of quadrilaterals along z, copy by `R` as a whole. Its lower end stays, and the upper one turns.
struct BarWithSides {
  Mesh mesh = test::quadBox({2, 2, 6}, 4);
  Mesh rest;
  Eigen::Matrix3d R;

  explicit BarWithSides(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) : R(turn)
  {
    // No right angles, whose weights are rounding.
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      const Vector3 at = mesh.positions.row(v);
      mesh.positions(v, 2) += 0.02 * std::sin(3 * at.x() + 5 * at.y()) * at.z() * (6 - at.z());
    }
    rest = mesh;
    mesh.positions = rest.positions * R.transpose();
  }

  [[nodiscard]] std::vector<Index> where(Index axis, double value) const
  {
    std::vector<Index> vertices;
    const double most = rest.positions.col(axis).maxCoeff();
    const double least = rest.positions.col(axis).minCoeff();
    for (Index v = 0; v < rest.vertexCount(); ++v)
      if (std::abs(rest.positions(v, axis) - (value > 0 ? most : least)) < 1e-9) vertices.push_back(v);
    return vertices;
  }

  /// A side without the vertices of the ends.
  [[nodiscard]] std::vector<Index> side(Index axis) const
  {
    std::vector<Index> vertices = where(axis, 1);
    std::erase_if(vertices, [&](Index v) {
      return std::ranges::count(where(2, 1), v) + std::ranges::count(where(2, -1), v) > 0;
    });
    return vertices;
  }

  [[nodiscard]] DeformResult result(const std::vector<Constraint>& slides) const
  {
    std::vector<Constraint> all{
        test::hold(where(2, -1)),
        {"top", true,
         HandleConstraint{{VertexIds{where(2, 1)}}, AxisRotation{R * kTurnAxis, 50, {}}, Vector3::Zero(), {}}}};
    all.insert(all.end(), slides.begin(), slides.end());
    return test::deformed(mesh, test::listOf(all), {});
  }

  [[nodiscard]] Constraint slide(Index axis) const
  {
    return {"side " + std::to_string(axis), true, SlideConstraint{{VertexIds{side(axis)}}, OnPlane{{}, R.col(axis)}}};
  }
};

TEST(FlatRegions, RotateAboutTheirNormalAlone)
{
  const BarWithSides bar;
  const DeformResult free = bar.result({});
  const DeformResult flat = bar.result({bar.slide(0)});
  ASSERT_EQ(flat.report.solve.status, SolveStatus::Ok) << flat.report.solve.message;
  double across = 0;
  for (const Index v : bar.side(0)) {
    EXPECT_EQ(flat.rotations(v, 1), 0);
    EXPECT_EQ(flat.rotations(v, 2), 0);
    EXPECT_GT(flat.rotations(v, 0), 0.02);
    across = std::max(across, std::abs(free.rotations(v, 1)));
  }
  EXPECT_GT(across, 0.05) << "the control: without the slide it rotates across the normal";
  EXPECT_LT((flat.rotations.col(0) - free.rotations.col(0)).norm(), 1e-12) << "along the normal nothing changes";
}

TEST(FlatRegions, OfTwoNormalsDoNotRotateWhereTheyMeet)
{
  const BarWithSides bar;
  const DeformResult flat = bar.result({bar.slide(0), bar.slide(1)});
  ASSERT_EQ(flat.report.solve.status, SolveStatus::Ok) << flat.report.solve.message;
  int both = 0;
  for (const Index v : bar.side(0)) {
    const bool isInBoth = std::ranges::count(bar.side(1), v) > 0;
    if (!isInBoth) continue;
    ++both;
    EXPECT_EQ(Vector3(flat.rotations.row(v)), Vector3(Vector3::Zero()));
  }
  EXPECT_GT(both, 0);
}

TEST(FlatRegions, OfRotatedCopiesRotateAsThey)
{
  const Eigen::Matrix3d R = rotationMatrix(Vector3(1, -2, 0.5), 40);
  const BarWithSides plain;
  const BarWithSides copy(R);
  const DeformResult first = plain.result({plain.slide(0), plain.slide(1)});
  const DeformResult second = copy.result({copy.slide(0), copy.slide(1)});
  EXPECT_LT((Columns3(first.rotations * R.transpose()) - second.rotations).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((Positions(first.positions * R.transpose()) - second.positions).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FlatRegions, AreThoseOfWholeTrianglesAlongThePlane)
{
  const BarWithSides bar;
  const std::vector<Index> edge = [&] {
    std::vector<Index> vertices = bar.side(0);
    std::erase_if(vertices, [&](Index v) { return std::ranges::count(bar.side(1), v) == 0; });
    return vertices;
  }();
  const Constraint line{"edge", true, SlideConstraint{{VertexIds{edge}}, OnPlane{{}, Vector3::UnitX()}}};
  EXPECT_TRUE(bar.result({line}).details->system.flat.empty()) << "an edge may rotate about itself";
  const Constraint tilted{"tilted", true, SlideConstraint{{VertexIds{bar.side(0)}}, OnPlane{{}, {1, 0, 0.1}}}};
  EXPECT_TRUE(bar.result({tilted}).details->system.flat.empty()) << "it is not flat along that plane";
}

}  // namespace
}  // namespace holdfast
