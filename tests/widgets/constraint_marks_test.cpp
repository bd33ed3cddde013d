#include <algorithm>

#include <gtest/gtest.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "widgets/lab_color.h"

namespace holdfast {
namespace {

using test::LabColor;
using test::toLab;

/// One constraint of every kind on a grid of 4 x 4 squares, the last ones disabled.
ConstraintList everyKind()
{
  return {"",
          {{"hold", true, FixedConstraint{{VertexIds{{0, 1}}}}},
           {"body", true, RigidConstraint{{VertexIds{{11, 12}}}}},
           {"vertex", true, PointConstraint{AtVertex{24}, Move{{0, 0, 1}}}},
           {"edge", true, PointConstraint{AtEdge{20, 21, 0.5}, Move{{0, 0, 1}}}},
           {"face", true, PointConstraint{AtFace{9, {0.25, 0.25, 0.5}}, Move{{0, 0, 0.5}}}},
           {"apart", true, RelativeConstraint{AtVertex{14}, AtVertex{10}, {}}},
           {"off face", false, PointConstraint{AtFace{2, {0.25, 0.25, 0.5}}, Target{{9, 9, 9}}}},
           {"off hold", false, FixedConstraint{{VertexIds{{3, 4}}}}},
           {"off apart", false, RelativeConstraint{AtVertex{4}, AtVertex{0}, {}}}}};
}

struct Solved {
  Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list = everyKind();
  DeformResult deformation = solved();

  [[nodiscard]] DeformResult solved() const
  {
    NoProgress progress;
    return deform(model, list, "constraints", {}, progress);
  }
};

std::vector<ConstraintMark> marksOf(const std::vector<ConstraintMark>& marks, Index constraint)
{
  std::vector<ConstraintMark> own;
  std::copy_if(marks.begin(), marks.end(), std::back_inserter(own),
               [&](const ConstraintMark& mark) { return mark.constraint == constraint; });
  return own;
}

TEST(ConstraintMarkKinds, AreThoseOfThePlaces)
{
  const Solved solved;
  const auto marks = constraintMarks(solved.model, solved.deformation);
  const std::array kinds{MarkKind::Selection, MarkKind::Rigid, MarkKind::Vertex,
                         MarkKind::Edge,      MarkKind::Face,  MarkKind::Relative};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto own = marksOf(marks, static_cast<Index>(k));
    ASSERT_FALSE(own.empty()) << k;
    for (const ConstraintMark& mark : own) EXPECT_EQ(mark.kind, kinds[k]) << k;
  }
  EXPECT_EQ(marks.size(), 2 + 1 + 4);
}

TEST(ConstraintMarkKinds, RelativeOnesKnowTheirOtherPlace)
{
  const Solved solved;
  const auto mark = marksOf(constraintMarks(solved.model, solved.deformation), 5).front();
  ASSERT_TRUE(mark.other);
  EXPECT_EQ(*mark.other, Vector3(solved.deformation.positions.row(10)));
  EXPECT_EQ(mark.place, Vector3(solved.deformation.positions.row(14)));
  EXPECT_EQ(mark.rest, Vector3(solved.model.mesh.positions.row(14)));
}

TEST(ConstraintMarkKinds, OfEdgesLieWhereTheRestWeightsSay)
{
  const Solved solved;
  const auto mark = marksOf(constraintMarks(solved.model, solved.deformation), 3).front();
  EXPECT_EQ(mark.rest, Vector3(0.5, 4, 0));
  EXPECT_NEAR((mark.place - Vector3(0.5, 4, 1)).norm(), 0, 1e-12);
}

TEST(DisabledMarks, LieOnTheMeshAsItIs)
{
  const Solved solved;
  const auto marks = constraintMarks(solved.model, solved.list, solved.deformation);
  const auto face = marksOf(marks, 6);
  ASSERT_EQ(face.size(), 1);
  EXPECT_EQ(face[0].status, ConstraintStatus::Disabled);
  EXPECT_EQ(face[0].kind, MarkKind::Face);
  EXPECT_EQ(face[0].target, Vector3(9, 9, 9));
  const auto hold = marksOf(marks, 7);
  ASSERT_EQ(hold.size(), 2);
  EXPECT_EQ(hold[1].place, Vector3(solved.deformation.positions.row(4)));
  EXPECT_EQ(hold[1].target, hold[1].place);
  const auto apart = marksOf(marks, 8);
  ASSERT_EQ(apart.size(), 1);
  EXPECT_EQ(apart[0].other, Vector3(solved.deformation.positions.row(0)));
}

TEST(DisabledMarks, ComeAfterAllOthers)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list = test::listOf({test::moveBy(AtVertex{7}, {0, 0, 1}), test::hold({0})});
  list.constraints[0].isEnabled = false;
  const auto marks = constraintMarks(model, list, deform(model, list));
  ASSERT_EQ(marks.size(), 2);
  EXPECT_EQ(marks[0].status, ConstraintStatus::Met);
  EXPECT_EQ(marks[1].status, ConstraintStatus::Disabled);
  EXPECT_EQ(marks[1].constraint, 0);
}

