#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deform.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::moveTo;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A square and a vertex that no face uses, whose coordinates are not finite.
Mesh squareAndVertexWithoutPlace()
{
  Mesh mesh{Positions(5, 3), {}};
  mesh.positions << 0, 0, 0, kNan, 0, std::numeric_limits<double>::infinity(), 1, 0, 0, 1, 1, 0, 0, 1, 0;
  mesh.faces.add({0, 2, 3, 4});
  return mesh;
}

Constraint fixedAt(Selection select)
{
  return {"held", true, FixedConstraint{std::move(select)}};
}

std::string refusalOf(const Constraint& constraint)
{
  try {
    static_cast<void>(deform(makeModel(squareAndVertexWithoutPlace()), test::listOf({constraint}), "list"));
    return "taken";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(VerticesWithoutPlace, TakeNoPartInADeformation)
{
  const Mesh mesh = squareAndVertexWithoutPlace();
  const ConstraintList list = test::listOf({fixedAt({VertexIds{{0, 2}}}), moveTo(AtVertex{3}, {1, 1, 0.5})});
  const DeformResult result = deform(makeModel(mesh), list, "list");
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_EQ(result.positions.row(3).transpose(), Vector3(1, 1, 0.5));
  EXPECT_TRUE(result.positions.allFinite());
}

TEST(VerticesWithoutPlace, AreInNoSelectionByPlace)
{
  const Mesh mesh = squareAndVertexWithoutPlace();
  const double far = 1e9;
  for (const Selection& select :
       {Selection{InBox{Vector3::Constant(-far), Vector3::Constant(far)}}, Selection{InSphere{Vector3::Zero(), far}},
        Selection{NotIn{std::make_shared<Selection>(Selection{InSphere{{far, 0, 0}, 1}})}}}) {
    const DeformResult result = deform(makeModel(mesh), test::listOf({fixedAt(select)}), "list");
    EXPECT_EQ(result.report.constraints[0].rows, 4);
  }
}

TEST(VerticesWithoutPlace, CannotBeNamedByConstraints)
{
  EXPECT_THAT(refusalOf(fixedAt({VertexIds{{0, 1}}})), HasSubstr("vertex 1 has no place"));
  EXPECT_THAT(refusalOf(moveTo(AtVertex{1}, {0, 0, 0})), HasSubstr("vertex 1 has no place"));
  EXPECT_EQ(refusalOf(moveTo(AtVertex{2}, {1, 0, 0})), "taken");
}

TEST(FacesOfFewCorners, CannotHoldPoints)
{
  Mesh mesh = test::grid(1, 1);
  mesh.faces.add({0, 1});
  const Index last = mesh.faces.size() - 1;
  EXPECT_THROW(
      static_cast<void>(deform(makeModel(mesh), test::listOf({moveTo(AtFace{last, {0.5, 0.5}}, {0, 0, 0})}), "list")),
      InputError);
}

bool hasSameBitsIn(const Positions& a, const Positions& b)
{
  for (Index k = 0; k < a.size(); ++k)
    if (!hasSameBits(a.data()[k], b.data()[k])) return false;
  return a.size() == b.size();
}

/// Two squares that share the edge in x = 0, where one has 0 and the other -0.
Mesh squaresWithBothZeros(double first)
{
  Mesh mesh{Positions(8, 3), {}};
  mesh.positions << first, 0, 0, first, 1, 0, 1, 1, 0, 1, 0, 0, -first, -0.0, 0, -first, 1, -0.0, -1, 1, 0, -1, 0, 0;
  mesh.faces.add({0, 3, 2, 1});
  mesh.faces.add({4, 5, 6, 7});
  return mesh;
}

class WeldedZeros : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] Positions of(const std::vector<Constraint>& constraints) const
  {
    return deform(makeModel(mesh_), test::listOf(constraints), "list").positions;
  }

  Mesh mesh_ = squaresWithBothZeros(GetParam());
};

TEST_P(WeldedZeros, KeepTheirSignsWhereAllIsFixed)
{
  EXPECT_TRUE(hasSameBitsIn(of({fixedAt({InComponent{0}})}), mesh_.positions));
}

TEST_P(WeldedZeros, KeepTheirSignsWhereOneOfThemIsFixed)
{
  for (const Index v : {0, 4}) EXPECT_TRUE(hasSameBitsIn(of({fixedAt({VertexIds{{v}}})}), mesh_.positions)) << v;
}

TEST_P(WeldedZeros, KeepTheirSignsUnderAPointThatStays)
{
  EXPECT_TRUE(hasSameBitsIn(of({moveTo(AtVertex{4}, mesh_.positions.row(4))}), mesh_.positions));
}

TEST_P(WeldedZeros, GoTogetherWhereTheyMove)
{
  const Positions positions = of({moveTo(AtVertex{0}, {0.25, 0.5, 0})});
  EXPECT_EQ(positions.row(0), positions.row(4));
  EXPECT_EQ(positions(4, 0), 0.25);
}

TEST_P(WeldedZeros, GiveTheFileBackByteForByte)
{
  std::string text = "OFF\n8 2 0\n";
  for (Index v = 0; v < 8; ++v)
    text += fmt::format("{} {} {}\n", mesh_.positions(v, 0), mesh_.positions(v, 1), mesh_.positions(v, 2));
  text += "4 0 3 2 1\n4 4 5 6 7\n";
  const MeshDocument document = readOff(text, "");
  const DeformResult result = deform(makeModel(document.mesh), test::listOf({fixedAt({InComponent{0}})}), "list");
  EXPECT_EQ(document.source->withPositions(document.mesh, result.positions).bytes, text);
}

INSTANTIATE_TEST_SUITE_P(First, WeldedZeros, testing::Values(0.0, -0.0));

}  // namespace
}  // namespace holdfast
