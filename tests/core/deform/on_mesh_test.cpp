// Points that lie on another mesh.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/guide_files.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/document/session_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/guide_surface.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

OnMesh onMesh(const Mesh& mesh)
{
  return {"scan.stl", std::make_shared<const GuideSurface>(mesh, "scan.stl")};
}

/// Above the middle of a plate of 8 x 8, which is 8 wide.
Mesh sphereOver(int levels)
{
  return test::transformed(test::icosphere(levels),
                           Eigen::Translation3d(4, 4, -9.5) * Eigen::UniformScaling<double>(10.0));
}

const std::vector<Index> kMiddle{30, 31, 32, 39, 40, 41, 48, 49, 50};

/// One side of the plate is held, and its middle lies on another mesh.
std::vector<Constraint> slidOn(OnMesh on, PointTolerance within = {})
{
  return {test::hold({0, 1, 2, 3, 4, 5, 6, 7, 8}),
          {"", true, SlideConstraint{{VertexIds{kMiddle}}, std::move(on), false, within}}};
}

/// By all triangles, one after the other.
double distanceFrom(const Mesh& mesh, const Vector3& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const std::span<const int> face = mesh.faces[f];
    const std::array<Vector3, 3> corners{mesh.positions.row(face[0]), mesh.positions.row(face[1]),
                                         mesh.positions.row(face[2])};
    least = std::min(least, (closestPointOfTriangle(corners, place).position - place).norm());
  }
  return least;
}

double farthestFrom(const Mesh& guide, const Positions& positions)
{
  double most = 0;
  for (const Index v : kMiddle) most = std::max(most, distanceFrom(guide, positions.row(v)));
  return most;
}

