// Places that constraints name by `near`: how far they are from the surface, what they may have been meant to be, and
// from which side.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Finding* placeFinding(const Report& report, const std::string& kind)
{
  const auto found = std::ranges::find(report.mesh.findings, kind, &Finding::kind);
  return found == report.mesh.findings.end() ? nullptr : &*found;
}

/// A body of different size along each axis, 10 x 20 x 30, around the origin but not about it.
const Vector3 kCorner(-3, -4, -7);

Model blockModel()
{
  return makeModel(test::moved(test::box(Vector3(10, 20, 30), 4), kCorner), "block");
}

/// A place by its distances from the lowest corner.
Vector3 fromCorner(double x, double y, double z)
{
  return Vector3(x, y, z) + kCorner;
}

/// Places on its surface, all different under any swap or mirror.
std::vector<Vector3> placesOnBlock()
{
  return {fromCorner(1, 2, 30), fromCorner(10, 13, 4), fromCorner(3, 20, 21), fromCorner(0, 7, 11),
          fromCorner(8, 0, 23)};
}

ConstraintList pointsNear(const std::vector<Vector3>& places)
{
  std::vector<Constraint> points;
  for (const Vector3& place : places) points.push_back(test::moveBy(AtNear{place}, {0, 0, 0.5}));
  return test::listOf(points);
}

TEST(NearPlaces, SayHowFarTheyAreFromTheSurface)
{
  ConstraintList list =
      test::listOf({test::moveBy(AtNear{fromCorner(5, 5, 30.25)}, {0, 0, 1}), test::moveBy(AtVertex{0}, {0, 0, 0})});
  list.constraints.push_back(
      {"r", true,
       RelativeConstraint{AtNear{fromCorner(5, 5, -0.125)}, AtNear{fromCorner(10.3, 3, 3)}, Vector3(0, 0, 1)}});
  list.constraints.push_back({"off", false, PointConstraint{AtNear{fromCorner(5, 5, 31)}, Move{{0, 0, 1}}}});
  for (const Report& report : {diagnoseConstraints(blockModel(), list), deform(blockModel(), list).report}) {
    EXPECT_NEAR(report.constraints[0].nearDistance.value(), 0.25, 1e-12);
    EXPECT_FALSE(report.constraints[1].nearDistance) << "it names no place";
    EXPECT_NEAR(report.constraints[2].nearDistance.value(), 0.3, 1e-12) << "the larger of two";
    EXPECT_FALSE(report.constraints[3].nearDistance) << "it is disabled";
    EXPECT_EQ(placeFinding(report, "places_off_surface"), nullptr);
  }
}

TEST(NearPlaces, FartherThanTheLimitAreAFindingWithTheirNames)
{
  DeformOptions options;
  const ConstraintList list = pointsNear({fromCorner(5, 5, 30.3), fromCorner(5, 5, 30.35), fromCorner(5, 5, 30)});
  EXPECT_EQ(placeFinding(diagnoseConstraints(blockModel(), list, "c", options), "places_off_surface"), nullptr)
      << "a hundredth of the diagonal is 0.37";
  const Report beyond = diagnoseConstraints(
      blockModel(), pointsNear({fromCorner(5, 5, 30.3), fromCorner(5, 5, 31), fromCorner(5, 5, 30)}), "c", options);
  ASSERT_NE(placeFinding(beyond, "places_off_surface"), nullptr);
  EXPECT_THAT(placeFinding(beyond, "places_off_surface")->ids, ElementsAre(1));
  EXPECT_EQ(placeFinding(beyond, "places_off_surface")->idsOf, "constraint");
  options.nearLimit = 0.001;
  EXPECT_THAT(placeFinding(diagnoseConstraints(blockModel(), list, "c", options), "places_off_surface")->ids,
              ElementsAre(0, 1));
  options.nearLimit = 0.1;
  EXPECT_EQ(placeFinding(diagnoseConstraints(blockModel(), list, "c", options), "places_off_surface"), nullptr);
}

