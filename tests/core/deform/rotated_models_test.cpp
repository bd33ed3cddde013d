// A model that is turned with all its constraints deforms to the same shape, turned: lengths that weigh one thing
// against another do not follow the axes.

#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/deform/deform.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

// Of shapes that are computed in two positions; they differed by a hundredth.
constexpr double kSameShape = 1e-9;

Eigen::Matrix3d turn(double degrees, const Vector3& axis)
{
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
}

std::vector<Eigen::Matrix3d> turns()
{
  return {turn(45, Vector3::UnitX()), turn(30, Vector3::UnitZ()), turn(54.7, {1, -1, 0.2}), turn(200, {1, 2, 3})};
}

std::vector<test::NamedMesh> slenderMeshes()
{
  return {{"bar", test::box(Vector3(6, 1, 1), 4)},
          {"sheet", test::grid(9, 5)},
          {"sphere", test::icosphere(2)},
          {"corners of their own", test::soup(test::grid(4, 7))}};
}

/// Both ends along x are held, one of them moved, and so is a vertex between them.
ConstraintList stretched(const Mesh& mesh, const Eigen::Matrix3d& R)
{
  const double low = mesh.positions.col(0).minCoeff();
  const double length = mesh.positions.col(0).maxCoeff() - low;
  std::vector<Index> ends[2];
  Index middle = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double at = (mesh.positions(v, 0) - low) / length;
    if (at <= 0.15) ends[0].push_back(v);
    if (at >= 0.85) ends[1].push_back(v);
    if (std::abs(at - 0.5) < 0.2) middle = v;
  }
  const Vector3 shift = R * Vector3(0.2, 0.3, 0.1) * length;
  return test::listOf({test::hold(ends[0]), test::handle(ends[1], std::monostate{}, shift),
                       test::moveBy(AtVertex{middle}, R * Vector3(0, 0.1, 0.2) * length)});
}

void expectSameShapes(const DeformOptions& options)
{
  for (const auto& [meshName, mesh] : slenderMeshes()) {
    SCOPED_TRACE(meshName + ", " + std::string(name(options.weights)));
    const DeformResult plain = test::deformed(mesh, stretched(mesh, Eigen::Matrix3d::Identity()), options);
    ASSERT_NE(plain.report.solve.status, SolveStatus::Failed) << plain.report.solve.message;
    EXPECT_GT(test::distance(plain.positions, mesh.positions), 0.01) << "it deforms";
    for (const Eigen::Matrix3d& R : turns()) {
      const Mesh rotatedMesh = test::transformed(mesh, Eigen::Affine3d(R));
      const DeformResult result = test::deformed(rotatedMesh, stretched(mesh, R), options);
      EXPECT_LE(test::distance(result.positions * R, plain.positions), kSameShape);
    }
  }
}

TEST(RotatedModels, HaveTheSameSoftSolution)
{
  for (const Weights weights : test::allWeights())
    expectSameShapes({weights, {SolverKind::Soft, Backend::Holdfast, 5}, {}});
}

TEST(RotatedModels, HaveTheSameSmoothRotations)
{
  for (const Weights weights : test::allWeights())
    expectSameShapes({weights, {}, {RotationSource::FoundSmooth, kFoundChange, 12}});
}

TEST(RotatedModels, HaveTheSameHardSolution)
{
  for (const Weights weights : test::allWeights()) expectSameShapes({weights, {}, {}});
}

}  // namespace
}  // namespace holdfast
