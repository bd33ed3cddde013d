// Drags of meshes that lie far from the origin: moves of a few units in the last place count as any other.

#include <array>
#include <limits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

constexpr int kFarFrames = 40;

/// A sphere `diagonals` of its own away from the origin.
Mesh sphereAway(double diagonals)
{
  const Mesh sphere = test::icosphere(2);
  return test::moved(sphere, diagonals * boundingBoxDiagonal(sphere.positions) * Vector3(1, -0.3, 0.1));
}

/// Up to eight units in the last place of the largest coordinate, along each axis.
Vector3 fewSpacings(test::Random& random, const Mesh& mesh)
{
  const double spacing = std::numeric_limits<double>::epsilon() * mesh.positions.cwiseAbs().maxCoeff();
  Vector3 step;
  for (double& x : step) x = spacing * static_cast<double>(random.integer(-8, 8));
  return step;
}

Vector3 restPlaceOf(const Mesh& mesh, const SurfaceLocation& at)
{
  if (const auto* vertex = std::get_if<AtVertex>(&at)) return mesh.positions.row(vertex->vertex);
  const auto& face = std::get<AtFace>(at);
  Vector3 place = Vector3::Zero();
  for (std::size_t k = 0; k < face.weights.size(); ++k)
    place += face.weights[k] * mesh.positions.row(mesh.faces[face.face][static_cast<Index>(k)]).transpose();
  return place;
}

/// Points of vertices and faces with targets beside them.
ConstraintList scatteredPoints(test::Random& random, const Mesh& mesh)
{
  std::vector<Constraint> points;
  for (int k = 0; k < 12; ++k) {
    const Index face = 25 * k + random.integer(0, 20);
    const SurfaceLocation at =
        k % 3 == 0 ? SurfaceLocation(AtVertex{mesh.faces[face][0]}) : SurfaceLocation(AtFace{face, {0.25, 0.25, 0.5}});
    points.push_back(test::moveTo(at, restPlaceOf(mesh, at) + test::randomVector(random, 0.05)));
  }
  return test::listOf(std::move(points));
}

Vector3& targetOfPoint(Constraint& constraint)
{
  return std::get<Target>(std::get<PointConstraint>(constraint.what).to).place;
}

void moveSomeTargets(test::Random& random, const Mesh& mesh, ConstraintList& list)
{
  for (long k = random.integer(1, 3); k > 0; --k)
    targetOfPoint(list.constraints[random.integer(0, 11)]) += fewSpacings(random, mesh);
}

void moveAllTargets(test::Random& random, const Mesh& mesh, ConstraintList& list)
{
  for (Constraint& constraint : list.constraints) targetOfPoint(constraint) += fewSpacings(random, mesh);
}

/// Points, each repeated: redundant rows that go on to agree.
ConstraintList repeatedPoints(test::Random& random, const Mesh& mesh)
{
  ConstraintList list = scatteredPoints(random, mesh);
  std::vector<Constraint> twice = list.constraints;
  twice.insert(twice.end(), list.constraints.begin(), list.constraints.end());
  return test::listOf(std::move(twice));
}

void moveBothOfSome(test::Random& random, const Mesh& mesh, ConstraintList& list)
{
  const Index place = random.integer(0, 11);
  targetOfPoint(list.constraints[place]) += fewSpacings(random, mesh);
  targetOfPoint(list.constraints[place + 12]) = targetOfPoint(list.constraints[place]);
}

/// A handle, a rigid region, a kept vector and a point.
ConstraintList mixedConstraints(test::Random& random, const Mesh& mesh)
{
  const SurfaceLocation at = AtFace{200, {0.25, 0.5, 0.25}};
  return test::listOf({test::handle({0, 1, 2}, std::monostate(), test::randomVector(random, 0.1)),
                       test::rigid({20, 21, 22, 23}),
                       {"", true, RelativeConstraint{AtVertex{40}, AtFace{100, {0.25, 0.25, 0.5}}, {}}},
                       test::moveTo(at, restPlaceOf(mesh, at))});
}

void moveHandleOrPoint(test::Random& random, const Mesh& mesh, ConstraintList& list)
{
  if (random.integer(0, 1) == 0)
    std::get<HandleConstraint>(list.constraints[0].what).translate += fewSpacings(random, mesh);
  else
    targetOfPoint(list.constraints[3]) += fewSpacings(random, mesh);
}

struct FarDrag {
  const char* name;
  ConstraintList (*makeList)(test::Random& random, const Mesh& mesh);
  void (*move)(test::Random& random, const Mesh& mesh, ConstraintList& list);
};

constexpr std::array kDrags{FarDrag{"SomePoints", scatteredPoints, moveSomeTargets},
                            FarDrag{"AllPoints", scatteredPoints, moveAllTargets},
                            FarDrag{"RepeatedPoints", repeatedPoints, moveBothOfSome},
                            FarDrag{"HandlesAndVectors", mixedConstraints, moveHandleOrPoint}};

void expectMetAsFresh(const DeformResult& dragged, const DeformResult& fresh, const ConstraintList& list)
{
  ASSERT_EQ(dragged.report.solve.status, fresh.report.solve.status) << dragged.report.solve.message;
  for (std::size_t c = 0; c < list.constraints.size(); ++c) {
    const ConstraintOutcome& outcome = dragged.report.constraints[c];
    EXPECT_EQ(outcome.status, fresh.report.constraints[c].status) << c;
    ASSERT_TRUE(outcome.residual && outcome.limit);
    EXPECT_LE(*outcome.residual, *outcome.limit) << c;
  }
}

class FarDrags : public testing::TestWithParam<FarDrag> {};

TEST_P(FarDrags, MeetWhatFreshDeformationsMeet)
{
  for (const double diagonals : {0.0, 1e3, 1e5, 1e7}) {
    SCOPED_TRACE(testing::Message() << diagonals << " diagonals away");
    const Mesh mesh = sphereAway(diagonals);
    test::Random random(3);
    ConstraintList list = GetParam().makeList(random, mesh);
    Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
    static_cast<void>(deformer.deform(list));
    for (int k = 0; k < kFarFrames; ++k) {
      SCOPED_TRACE(k);
      GetParam().move(random, mesh, list);
      expectMetAsFresh(deformer.deform(list), test::deformed(mesh, list, {}), list);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FarDrags, testing::ValuesIn(kDrags),
                         [](const testing::TestParamInfo<FarDrag>& drag) { return drag.param.name; });

}  // namespace
}  // namespace holdfast
