#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::hold;
using test::moveBy;
using testing::HasSubstr;

Constraint held(Selection selection)
{
  return {"", true, FixedConstraint{std::move(selection)}};
}

Selection ids(std::vector<Index> vertices)
{
  return {VertexIds{std::move(vertices)}};
}

struct BadConstraint {
  const char* name;
  Constraint constraint;
  const char* element;
  std::vector<const char*> words;
};

void PrintTo(const BadConstraint& bad, std::ostream* out)
{
  *out << bad.name;
}

std::vector<BadConstraint> badConstraints()
{
  const Vector3 up(0, 0, 1);
  const AllOf nested{{ids({0}), {AnyOf{{ids({1}), {NotIn{std::make_shared<const Selection>(ids({25}))}}}}}}};
  return {
      {"VertexTooLarge", moveBy(AtVertex{9}, up), ".at.vertex", {"no vertex 9", "9 vertices"}},
      {"VertexNegative", moveBy(AtVertex{-1}, up), ".at.vertex", {"no vertex -1"}},
      {"FirstEndOfEdge", moveBy(AtEdge{9, 0, 0.5}, up), ".at.edge[0]", {"no vertex 9"}},
      {"SecondEndOfEdge", moveBy(AtEdge{0, -7, 0.5}, up), ".at.edge[1]", {"no vertex -7"}},
      {"NoSuchEdge", moveBy(AtEdge{0, 8, 0.5}, up), ".at.edge", {"edge between the vertices 0 and 8", "near"}},
      {"EdgeToItself", moveBy(AtEdge{4, 4, 0.5}, up), ".at.edge", {"edge between the vertices 4 and 4"}},
      {"FaceTooLarge", moveBy(AtFace{8, {1, 0, 0}}, up), ".at.face", {"no face 8", "8 faces"}},
      {"FaceNegative", moveBy(AtFace{-1, {1, 0, 0}}, up), ".at.face", {"no face -1"}},
      {"TooFewWeights", moveBy(AtFace{0, {0.5, 0.5}}, up), ".at.weights", {"3 corners", "2 weights"}},
      {"TooManyWeights", moveBy(AtFace{0, {0.5, 0.5, 0, 0}}, up), ".at.weights", {"3 corners", "4 weights"}},
      {"SelectedVertex", hold({3, 9}), ".select.vertices", {"no vertex 9"}},
      {"SelectedVertexDeepInside", held({nested}), ".select.all[1].any[1].not.vertices", {"no vertex 25"}},
      {"NoVertexNamed", hold({}), ".select", {"selects no vertex"}},
      {"EmptyBox", held({InBox{{5, 5, 5}, {6, 6, 6}}}), ".select", {"selects no vertex"}},
      {"NoSuchPart", held({InComponent{1}}), ".select.component", {"no part 1", "1 connected parts"}},
      {"NegativePart", held({InComponent{-1}}), ".select.component", {"no part -1"}},
      {"EmptyHandle", {"", true, HandleConstraint{{AnyOf{}}, {}, up, {}}}, ".select", {"selects no vertex"}},
  };
}

class ConstraintSystemError : public testing::TestWithParam<BadConstraint> {};

TEST_P(ConstraintSystemError, NamesThePlaceInTheListAndWhatIsWrong)
{
  const Mesh mesh = test::grid(2, 2);
  const Triangulation triangulation = triangulate(mesh);
  ConstraintList list = test::listOf({hold({0}), GetParam().constraint});
  for (const bool isEnabled : {true, false}) {
    list.constraints[1].isEnabled = isEnabled;
    try {
      static_cast<void>(makeConstraintSystem(list, mesh, makeSolverMesh(mesh, triangulation),
                                             SurfaceLocator(mesh, triangulation), "list.json"));
      ADD_FAILURE() << "taken for good";
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, "list.json");
      EXPECT_EQ(error.location().element, std::string("constraints[1]") + GetParam().element);
      EXPECT_THAT(error.reason(), HasSubstr("\"P1\""));
      for (const char* word : GetParam().words) EXPECT_THAT(error.reason(), HasSubstr(word));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, ConstraintSystemError, testing::ValuesIn(badConstraints()),
                         [](const testing::TestParamInfo<BadConstraint>& what) { return what.param.name; });

}  // namespace
}  // namespace holdfast
