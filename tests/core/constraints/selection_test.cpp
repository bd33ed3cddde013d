#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraints/selection.h>

#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Selection complement(Selection selection)
{
  return {NotIn{std::make_shared<const Selection>(std::move(selection))}};
}

/// A lattice of integer points, so that boundaries are met exactly, in three parts and some loose vertices.
struct Scene {
  Positions positions{216, 3};
  std::vector<int> componentOf;

  Scene()
  {
    for (int v = 0; v < 216; ++v) {
      positions.row(v) = Eigen::RowVector3i(v % 6, v / 6 % 6, v / 36).cast<double>();
      componentOf.push_back(v % 7 == 0 ? -1 : v % 3);
    }
  }

  [[nodiscard]] std::vector<Index> ids(const Selection& selection) const
  {
    return select(selection, positions, componentOf);
  }
};

/// Membership of one vertex by the definition, number by number.
struct Contains {
  const Scene& scene;
  Index v;

  [[nodiscard]] double p(int axis) const { return scene.positions(v, axis); }
  bool operator()(const VertexIds& s) const { return std::count(s.ids.begin(), s.ids.end(), v) > 0; }
  bool operator()(const InBox& s) const
  {
    for (int axis = 0; axis < 3; ++axis)
      if (p(axis) < s.min[axis] || p(axis) > s.max[axis]) return false;
    return true;
  }
  bool operator()(const InSphere& s) const
  {
    return std::hypot(p(0) - s.center[0], p(1) - s.center[1], p(2) - s.center[2]) <= s.radius;
  }
  bool operator()(const InHalfSpace& s) const
  {
    double side = 0;
    for (int axis = 0; axis < 3; ++axis) side += (p(axis) - s.point[axis]) * s.normal[axis];
    return side >= 0;
  }
  bool operator()(const InComponent& s) const { return scene.componentOf[v] == s.component; }
  bool operator()(const InsideCurve& /*curve*/) const { return false; }  // of meshes with faces only
  bool operator()(const Grown& /*grown*/) const { return false; }        // likewise
  bool operator()(const AllOf& s) const
  {
    for (const Selection& part : s.parts)
      if (!std::visit(*this, part.what)) return false;
    return true;
  }
  bool operator()(const AnyOf& s) const
  {
    for (const Selection& part : s.parts)
      if (std::visit(*this, part.what)) return true;
    return false;
  }
  bool operator()(const NotIn& s) const { return !std::visit(*this, s.part->what); }
};

std::vector<Index> bruteForce(const Scene& scene, const Selection& selection)
{
  std::vector<Index> ids;
  for (Index v = 0; v < scene.positions.rows(); ++v)
    if (std::visit(Contains{scene, v}, selection.what)) ids.push_back(v);
  return ids;
}

Vector3 latticePoint(test::Random& random)
{
  const auto coordinate = [&] { return static_cast<double>(random.integer(-1, 6)); };
  return {coordinate(), coordinate(), coordinate()};
}

Selection randomExpression(test::Random& random, int depth);

std::vector<Selection> randomExpressions(test::Random& random, int depth)
{
  std::vector<Selection> parts;
  for (long i = random.integer(0, 3); i > 0; --i) parts.push_back(randomExpression(random, depth));
  return parts;
}

Selection randomExpression(test::Random& random, int depth)
{
  switch (random.integer(0, depth > 0 ? 7 : 4)) {
    case 0:
      return {VertexIds{{random.integer(0, 215), random.integer(0, 215), random.integer(0, 215)}}};
    case 1: {
      const Vector3 a = latticePoint(random);
      const Vector3 b = latticePoint(random);
      return {InBox{a.cwiseMin(b), a.cwiseMax(b)}};
    }
    case 2:
      return {InSphere{latticePoint(random), static_cast<double>(random.integer(1, 5))}};
    case 3:
      return {InHalfSpace{latticePoint(random), latticePoint(random) + Vector3(0, 0, 8)}};
    case 4:
      return {InComponent{random.integer(0, 3)}};
    case 5:
      return {AllOf{randomExpressions(random, depth - 1)}};
    case 6:
      return {AnyOf{randomExpressions(random, depth - 1)}};
    default:
      return complement(randomExpression(random, depth - 1));
  }
}

TEST(Selection, AgreesWithMembershipVertexByVertex)
{
  const Scene scene;
  test::Random random(101);
  for (int i = 0; i < 500; ++i) {
    const Selection selection = randomExpression(random, 4);
    ASSERT_EQ(scene.ids(selection), bruteForce(scene, selection)) << "expression " << i;
  }
}

