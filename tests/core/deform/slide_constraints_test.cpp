// Vertices that stay on a plane or a line, and points that come together.

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/fitted_guides.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Guide = decltype(SlideConstraint::on);

Constraint slide(std::vector<Index> vertices, Guide on, bool together = false)
{
  return {"", true, SlideConstraint{{VertexIds{std::move(vertices)}}, std::move(on), together}};
}

Constraint coincident(SurfaceLocation from, SurfaceLocation to)
{
  return {"", true, CoincidentConstraint{std::move(from), std::move(to)}};
}

/// Pulls the last vertex off while the first ones are held, and slides the others.
ConstraintList pulledList(const Mesh& mesh, Constraint sliding)
{
  return test::listOf(
      {test::hold({0, 1, 2}), test::moveBy(AtVertex{mesh.vertexCount() - 1}, {0.2, -0.1, 0.3}), std::move(sliding)});
}

TEST(SlideConstraints, AreTheirVerticesAsPointsOnThePlane)
{
  const Mesh mesh = test::plate(8, 8);
  const std::vector<Index> vertices{20, 21, 30, 31, 40};
  const OnPlane plane{Vector3(0, 0, 0.2), {0, 3, 4}, 0.1};
  ConstraintList asPoints = pulledList(mesh, test::hold({3}));
  asPoints.constraints.pop_back();
  for (const Index v : vertices)
    asPoints.constraints.push_back({"V" + std::to_string(v), true, PointConstraint{AtVertex{v}, plane}});
  const DeformResult slid = test::deformed(mesh, pulledList(mesh, slide(vertices, plane)), {});
  EXPECT_EQ(slid.report.solve.status, SolveStatus::Ok) << slid.report.solve.message;
  EXPECT_EQ(slid.positions, test::deformed(mesh, asPoints, {}).positions);
  EXPECT_EQ(slid.report.constraints[2].rows, 5);
}

TEST(SlideConstraints, CopyTheCoordinateOfAPlaneAndTheTwoOfALine)
{
  const Mesh mesh = test::plate(8, 8);
  const double third = 1.0 / 3;
  const DeformResult onPlane =
      test::deformed(mesh, pulledList(mesh, slide({20, 30, 40}, OnPlane{Vector3(5, 5, third), {0, 0, -2}, 0})), {});
  for (const Index v : {20, 30, 40}) EXPECT_EQ(onPlane.positions(v, 2), third);
  const DeformResult onLine =
      test::deformed(mesh, pulledList(mesh, slide({20, 30, 40}, OnLine{Vector3(5, third, -third), {7, 0, 0}})), {});
  for (const Index v : {20, 30, 40}) {
    EXPECT_EQ(onLine.positions(v, 1), third);
    EXPECT_EQ(onLine.positions(v, 2), -third);
  }
  EXPECT_NE(onLine.positions(20, 0), onLine.positions(30, 0)) << "they are free along x";
}

TEST(SlideConstraints, WithoutAPointKeepEachVertexInAPlaneOfItsOwn)
{
  const Mesh mesh = test::icosphere(2);
  const DeformResult result =
      test::deformed(mesh, pulledList(mesh, slide({20, 30, 40}, OnPlane{{}, {0, 0, 1}, 0})), {});
  for (const Index v : {20, 30, 40}) {
    EXPECT_EQ(result.positions(v, 2), mesh.positions(v, 2));
    EXPECT_NE(result.positions(v, 0), mesh.positions(v, 0));
  }
}

TEST(SlideConstraints, ThatAreFittedFlattenTheirVertices)
{
  test::Random random(4);
  Mesh mesh = test::plate(8, 8);
  for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.positions.row(v) += test::randomVector(random, 0.01).transpose();
  const std::vector<Index> vertices{18, 20, 22, 36, 38, 40};
  const OnPlane plane = fittedPlane(mesh.positions(vertices, Eigen::all)).value();
  const DeformResult result = test::deformed(mesh, pulledList(mesh, slide(vertices, FittedPlane{})), {});
  for (const Index v : vertices)
    EXPECT_NEAR(plane.normal.dot(Vector3(result.positions.row(v)) - *plane.point), 0, 1e-14);
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
}

TEST(SlideConstraints, ThatMayShiftGoAlongAndStayFlat)
{
  const Mesh mesh = test::plate(8, 8);
  const Index last = mesh.vertexCount() - 1;
  std::vector<Index> lastRow;
  for (Index v = last - 7; v <= last; ++v) lastRow.push_back(v);
  const ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{last}, {0, 0, 0.5}),
                                            slide(lastRow, OnPlane{{}, {0, 0, 1}, 0}, true)});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (const Index v : lastRow)
    EXPECT_NEAR(result.positions(v, 2) - mesh.positions(v, 2), 0.5, 1e-14) << "all rise as the one that is pulled";
}