/// What the finding says that `change` of places on the surface may have been.
template <class Change>
std::string guessAfter(const Change& change)
{
  std::vector<Vector3> places = placesOnBlock();
  for (Vector3& place : places) place = change(place);
  const Report report = deform(blockModel(), pointsNear(places)).report;
  const Finding* const finding = placeFinding(report, "places_off_surface");
  return finding == nullptr ? "none" : finding->message;
}

TEST(NearPlaces, InAnotherUnitOrWithOtherAxesAreGuessed)
{
  EXPECT_EQ(guessAfter([](const Vector3& p) { return p; }), "none");
  EXPECT_THAT(guessAfter([](const Vector3& p) -> Vector3 { return p / 1000; }),
              HasSubstr("multiplied by 1000, as from m to mm"));
  EXPECT_THAT(guessAfter([](const Vector3& p) -> Vector3 { return p * 10; }),
              HasSubstr("multiplied by 0.1, as from mm to cm"));
  EXPECT_THAT(guessAfter([](const Vector3& p) -> Vector3 { return p / 25.4; }), HasSubstr("from inches to mm"));
  EXPECT_THAT(guessAfter([](const Vector3& p) { return Vector3(p.y(), p.x(), p.z()); }),
              HasSubstr("with y, x, z for x, y, z"));
  EXPECT_THAT(guessAfter([](const Vector3& p) { return Vector3(p.z(), p.x(), p.y()); }),
              HasSubstr("with y, z, x for x, y, z"));
  EXPECT_THAT(guessAfter([](const Vector3& p) { return Vector3(p.x(), -p.y(), p.z()); }),
              HasSubstr("with the sign of y changed"));
  EXPECT_THAT(guessAfter([](const Vector3& p) -> Vector3 { return Vector3(-p.y(), p.x(), p.z()) / 1000; }),
              testing::AllOf(HasSubstr("multiplied by 1000"), HasSubstr("with y, x, z"), HasSubstr("sign of y")));
  EXPECT_THAT(guessAfter([](const Vector3& p) -> Vector3 { return p + Vector3(100, 3, 5); }),
              HasSubstr("check its unit"));
}

TEST(NearPlaces, AllInOneSpotBecauseOfTheirUnitAreAFinding)
{
  const Model cornered = makeModel(test::box(Vector3(10, 20, 30), 4), "block with a corner at the origin");
  std::vector<Vector3> places{{1, 2, 30}, {10, 13, 4}, {3, 20, 21}, {0, 7, 11}, {8, 0, 23}};
  const auto spot = [&] {
    const Report report = deform(cornered, pointsNear(places)).report;
    const Finding* const finding = placeFinding(report, "places_in_one_spot");
    return finding == nullptr ? "none" : finding->message;
  };
  EXPECT_EQ(spot(), "none");
  for (Vector3& place : places) place /= 1000;
  EXPECT_THAT(spot(), HasSubstr("multiplied by 1000, as from m to mm"));
  places = {{5, 5, 30}, {5.1, 5, 30}, {5, 5.1, 30}};
  EXPECT_EQ(spot(), "none") << "a small area was measured";
}

TEST(NearPlaces, InTheMiddleOfAThinSheetAreAFinding)
{
  const Model sheet = makeModel(test::box(Vector3(100, 80, 1), 6), "sheet");
  const auto between = [&](const std::vector<Vector3>& places) {
    const Report report = deform(sheet, pointsNear(places)).report;
    const Finding* const finding = placeFinding(report, "places_between_sides");
    return finding == nullptr ? std::vector<Index>() : finding->ids;
  };
  EXPECT_THAT(between({{40, 40, 0.5}, {20, 20, 1}, {30, 30, 0.45}, {60, 60, 0.6}}), ElementsAre(0, 2, 3));
  EXPECT_THAT(between({{40, 40, 0.2}, {20, 20, 0.9}, {30, 30, 1.2}, {60, 60, -0.3}}), IsEmpty())
      << "one side is nearer";
  EXPECT_THAT(between({{40, 40, 1 + 1e-13}, {99.8, 40, 0.8}}), IsEmpty()) << "on the surface, and at an edge";
  const Model gap = makeModel(
      test::merged(test::box(Vector3(50, 50, 20), 3), test::moved(test::box(Vector3(50, 50, 20), 3), {0, 0, 20.5})),
      "slot");
  const Report slot = deform(gap, pointsNear({{25, 25, 20.25}})).report;
  EXPECT_NE(placeFinding(slot, "places_between_sides"), nullptr) << "a slot has two sides as well";
}