TEST(Selection, ObeysDeMorgansLaws)
{
  const Scene scene;
  test::Random random(102);
  for (int i = 0; i < 200; ++i) {
    const Selection a = randomExpression(random, 2);
    const Selection b = randomExpression(random, 2);
    EXPECT_EQ(scene.ids(complement({AllOf{{a, b}}})), scene.ids({AnyOf{{complement(a), complement(b)}}}));
    EXPECT_EQ(scene.ids(complement({AnyOf{{a, b}}})), scene.ids({AllOf{{complement(a), complement(b)}}}));
    EXPECT_EQ(scene.ids(complement(complement(a))), scene.ids(a));
  }
}

TEST(Selection, NamesEachVertexOnceInAscendingOrder)
{
  const Scene scene;
  EXPECT_THAT(scene.ids({VertexIds{{9, 3, 9, 3, 5}}}), ElementsAre(3, 5, 9));
}

TEST(Selection, BoxHoldsItsFacesEdgesAndCornersAndNothingPastThem)
{
  Positions positions(6, 3);
  const double above = std::nextafter(1.0, 2.0);
  positions << 1, 1, 1, 0, 0, 0, 1, 0.5, 0, above, 1, 1, 0, 0, -std::numeric_limits<double>::min(), 0.5, 0.5, 0.5;
  const Selection unitBox{InBox{Vector3::Zero(), Vector3::Ones()}};
  EXPECT_THAT(select(unitBox, positions, {}), ElementsAre(0, 1, 2, 5));
}

TEST(Selection, FlatBoxHoldsThePlaneItIs)
{
  const Mesh mesh = test::box(Vector3(1, 1, 1), 2);
  const Selection bottom{InBox{Vector3(-1, -1, 0), Vector3(2, 2, 0)}};
  EXPECT_EQ(select(bottom, mesh.positions, {}).size(), 9U);
}

TEST(Selection, SphereHoldsItsSurface)
{
  Positions positions(4, 3);
  positions << 0.1, 0, 0, 0, -0.06, 0.08, 0, 0, std::nextafter(0.1, 1.0), 0, 0, 0;
  EXPECT_THAT(select({InSphere{Vector3::Zero(), 0.1}}, positions, {}), ElementsAre(0, 1, 3));
}

TEST(Selection, HalfSpaceHoldsItsPlaneWhateverTheLengthOfTheNormal)
{
  const Scene scene;
  const Vector3 direction(3, -1, 7);
  const std::vector<Index> expected = bruteForce(scene, {InHalfSpace{Vector3(2, 3, 1), direction}});
  ASSERT_THAT(expected, testing::Contains(2 + 6 * 3 + 36 * 1));
  for (const double scale : {0x1p-1073, 0x1p-700, 0.125, 3.0, 0x1p1020})
    EXPECT_EQ(scene.ids({InHalfSpace{Vector3(2, 3, 1), scale * direction}}), expected) << scale;
}

TEST(Selection, OppositeHalfSpacesShareTheirPlaneOnly)
{
  const Scene scene;
  const Selection up{InHalfSpace{Vector3(0, 0, 2), Vector3(0, 0, 1)}};
  const Selection down{InHalfSpace{Vector3(0, 0, 2), Vector3(0, 0, -1)}};
  EXPECT_EQ(scene.ids({AllOf{{up, down}}}), scene.ids({InBox{Vector3(-1, -1, 2), Vector3(9, 9, 2)}}));
  EXPECT_EQ(scene.ids({AnyOf{{up, down}}}).size(), 216U);
}

TEST(Selection, VertexThatNoFaceUsesIsInNoComponent)
{
  const Positions positions = Positions::Zero(4, 3);
  const std::vector<int> componentOf{0, -1, 1, 0};
  EXPECT_THAT(select({InComponent{0}}, positions, componentOf), ElementsAre(0, 3));
  EXPECT_THAT(select({InComponent{1}}, positions, componentOf), ElementsAre(2));
  EXPECT_THAT(select({InComponent{2}}, positions, componentOf), IsEmpty());
}

TEST(Selection, AllOfNothingIsEverythingAndAnyOfNothingIsNothing)
{
  const Scene scene;
  EXPECT_EQ(scene.ids({AllOf{}}).size(), 216U);
  EXPECT_THAT(scene.ids({AnyOf{}}), IsEmpty());
}

TEST(Selection, OfAMeshWithoutVerticesIsEmpty)
{
  EXPECT_THAT(select({AllOf{}}, Positions(0, 3), {}), IsEmpty());
  EXPECT_THAT(select({InBox{}}, Positions(0, 3), {}), IsEmpty());
}

}  // namespace
}  // namespace holdfast
