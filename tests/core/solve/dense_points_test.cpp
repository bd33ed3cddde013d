// Points in about half of the faces: rows of one large component that nearly depend on one another. Our own solver
// keeps some of them with multipliers, and goes on by a basis of all rows where that takes digits.

#include <algorithm>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

const Vector3 kCommon(0.1, 0.2, 0.3);

std::vector<Index> shuffled(Index count, test::Random& random)
{
  std::vector<Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Index{0});
  for (Index k = count - 1; k > 0; --k) std::swap(order[k], order[random.integer(0, k)]);
  return order;
}

/// Weights are multiples of 1/64, so that points that depend on one another do so exactly.
SurfaceLocation placeInside(test::Random& random, Index face)
{
  const long a = random.integer(4, 56);
  const long b = random.integer(4, 60 - a);
  return AtFace{face, {static_cast<double>(a) / 64, static_cast<double>(b) / 64, static_cast<double>(64 - a - b) / 64}};
}

/// One point in each of a share of the faces, all moved alike but for up to `off` along each axis.
ConstraintList densePoints(const Mesh& mesh, double share, double off, std::uint32_t seed)
{
  test::Random random(seed);
  std::vector<Constraint> points;
  const std::vector<Index> faces = shuffled(mesh.faces.size(), random);
  for (Index k = 0; k < static_cast<Index>(share * static_cast<double>(mesh.faces.size())); ++k)
    points.push_back(test::moveBy(placeInside(random, faces[k]), kCommon + test::randomVector(random, off)));
  return test::listOf(std::move(points));
}

DeformResult deformedOn(Backend backend, const Mesh& mesh, const ConstraintList& list)
{
  return test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
}

struct Density {
  double share;
  double off;
};

class DensePoints : public testing::TestWithParam<Density> {
 protected:
  /// Calls `check(list)` for several sets of points.
  template <class Check>
  void forEachList(const Check& check) const
  {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(seed);
      check(densePoints(mesh_, GetParam().share, GetParam().off, seed));
    }
  }

  Mesh mesh_ = test::icosphere(3);
};

TEST_P(DensePoints, AreMetWhereOtherBackendsMeetThem)
{
  forEachList([&](const ConstraintList& list) {
    const DeformResult own = deformedOn(Backend::Holdfast, mesh_, list);
    const DeformResult other = deformedOn(Backend::Eigen, mesh_, list);
    if (other.report.solve.status == SolveStatus::Failed) return;
    ASSERT_EQ(own.report.solve.status, other.report.solve.status) << own.report.solve.message;
    EXPECT_LE(own.report.solve.maxResidualRelative, std::max(1e-14, 2 * other.report.solve.maxResidualRelative));
    EXPECT_LE(own.report.solve.accuracy, std::max(1e-12, 2 * other.report.solve.accuracy));
  });
}

TEST_P(DensePoints, AreMetInDragsAsWell)
{
  ConstraintList list = densePoints(mesh_, GetParam().share, GetParam().off, 1);
  Deformer deformer(makeModel(mesh_), {}, DeformerMode::Interactive);
  for (int frame = 0; frame < 4; ++frame) {
    for (Constraint& constraint : list.constraints)
      std::get<Move>(std::get<PointConstraint>(constraint.what).to).shift.z() += 0.01;
    const DeformResult dragged = deformer.deform(list);
    const SolveStatus other = deformedOn(Backend::Eigen, mesh_, list).report.solve.status;
    if (other != SolveStatus::Failed) {
      EXPECT_EQ(dragged.report.solve.status, other) << dragged.report.solve.message;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, DensePoints,
                         testing::Values(Density{0.46, 0}, Density{0.5, 0}, Density{0.55, 0}, Density{0.46, 0.02},
                                         Density{0.5, 0.02}));

TEST(FewPoints, OfOneComponentKeepTheirMultipliers)
{
  const Mesh mesh = test::icosphere(3);
  const DeformResult result = deformedOn(Backend::Holdfast, mesh, densePoints(mesh, 0.33, 0.02, 3));
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_THAT(result.report.solve.method, testing::HasSubstr("multipliers"));
}

}  // namespace
}  // namespace holdfast