TEST(SlideConstraints, ThatContradictAPinAreNamedWithIt)
{
  const Mesh mesh = test::plate(6, 6);
  const Vector3 rest = mesh.positions.row(20);
  for (const bool isPinFirst : {true, false}) {
    std::vector<Constraint> all{test::hold({0}), test::moveBy(AtVertex{20}, {0, 0, 0.3}),
                                slide({19, 20, 21}, OnPlane{rest, {0, 0, 1}, 0})};
    if (!isPinFirst) std::swap(all[1], all[2]);
    const DeformResult result = test::deformed(mesh, test::listOf(std::move(all)), {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
    const ConstraintOutcome& second = result.report.constraints[2];
    ASSERT_EQ(second.conflictSets.size(), 1U);
    EXPECT_THAT(second.conflictSets[0].with, ElementsAre("P1"));
    EXPECT_NEAR(*second.gap, 0.3, 1e-14);
    EXPECT_EQ(result.positions(20, 2), isPinFirst ? rest.z() + 0.3 : rest.z()) << "the earlier one holds";
  }
}

TEST(SlideConstraints, WithoutOnePlaneOrLineAreRefused)
{
  const Mesh mesh = test::plate(6, 6);
  const auto expectRefused = [&](const Guide& on, std::vector<Index> vertices, const std::string& key) {
    try {
      static_cast<void>(test::deformed(mesh, pulledList(mesh, slide(std::move(vertices), on)), {}));
      ADD_FAILURE() << "it was solved";
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().element, "constraints[2]" + key);
      EXPECT_THAT(error.reason(), HasSubstr("\"P2\""));
    }
  };
  expectRefused(FittedPlane{}, {7}, ".on.plane");
  expectRefused(FittedPlane{}, {7, 8}, ".on.plane");
  expectRefused(FittedLine{}, {7}, ".on.line");
  expectRefused(OnPlane{{}, {0, 0, 0}, 0}, {7, 8, 20}, "");
  expectRefused(OnLine{{}, {0, 0, 0}}, {7, 8, 20}, "");
}

TEST(SlideConstraints, OfOneVertexThatMayShiftAreNoted)
{
  const Mesh mesh = test::plate(6, 6);
  const DeformResult result = test::deformed(mesh, pulledList(mesh, slide({20}, OnPlane{{}, {0, 0, 1}, 0}, true)), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok);
  const std::vector<ConstraintNote>& notes = result.details->system.notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].kind, "plane_of_one_vertex");
  EXPECT_EQ(notes[0].constraint, 2);
}

TEST(FittedGuides, FitWhatLiesOnThem)
{
  test::Random random(8);
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.4, 0.1, -0.7, 0.3).normalized().toRotationMatrix();
  Positions flat(30, 3);
  Positions straight(30, 3);
  for (Index k = 0; k < 30; ++k) {
    flat.row(k) = R * Vector3(random.uniform(-1, 1), random.uniform(-3, 3), 0.25);
    straight.row(k) = R * Vector3(0.5, 0.25, random.uniform(-1, 1));
  }
  EXPECT_LT(fittedPlane(flat)->normal.cross(R.col(2)).norm(), 1e-14);
  EXPECT_NEAR(fittedPlane(flat)->point->dot(R.col(2)), 0.25, 1e-14);
  EXPECT_LT(fittedLine(straight)->direction.cross(R.col(2)).norm(), 1e-14);
  EXPECT_FALSE(fittedPlane(straight));
  EXPECT_FALSE(fittedLine(Positions::Ones(4, 3)));
}

TEST(FittedGuides, OfRoundedCoordinatesAreAlongTheAxis)
{
  Positions places(4, 3);
  places << 0, 0, 2, 10, 0, 2.000001, 0, 10, 2, 10, 10, 2;
  EXPECT_EQ(fittedPlane(places)->normal, Vector3::UnitZ());
  places.col(2).setConstant(0.1);
  EXPECT_EQ(fittedPlane(places)->point->z(), 0.1) << "what all have in common is kept to the last bit";
}

TEST(CoincidentConstraints, AreAnOffsetOfZero)
{
  const Mesh mesh = test::plate(8, 8);
  const AtFace from{10, {0.2, 0.3, 0.5}};
  const AtVertex to{60};
  const DeformResult joined = test::deformed(mesh, pulledList(mesh, coincident(from, to)), {});
  const DeformResult offset =
      test::deformed(mesh, pulledList(mesh, {"", true, RelativeConstraint{from, to, Vector3(Vector3::Zero())}}), {});
  EXPECT_EQ(joined.positions, offset.positions);
  EXPECT_LE(joined.report.solve.maxResidualRelative, 1e-14);
}

TEST(CoincidentConstraints, BringTwoPartsTogether)
{
  const Mesh mesh = test::merged(test::icosphere(1), test::moved(test::icosphere(1), {3, 0, 0}));
  const Index half = mesh.vertexCount() / 2;
  const ConstraintList list =
      test::listOf({test::hold({0, 1, 2}), coincident(AtVertex{5}, AtVertex{half + 5}),
                    coincident(AtVertex{8}, AtVertex{half + 8}), coincident(AtVertex{30}, AtVertex{half + 30})});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (const Index v : {5, 8, 30}) EXPECT_LT((result.positions.row(v) - result.positions.row(half + v)).norm(), 1e-13);
}

TEST(SlideConstraints, OfFilesAreReadAndWritten)
{
  const std::string text = R"({"format": "holdfast-constraints", "version": 2, "constraints": [
    {"type": "slide", "select": {"component": 0}, "on": {"plane": "fit"}},
    {"type": "slide", "select": {"component": 0}, "on": {"line": {"direction": [1, 0, 0]}}, "together": true},
    {"type": "coincident", "from": {"vertex": 3}, "to": {"near": [0, 1, 0]}}]})";
  const ConstraintList list = parseConstraintsJson(text, "c.json");
  EXPECT_TRUE(std::holds_alternative<FittedPlane>(std::get<SlideConstraint>(list.constraints[0].what).on));
  EXPECT_TRUE(std::get<SlideConstraint>(list.constraints[1].what).together);
  EXPECT_EQ(list.constraints[2].name, "coincident 3");
  const std::string written = constraintsToJson(list);
  EXPECT_THAT(written, HasSubstr("\"version\": 2,"));
  EXPECT_EQ(constraintsToJson(parseConstraintsJson(written, "c.json")), written);
}

}  // namespace
}  // namespace holdfast