TEST(NearPlaces, AreLookedAtAgainWhereTheyChange)
{
  Deformer deformer(blockModel());
  const auto isFar = [&](const Vector3& place) {
    return placeFinding(deformer.deform(pointsNear({place})).report, "places_off_surface") != nullptr;
  };
  EXPECT_FALSE(isFar(fromCorner(5, 5, 30)));
  EXPECT_TRUE(isFar(fromCorner(5, 5, 40)));
  EXPECT_TRUE(isFar(fromCorner(5, 5, 40)));
  EXPECT_FALSE(isFar(fromCorner(5, 5, 30)));
}

TEST(WeldedWithin, ASeamMovesAsOneAndKeepsItsPlacesAtRest)
{
  const double gap = 1e-9;
  const Mesh mesh = test::merged(test::grid(2, 2), test::moved(test::grid(2, 2), {2 + gap, 0, 0}));
  const Model model = makeModel(mesh, "seam", 1e-8);
  EXPECT_EQ(model.solverMesh.componentCount, 1);
  const std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
  const DeformResult same = deform(model, test::listOf({test::hold(all)}));
  EXPECT_EQ(same.report.solve.status, SolveStatus::Ok);
  EXPECT_EQ(same.positions, mesh.positions) << "both sides keep their own";
  const DeformResult bent =
      deform(model, test::listOf({test::hold({0, 3, 6}), test::handle({11, 14, 17}, std::monostate{}, {0, 0, 5}),
                                  test::moveBy(AtVertex{12}, {0, 0, 2})}));
  EXPECT_EQ(bent.report.solve.status, SolveStatus::Ok);
  for (const auto& [left, right] : {std::pair(2, 9), {5, 12}, {8, 15}})
    EXPECT_LT((bent.positions.row(left) - bent.positions.row(right)).norm(), 2 * gap);
  EXPECT_GT(bent.positions(2, 2), 0.5);
  const DeformResult torn = deform(
      makeModel(mesh), test::listOf({test::hold({0, 3, 6}), test::handle({11, 14, 17}, std::monostate{}, {0, 0, 5})}));
  EXPECT_GT((torn.positions.row(2) - torn.positions.row(9)).norm(), 4) << "without a tolerance it tears";
}

TEST(WeldedWithin, HandlesAndRegionsOfBothSidesAgree)
{
  const Mesh mesh = test::merged(test::grid(2, 2), test::moved(test::grid(2, 2), {2 + 1e-4, 0, 0}));
  const Model model = makeModel(mesh, "seam", 1e-3);
  const AxisRotation turn{Vector3(0, 1, 0), 70, std::nullopt};
  const DeformResult result =
      deform(model, test::listOf({test::hold({0, 3, 6}), test::handle({2, 5, 8, 9, 12, 15}, turn, {0, 0, 1})}));
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
}

TEST(WeldedWithin, MoreThanAHundredthOfTheDiagonalIsRefused)
{
  EXPECT_THROW(static_cast<void>(makeModel(test::grid(4, 4), "m", 0.06)), InputError);
  EXPECT_NO_THROW(static_cast<void>(makeModel(test::grid(4, 4), "m", 0.05)));
}

}  // namespace
}  // namespace holdfast