TEST(DisabledMarks, AreSelectedAgainWhereTheSelectionChangesAlone)
{
  Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list = test::listOf({test::moveBy(AtVertex{7}, {0, 0, 1}), test::hold({0})});
  list.constraints[1].isEnabled = false;
  Selection& select = std::get<FixedConstraint>(list.constraints[1].what).select;
  select = {InBox{{-1, -1, -1}, {0.5, 9, 1}}};
  const DeformResult deformation = deform(model, list);
  KnownPlaces places;
  const std::size_t count = constraintMarks(model, list, deformation, places).size();
  EXPECT_GT(count, 2u);
  model.mesh.positions.array() += 50;
  EXPECT_EQ(constraintMarks(model, list, deformation, places).size(), count);
  select = {VertexIds{{0}}};
  EXPECT_EQ(constraintMarks(model, list, deformation, places).size(), 2u);
}

TEST(ConstraintMarks, OfAMirrorAreOnItsPlaneAndWhereItIsAmiss)
{
  const Model model = makeModel(test::grid(4, 3), "grid");
  ConstraintList list{"",
                      {{"left", true, PointConstraint{AtVertex{0}, Move{{0, 0, 1}}}},
                       {"right", false, PointConstraint{AtVertex{4}, Move{{0, 0, 2}}}},
                       {"mirror", true, MirrorConstraint{{2, 0, 0}, {1, 0, 0}, {}, {AllOf{}}, {}}}}};
  const auto ofMirror = [&] { return marksOf(constraintMarks(model, list, deform(model, list)), 2); };
  const auto met = ofMirror();
  EXPECT_EQ(met.size(), 4U);
  for (const ConstraintMark& mark : met) EXPECT_EQ(mark.place.x(), 2);
  list.constraints[1].isEnabled = true;
  const auto conflicting = ofMirror();
  ASSERT_EQ(conflicting.size(), 5U);
  EXPECT_EQ(std::ranges::count(conflicting, ConstraintStatus::Conflicting, &ConstraintMark::status), 1);
  list.constraints[2].isEnabled = false;
  EXPECT_TRUE(ofMirror().empty());
}

ConstraintMark dot(double x, ConstraintStatus status)
{
  ConstraintMark mark{{x, 0, 0}, {x, 0, 0}, status};
  mark.rest = mark.place;
  return mark;
}

TEST(DrawnMarks, OfLargeRegionsAreFew)
{
  std::vector<ConstraintMark> marks;
  for (int k = 0; k < 10000; ++k) marks.push_back(dot(k, ConstraintStatus::Met));
  marks[5001].status = ConstraintStatus::Conflicting;
  marks[5002].status = ConstraintStatus::Missed;
  marks[5003].kind = MarkKind::Vertex;
  const std::vector<Index> drawn = drawnMarks(marks);
  EXPECT_LT(static_cast<Index>(drawn.size()), 1.2 * kMostDots);
  EXPECT_GT(static_cast<Index>(drawn.size()), 0.3 * kMostDots);
  for (const Index k : {5001, 5002, 5003}) EXPECT_EQ(std::count(drawn.begin(), drawn.end(), k), 1) << k;
}

TEST(DrawnMarks, TheGravestAreDrawnLast)
{
  const std::vector<ConstraintMark> marks{dot(0, ConstraintStatus::Missed), dot(1, ConstraintStatus::Disabled),
                                          dot(2, ConstraintStatus::Redundant), dot(3, ConstraintStatus::Met),
                                          dot(4, ConstraintStatus::Conflicting)};
  EXPECT_EQ(drawnMarks(marks), (std::vector<Index>{1, 3, 2, 4, 0}));
}

TEST(DrawnMarks, DoNotDependOnWhereTheMeshHasMoved)
{
  std::vector<ConstraintMark> marks;
  for (int k = 0; k < 5000; ++k) marks.push_back(dot(k, ConstraintStatus::Met));
  const std::vector<Index> before = drawnMarks(marks);
  for (ConstraintMark& mark : marks) mark.place = mark.target = Vector3(1, 2, mark.rest.x() / 7);
  EXPECT_EQ(drawnMarks(marks), before);
}

TEST(GlyphColors, OfAllStatusesDiffer)
{
  const std::array all{ConstraintStatus::Independent, ConstraintStatus::Met,    ConstraintStatus::Redundant,
                       ConstraintStatus::Conflicting, ConstraintStatus::Missed, ConstraintStatus::Disabled};
  for (const ConstraintStatus a : all)
    for (const ConstraintStatus b : all) {
      if (a == b) continue;
      const LabColor p = toLab(glyphColor(a));
      const LabColor q = toLab(glyphColor(b));
      EXPECT_GT(std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b), 12) << name(a) << ", " << name(b);
    }
}

}  // namespace
}  // namespace holdfast
