// Selections with rings of vertices around them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/deform/deform.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

Selection withRings(std::vector<Index> vertices, Index rings)
{
  return {Grown{std::make_shared<const Selection>(Selection{VertexIds{std::move(vertices)}}), rings}};
}

std::vector<Index> selectedOn(const Mesh& mesh, const Selection& selection)
{
  const Model model = makeModel(mesh, "mesh");
  return Selector(model.mesh, model.solverMesh, model.locator()).select(selection, {"list", 0, "select"});
}

/// All that a chain of no more than `rings` triangles reaches, triangle by triangle.
std::vector<Index> reached(const Mesh& mesh, const std::vector<Index>& vertices, Index rings)
{
  std::vector<bool> isIn(static_cast<std::size_t>(mesh.vertexCount()), false);
  for (const Index v : vertices) isIn[v] = true;
  for (Index ring = 0; ring < rings; ++ring) {
    const std::vector<bool> before = isIn;
    for (Index f = 0; f < mesh.faces.size(); ++f)
      for (const Index corner : mesh.faces[f])
        if (before[corner])
          for (const Index other : mesh.faces[f]) isIn[other] = true;
  }
  std::vector<Index> result;
  for (std::size_t v = 0; v < isIn.size(); ++v)
    if (isIn[v]) result.push_back(static_cast<Index>(v));
  return result;
}

TEST(GrownSelections, HaveAllThatSoManyEdgesReach)
{
  for (const Mesh& mesh : {test::plate(9, 7), test::icosphere(2), test::merged(test::grid(3, 3), test::icosphere(1))})
    for (const Index rings : {0, 1, 2, 3, 100}) {
      EXPECT_EQ(selectedOn(mesh, withRings({3}, rings)), reached(mesh, {3}, rings));
      EXPECT_EQ(selectedOn(mesh, withRings({0, 12}, rings)), reached(mesh, {0, 12}, rings));
    }
}

TEST(GrownSelections, TakeAllCopiesOfAVertex)
{
  const Mesh grid = test::grid(4, 4);
  const Mesh soup = test::soup(grid);
  // A corner of the soup is a vertex of the grid: the same places have to be selected.
  const std::vector<Index> ofGrid = selectedOn(grid, withRings({grid.faces[5][0]}, 1));
  std::vector<Index> expected;
  for (Index v = 0; v < soup.vertexCount(); ++v)
    for (const Index w : ofGrid)
      if (soup.positions.row(v) == grid.positions.row(w)) expected.push_back(v);
  EXPECT_EQ(selectedOn(soup, withRings({15}, 1)), expected);
}

TEST(GrownSelections, AreThoseOfTheKeyRings)
{
  const auto fixedWith = [](const std::string& keys) {
    return parseConstraintsJson(
        R"({"format": "holdfast-constraints", "version": 2, "constraints": [{"type": "fixed", "select": {"vertices": )"
        "[3]}" +
            keys + "}]}",
        "f.json");
  };
  const ConstraintList list = fixedWith(R"(, "rings": 2)");
  EXPECT_EQ(std::get<FixedConstraint>(list.constraints.front().what).select, withRings({3}, 2));
  EXPECT_THAT(constraintsToJson(list), HasSubstr(R"("select": {"vertices": [3]}, "rings": 2)"));
  EXPECT_THAT(constraintsToJson(list), HasSubstr(R"("version": 2)"));
  const ConstraintList none = fixedWith(R"(, "rings": 0)");
  EXPECT_EQ(std::get<FixedConstraint>(none.constraints.front().what).select, Selection{VertexIds{{3}}});
  EXPECT_THAT(constraintsToJson(none), HasSubstr(R"("version": 1)"));
}

TEST(GrownSelections, KeepTheTangentsOfABorder)
{
  const Mesh mesh = test::grid(12, 6);
  const Index last = mesh.vertexCount() - 1;
  std::vector<Index> border;
  for (Index v = 0; v <= 6; ++v) border.push_back(13 * v);
  const auto rimMoves = [&](Index rings) {
    const DeformResult result = test::deformed(
        mesh,
        test::listOf({{"", true, FixedConstraint{withRings(border, rings)}}, test::moveBy(AtVertex{last}, {0, 0, 3})}),
        {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok);
    return std::abs(result.positions(border[3] + 1, 2));
  };
  EXPECT_GT(rimMoves(0), 1e-3) << "the surface leaves the border in another direction";
  EXPECT_EQ(rimMoves(1), 0);
}

TEST(GrownSelections, ThatListVerticesWithTargetsAreRefused)
{
  HandleConstraint handle{withRings({1, 2, 3}, 1), VertexTargets{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {}, {}};
  try {
    static_cast<void>(test::deformed(test::grid(3, 3), test::listOf({{"tip", true, handle}}), {}));
    FAIL() << "rings have no targets";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("select by \"vertices\""));
  }
}

}  // namespace
}  // namespace holdfast