TEST(OnMesh, IsOnAPlaneWhereTheMeshIsFlat)
{
  const Mesh mesh = test::plate(8, 8);
  const Mesh flat =
      test::transformed(test::grid(3, 3), Eigen::Translation3d(-10, -10, 0.7) * Eigen::Scaling(10.0, 10.0, 1.0));
  std::vector<Constraint> asPlane = slidOn({});
  std::get<SlideConstraint>(asPlane[1].what).on = OnPlane{Vector3(0, 0, 0.7), Vector3::UnitZ(), 0};
  for (const Constraint& pull :
       {test::moveBy(AtVertex{80}, {0.3, -0.2, 0.5}), test::moveBy(AtFace{60, {0.2, 0.3, 0.5}}, {1, 0, 0})}) {
    std::vector<Constraint> slid = slidOn(onMesh(flat));
    slid.push_back(pull);
    asPlane.resize(2);
    asPlane.push_back(pull);
    const DeformResult result = test::deformed(mesh, test::listOf(slid), {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(test::distance(result.positions, test::deformed(mesh, test::listOf(asPlane), {}).positions), 1e-10);
    EXPECT_EQ(test::findingOf(result.report, "unsettled_places"), nullptr);
  }
}

TEST(OnMesh, LiesOnARoundSurfaceAndPullsAcrossIt)
{
  const Mesh mesh = test::plate(8, 8);
  for (const int levels : {2, 4}) {
    const Mesh sphere = sphereOver(levels);
    const OnMesh on = onMesh(sphere);
    const DeformResult result = test::deformed(mesh, test::listOf(slidOn(on)), {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(farthestFrom(sphere, result.positions), 1e-13);
    const DeformDetails& details = *result.details;
    for (const TolerantRow& tolerant : details.system.tolerant) {
      const Vector3 force = details.multipliers.get().ofRows.row(tolerant.row);
      const Vector3 normal = on.surface->footOf(details.system.rows[tolerant.row].target).normal;
      EXPECT_LT(force.cross(normal).norm(), 1e-4 * force.norm()) << levels;
    }
  }
}

TEST(OnMesh, KeepsADistanceAndPullsAtItsBounds)
{
  const Mesh mesh = test::plate(8, 8);
  const Mesh sphere = sphereOver(3);
  const OnMesh on = onMesh(sphere);
  const DeformResult near = test::deformed(mesh, test::listOf(slidOn(on, WithinBall{0.05})), {});
  EXPECT_EQ(near.report.solve.status, SolveStatus::Ok) << near.report.solve.message;
  EXPECT_LE(farthestFrom(sphere, near.positions), 0.05 + 1e-14);
  EXPECT_NEAR(*near.report.constraints[1].offTarget, 0.05, 1e-14);
  EXPECT_TRUE(*near.report.constraints[1].isAtBound);
  const DeformResult above = test::deformed(mesh, test::listOf(slidOn(on, WithinSlab{0.2, 0.25, {}})), {});
  for (const Index v : kMiddle) {
    const double distance = on.surface->footOf(above.positions.row(v)).distance;
    EXPECT_GE(distance, 0.2 - 1e-13);
    EXPECT_LE(distance, 0.25 + 1e-13);
  }
  const DeformResult soft = test::deformed(mesh, test::listOf(slidOn(on, Weighted{1e4})), {});
  EXPECT_LT(farthestFrom(sphere, soft.positions), 1e-3);
  EXPECT_GT(farthestFrom(sphere, soft.positions), 1e-12);
}

TEST(OnMesh, OfTwoMeshesIsWhereTheyMeet)
{
  const Mesh mesh = test::plate(8, 8);
  const Eigen::UniformScaling<double> larger(30.0);
  const Mesh level = test::transformed(test::grid(1, 1), Eigen::Translation3d(-10, -10, 0.5) * larger);
  const Mesh upright = test::transformed(
      test::grid(1, 1), Eigen::Translation3d(4.3, -10, -10) * Eigen::AngleAxisd(-1.3, Vector3::UnitY()) * larger);
  std::vector<Constraint> all = slidOn(onMesh(level));
  all.push_back({"", true, PointConstraint{AtVertex{40}, onMesh(upright)}});
  const DeformResult result = test::deformed(mesh, test::listOf(all), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  const Vector3 place = result.positions.row(40);
  EXPECT_LT(distanceFrom(level, place), 1e-13);
  EXPECT_LT(distanceFrom(upright, place), 1e-13);
}

TEST(OnMesh, ConflictsWithAPinThatLiesElsewhere)
{
  const Mesh mesh = test::plate(8, 8);
  const Constraint on{"", true, PointConstraint{AtVertex{40}, onMesh(sphereOver(3))}};
  const Constraint pin = test::moveBy(AtVertex{40}, {0, 0, 2});
  for (const auto& [first, second] : {std::pair(on, pin), std::pair(pin, on)}) {
    const ConstraintList list = test::listOf({test::hold({0, 1, 2}), first, second});
    const DeformResult result = test::deformed(mesh, list, {});
    EXPECT_EQ(result.report.constraints[1].status, ConstraintStatus::Met);
    EXPECT_EQ(result.report.constraints[2].status, ConstraintStatus::Conflicting);
    ASSERT_EQ(result.report.constraints[2].conflictSets.size(), 1U);
    EXPECT_THAT(result.report.constraints[2].conflictSets.front().with, testing::ElementsAre("P1"));
  }
}

TEST(OnMesh, RepeatsAPinOnTheMesh)
{
  const Mesh mesh = test::plate(8, 8);
  const OnMesh on = onMesh(sphereOver(3));
  const Vector3 foot = on.surface->footOf(mesh.positions.row(40)).place;
  const DeformResult result = test::deformed(
      mesh,
      test::listOf({test::hold({0}), test::moveTo(AtVertex{40}, foot), {"", true, PointConstraint{AtVertex{40}, on}}}),
      {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_EQ(result.report.constraints[2].status, ConstraintStatus::Redundant);
}

TEST(OnMesh, NamesPointsThatReachTheBorder)
{
  const Mesh small = test::transformed(test::grid(1, 1), Eigen::Affine3d(Eigen::Translation3d(3.6, 3.6, 0.3)));
  const DeformResult result = test::deformed(test::plate(8, 8), test::listOf(slidOn(onMesh(small))), {});
  const Finding* border = test::findingOf(result.report, "on_border");
  ASSERT_NE(border, nullptr);
  EXPECT_THAT(border->message, HasSubstr("of 9 points at the border"));
  EXPECT_LT(farthestFrom(small, result.positions), 1e-13);
}

TEST(OnMesh, IsDraggedAndFoundWithRotations)
{
  const Mesh mesh = test::plate(8, 8);
  const Mesh sphere = sphereOver(3);
  std::vector<Constraint> all = slidOn(onMesh(sphere));
  all.push_back(test::moveBy(AtVertex{80}, {0, 0, 0.1}));
  ConstraintList list = test::listOf(all);
  Deformer live(makeModel(mesh, "mesh"), {}, DeformerMode::Interactive);
  for (int step = 0; step < 4; ++step) {
    std::get<Move>(std::get<PointConstraint>(list.constraints[2].what).to).shift += Vector3(0, 0.1, 0.1);
    const DeformResult dragged = live.deform(list);
    EXPECT_EQ(dragged.report.solve.status, SolveStatus::Ok) << dragged.report.solve.message;
    EXPECT_LT(farthestFrom(sphere, dragged.positions), 1e-13);
    EXPECT_LT(test::distance(dragged.positions, test::deformed(mesh, list, {}).positions), 1e-9);
  }
  DeformOptions found;
  found.rotations.source = RotationSource::Found;
  const DeformResult withFound = test::deformed(mesh, list, found);
  EXPECT_EQ(withFound.report.solve.status, SolveStatus::Ok) << withFound.report.solve.message;
  EXPECT_LT(farthestFrom(sphere, withFound.positions), 1e-13);
}

TEST(OnMesh, IsRefusedWhereItMakesNoSense)
{
  const auto refusal = [](const Constraint& constraint) -> std::string {
    try {
      static_cast<void>(test::deformed(test::plate(8, 8), test::listOf({test::hold({0, 1}), constraint}), {}));
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const Selection middle{VertexIds{kMiddle}};
  const OnMesh on = onMesh(sphereOver(1));
  EXPECT_THAT(refusal({"", true, PointConstraint{AtVertex{40}, OnMesh{"lost.stl", {}}}}), HasSubstr("was not read"));
  EXPECT_THAT(refusal({"", true, SlideConstraint{middle, on, true}}), HasSubstr("may shift"));
  EXPECT_THAT(refusal({"", true, SlideConstraint{middle, on, false, WithinBox{{1, 1, 1}}}}), HasSubstr(".within.box"));
  EXPECT_THAT(refusal({"", true, SlideConstraint{middle, on, false, WithinSlab{0, 1, Vector3(0, 0, 1)}}}),
              HasSubstr(".within.normal"));
}

TEST(TolerancesOfGuides, AreMetAcrossPlanesAndLines)
{
  const Mesh mesh = test::plate(8, 8);
  const Vector3 normal = Vector3(1, 2, 2) / 3;
  const Vector3 through(4, 4, 0.8);
  const auto slidWithin = [&](decltype(SlideConstraint::on) on, const PointTolerance& within) {
    return test::deformed(
        mesh,
        test::listOf({test::hold({0, 1, 2, 3}),
                      {"", true, SlideConstraint{{VertexIds{{40, 41, 50}}}, std::move(on), false, within}}}),
        {});
  };
  const DeformResult nearPlane = slidWithin(OnPlane{through, normal, 0}, WithinBall{0.1});
  const DeformResult above = slidWithin(OnPlane{through, normal, 0}, WithinSlab{0.2, 0.3, {}});
  const DeformResult nearLine = slidWithin(OnLine{through, normal}, WithinBall{0.1});
  bool isAtBound = false;
  for (const Index v : {40, 41, 50}) {
    const auto from = [&](const DeformResult& result) -> Vector3 {
      return result.positions.row(v).transpose() - through;
    };
    EXPECT_LE(std::abs(normal.dot(from(nearPlane))), 0.1 + 1e-14);
    isAtBound = isAtBound || std::abs(normal.dot(from(nearPlane))) > 0.1 - 1e-14;
    EXPECT_GE(normal.dot(from(above)), 0.2 - 1e-14);
    EXPECT_LE(normal.dot(from(above)), 0.3 + 1e-14);
    EXPECT_LE(from(nearLine).cross(normal).norm(), 0.1 + 1e-14);
  }
  EXPECT_TRUE(isAtBound);
  EXPECT_NEAR(*nearPlane.report.constraints[1].offTarget, 0.1, 1e-14);
  EXPECT_NEAR(*nearLine.report.constraints[1].offTarget, 0.1, 1e-14);
  // The smaller the ball, the nearer to what is met exactly.
  const DeformResult exact = slidWithin(OnLine{through, normal}, Exactly{});
  EXPECT_LT(test::distance(slidWithin(OnLine{through, normal}, WithinBall{1e-6}).positions, exact.positions), 1e-4);
}

TEST(TolerancesOfGuides, OfOneWeightAreThoseOfSoftConstraints)
{
  const Mesh mesh = test::plate(8, 8);
  const DeformResult heavy = test::deformed(
      mesh,
      test::listOf({test::hold({0, 1, 2, 3}),
                    {"", true, PointConstraint{AtVertex{40}, OnPlane{Vector3(0, 0, 2), {0, 0, 1}, 0}, Weighted{1e6}}}}),
      {});
  const DeformResult exact =
      test::deformed(mesh,
                     test::listOf({test::hold({0, 1, 2, 3}),
                                   {"", true, PointConstraint{AtVertex{40}, OnPlane{Vector3(0, 0, 2), {0, 0, 1}, 0}}}}),
                     {});
  EXPECT_LT(test::distance(heavy.positions, exact.positions), 1e-6);
}

constexpr const char* kOnScan =
    R"({"format": "holdfast-constraints", "version": 2, "constraints": [)"
    R"({"type": "slide", "name": "top", "select": {"vertices": [40, 41]}, "on": {"mesh": "scans/scan.off"}},)"
    R"({"type": "point", "name": "P", "at": {"vertex": 42}, "on": {"mesh": "scans/scan.off"}, "within": {"slab": [null, 0.5]}}]})";

struct FolderWithScan {
  test::TemporaryFolder folder;

  FolderWithScan()
  {
    std::filesystem::create_directory(folder.path() / "scans");
    const Mesh sphere = sphereOver(2);
    writeMesh(folder.path() / "scans/scan.off", {sphere, nullptr}, sphere.positions);
    std::ofstream(folder.path() / "list.json") << kOnScan;
  }
};

TEST(OnMeshInFiles, ReadsTheMeshBesideTheFile)
{
  const FolderWithScan with;
  ConstraintList list = readConstraints(with.folder.path() / "list.json");
  const OnMesh* slide = guideMeshOf(list.constraints[0]);
  ASSERT_NE(slide, nullptr);
  ASSERT_NE(slide->surface, nullptr);
  EXPECT_EQ(slide->surface, guideMeshOf(list.constraints[1])->surface) << "a file is read once";
  EXPECT_TRUE(std::filesystem::path(slide->path).is_absolute());
  const ConstraintList relative = withGuidePathsFrom(list, with.folder.path() / "other");
  EXPECT_THAT(constraintsToJson(relative), HasSubstr(R"("on": {"mesh": "../scans/scan.off"})"));
  EXPECT_THAT(constraintsToJson(relative), HasSubstr(R"("within": {"slab": [null, 0.5]})"));
  EXPECT_THAT(constraintsToJson(relative), HasSubstr("\"version\": 2"));
  EXPECT_EQ(readStatedConstraints(with.folder.path() / "list.json").list.constraints.size(), 2U);
}

TEST(OnMeshInFiles, NamesTheMeshThatIsMissing)
{
  const FolderWithScan with;
  std::filesystem::remove(with.folder.path() / "scans/scan.off");
  try {
    static_cast<void>(readConstraints(with.folder.path() / "list.json"));
    ADD_FAILURE() << "a constraint on a missing mesh is read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("constraints[0].on.mesh"));
    EXPECT_THAT(error.what(), HasSubstr("scans/scan.off"));
    EXPECT_THAT(error.what(), HasSubstr("disable the constraint"));
  }
}

TEST(OnMeshInFiles, KeepsDisabledConstraintsWhoseMeshIsMissing)
{
  const FolderWithScan with;
  ConstraintList list = readConstraints(with.folder.path() / "list.json");
  for (Constraint& constraint : list.constraints) constraint.isEnabled = false;
  std::ofstream(with.folder.path() / "list.json") << constraintsToJson(list);
  std::filesystem::remove(with.folder.path() / "scans/scan.off");
  list = readConstraints(with.folder.path() / "list.json");
  ASSERT_EQ(list.constraints.size(), 2U);
  EXPECT_EQ(guideMeshOf(list.constraints[0])->surface, nullptr);
  EXPECT_THAT(constraintsToJson(list), HasSubstr("scan.off"));
}

TEST(OnMeshInFiles, MovesWithItsSession)
{
  const FolderWithScan with;
  SessionFile session;
  session.mesh = {"plate.off", "", ""};
  session.document.list = readConstraints(with.folder.path() / "list.json");
  session.document.annotations = std::make_shared<const Annotations>();
  std::filesystem::create_directory(with.folder.path() / "sessions");
  const std::filesystem::path path = with.folder.path() / "sessions/s.holdfast";
  writeSession(path, session);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, HasSubstr(R"("mesh": "../scans/scan.off")"));
  SessionFile again = readSession(path);
  EXPECT_NE(guideMeshOf(again.document.list.constraints[0])->surface, nullptr);
}

}  // namespace
}  // namespace holdfast
