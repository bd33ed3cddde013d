
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/vertex_normals.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using test::deformed;
using test::moveBy;
using testing::ElementsAre;

constexpr SolverKind kKinds[] = {SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange};

/// Calls `check(options)` for every weighting, backend and solver.
template <class Check>
void forEachOption(Check&& check)
{
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends())
      for (const SolverKind kind : kKinds) {
        SCOPED_TRACE(testing::Message() << name(weights) << ", " << name(backend) << ", " << name(kind));
        check(DeformOptions{weights, {kind, backend, 5}});
      }
}

TEST(Parts, WithoutAConstraintStayAtRestBitForBitAndAreReported)
{
  const Mesh sphere = test::icosphere(2);
  const Index n = sphere.vertexCount();
  const Mesh mesh = test::merged(sphere, test::moved(test::plate(4, 4), {3, 1.0 / 3, 0}));
  forEachOption([&](const DeformOptions& options) {
    const DeformResult result =
        deformed(mesh, test::listOf({test::hold({5}), moveBy(AtVertex{90}, {0, 0.2, 0.4})}), options);
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(result.positions.bottomRows(25), mesh.positions.bottomRows(25));
    EXPECT_NE(result.positions.row(60), mesh.positions.row(60));
    const Finding* finding = test::findingOf(result.report, "parts_at_rest");
    ASSERT_NE(finding, nullptr);
    EXPECT_THAT(finding->ids, ElementsAre(n));
  });
}

TEST(Parts, DeformAsEachWouldAlone)
{
  const Mesh sphere = test::icosphere(1);
  const Mesh plate = test::moved(test::plate(4, 4), {3, 0, 0});
  const ConstraintList ofSphere = test::listOf({test::hold({5}), moveBy(AtVertex{30}, {0, 0.2, 0.4})});
  ConstraintList ofBoth = ofSphere;
  ofBoth.constraints.push_back({"plate", true, PointConstraint{AtVertex{sphere.vertexCount() + 3}, Move{{1, 2, 3}}}});
  forEachOption([&](const DeformOptions& options) {
    if (options.solver.kind == SolverKind::Soft) return;  // its weight is in units of the whole mesh
    const Positions together = deformed(test::merged(sphere, plate), ofBoth, options).positions;
    EXPECT_LT(test::distance(together.topRows(sphere.vertexCount()), deformed(sphere, ofSphere, options).positions),
              1e-11);
    EXPECT_LT(test::distance(together.bottomRows(25), test::moved(plate, {1, 2, 3}).positions), 1e-11);
  });
}

TEST(Parts, OfVerticesThatNoFaceUsesStayUnlessPinned)
{
  Mesh mesh = test::withVertex(test::withVertex(test::plate(4, 4), {9, 1.0 / 3, 9}), {8, 8, 8});
  forEachOption([&](const DeformOptions& options) {
    const DeformResult result = deformed(
        mesh, test::listOf({test::hold({0, 4}), moveBy(AtVertex{24}, {0, 0, 1}), moveBy(AtVertex{26}, {1, 0, 0})}),
        options);
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(result.positions.row(25), mesh.positions.row(25));
    EXPECT_LT((result.positions.row(26) - Eigen::RowVector3d(9, 8, 8)).norm(), 1e-14);
  });
}

TEST(Parts, OfClosedBoxesThatTouchDoNotMoveTogether)
{
  const Mesh box = test::box(Vector3(1, 1, 1), 2);
  const Mesh mesh = test::merged(box, test::moved(box, {1, 0, 0}));
  forEachOption([&](const DeformOptions& options) {
    const DeformResult result = deformed(mesh, test::listOf({moveBy(AtVertex{0}, {-1, 0, 0})}), options);
    EXPECT_LT(test::distance(result.positions.topRows(26), test::moved(box, {-1, 0, 0}).positions), 1e-11);
    EXPECT_EQ(result.positions.bottomRows(26), mesh.positions.bottomRows(26));
  });
}

TEST(Parts, OfASoupDeformLikeTheWeldedMeshAndStayTogetherBitForBit)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::span<const int> vertexOf = named.mesh.faces.corners();
    const Mesh soup = test::soup(named.mesh);
    const auto last = static_cast<Index>(vertexOf.size()) - 1;
    const Vector3 shift(0.1, 0.2, 0.3);
    const std::vector<double> halves = [&] {
      std::vector<double> weights(named.mesh.faces[3].size(), 0);
      weights[0] = weights[2] = 0.5;
      return weights;
    }();
    const auto list = [&](Index first, Index second) {
      return test::listOf({test::hold({first}), moveBy(AtVertex{second}, shift), moveBy(AtFace{3, halves}, -shift)});
    };
    forEachOption([&](const DeformOptions& options) {
      const DeformResult welded = deformed(named.mesh, list(vertexOf[0], vertexOf[last]), options);
      const DeformResult apart = deformed(soup, list(0, last), options);
      ASSERT_EQ(apart.report.solve.status, SolveStatus::Ok) << apart.report.solve.message;
      Positions gathered(soup.vertexCount(), 3);
      std::vector<Index> firstOf(static_cast<std::size_t>(named.mesh.vertexCount()), -1);
      for (Index k = 0; k <= last; ++k) {
        gathered.row(k) = welded.positions.row(vertexOf[k]);
        if (firstOf[vertexOf[k]] < 0) firstOf[vertexOf[k]] = k;
        EXPECT_EQ(apart.positions.row(k), apart.positions.row(firstOf[vertexOf[k]]));
      }
      EXPECT_LT(test::distance(apart.positions, gathered), 1e-10);
    });
  }
}

}  // namespace
}  // namespace holdfast
