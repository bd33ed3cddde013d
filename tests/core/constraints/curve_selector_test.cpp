#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraints/selector.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/numbers/disjoint_sets.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/path_lengths.h"
#include "support/random.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

InsideCurve through(const std::vector<Index>& vertices, CurveSide side = CurveSide::Smaller)
{
  InsideCurve curve{{}, side};
  for (const Index v : vertices) curve.through.emplace_back(AtVertex{v});
  return curve;
}

std::vector<Index> selected(const Mesh& mesh, const Selection& selection)
{
  const Triangulation triangulation = triangulate(mesh);
  const SolverMesh solverMesh = makeSolverMesh(mesh, triangulation);
  SurfaceLocator locator(mesh, triangulation);
  return Selector(mesh, solverMesh, locator).select(selection, {"list.json", 0, "select"});
}

/// What keeps a mesh from being divided by a curve, or why the curve is none; empty where it is one.
std::string refusal(const Mesh& mesh, const Selection& selection, const std::string& element)
{
  try {
    static_cast<void>(selected(mesh, selection));
    return "";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "list.json");
    EXPECT_EQ(error.location().element, "select" + element);
    return error.reason();
  }
}

std::vector<Index> distinctVertices(test::Random& random, const Mesh& mesh, std::size_t count)
{
  std::vector<Index> vertices;
  while (vertices.size() < count)
    if (const Index v = random.integer(0, mesh.vertexCount() - 1); std::count(vertices.begin(), vertices.end(), v) == 0)
      vertices.push_back(v);
  return vertices;
}

/// The vertices of all faces, by pairs of an edge.
std::vector<std::pair<Index, Index>> edgesOf(const Mesh& mesh)
{
  std::vector<std::pair<Index, Index>> edges;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index a : mesh.faces[f])
      for (const Index b : mesh.faces[f])
        if (a < b) edges.emplace_back(a, b);
  return edges;
}

/// The vertices v with |from v| + |v to| = |from to| for successive places: the curve, where shortest paths are unique.
std::set<Index> curveByLengths(const Mesh& mesh, const std::vector<Index>& places)
{
  const Eigen::MatrixXd lengths = test::pathLengths(mesh);
  std::set<Index> curve;
  for (std::size_t k = 0; k < places.size(); ++k)
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      const Index from = places[k];
      const Index to = places[(k + 1) % places.size()];
      if (lengths(from, v) + lengths(v, to) <= lengths(from, to) * (1 + 1e-12)) curve.insert(v);
    }
  return curve;
}

/// The curve and all pieces but the largest. None where there is but one piece, or where two are equally large.
std::vector<Index> selectedByLengths(const Mesh& mesh, const std::vector<Index>& places)
{
  const std::set<Index> curve = curveByLengths(mesh, places);
  DisjointSets sets(mesh.vertexCount());
  for (const auto& [a, b] : edgesOf(mesh))
    if (!curve.contains(a) && !curve.contains(b)) sets.unite(a, b);
  std::map<Index, std::size_t> sizes;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (!curve.contains(v)) ++sizes[sets.find(v)];
  const auto largest =
      std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto isAsLarge = [&](const auto& piece) { return piece.second == largest->second; };
  if (sizes.size() < 2 || std::count_if(sizes.begin(), sizes.end(), isAsLarge) > 1) return {};
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (curve.contains(v) || sets.find(v) != largest->first) vertices.push_back(v);
  return vertices;
}

TEST(CurveSelector, AgreesWithAllPathLengths)
{
  const Mesh mesh = test::plate(9, 8);
  test::Random random(1);
  int compared = 0;
  for (int k = 0; k < 30; ++k) {
    const std::vector<Index> places = distinctVertices(random, mesh, 3 + k % 3);
    const std::vector<Index> expected = selectedByLengths(mesh, places);
    if (expected.empty()) continue;
    EXPECT_EQ(selected(mesh, {through(places)}), expected);
    ++compared;
  }
  EXPECT_GT(compared, 15);
}

TEST(CurveSelector, SidesOverlapInTheCurveAndMakeUpThePart)
{
  const Mesh mesh = test::merged(test::icosphere(2), test::plate(6, 6));
  const std::vector<Index> places{20, 90, 140};
  const std::vector<Index> smaller = selected(mesh, {through(places)});
  const std::vector<Index> larger = selected(mesh, {through(places, CurveSide::Larger)});
  EXPECT_LT(smaller.size(), larger.size());
  std::vector<Index> both;
  std::set_union(smaller.begin(), smaller.end(), larger.begin(), larger.end(), std::back_inserter(both));
  EXPECT_EQ(both, selected(mesh, {InComponent{0}})) << "nothing of the other part";
  std::vector<Index> curve;
  std::set_intersection(smaller.begin(), smaller.end(), larger.begin(), larger.end(), std::back_inserter(curve));
  for (const Index place : places) EXPECT_THAT(curve, testing::Contains(place));
  for (const auto& [a, b] : edgesOf(mesh)) {
    const auto isIn = [](const std::vector<Index>& list, Index v) { return std::ranges::binary_search(list, v); };
    const bool leadsOut = isIn(smaller, a) != isIn(smaller, b);
    EXPECT_TRUE(!leadsOut || isIn(curve, a) || isIn(curve, b)) << a << ' ' << b;
  }
}

TEST(CurveSelector, SelectsTheSameRegionWhateverVerticesAreCalled)
{
  const Mesh mesh = test::plate(9, 8);
  std::vector<Index> newIdOf(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(newIdOf.begin(), newIdOf.end(), Index{0});
  test::Random random(2);
  for (std::size_t k = newIdOf.size() - 1; k > 0; --k)
    std::swap(newIdOf[k], newIdOf[static_cast<std::size_t>(random.integer(0, static_cast<long>(k)))]);
  const auto renamed = [&](std::vector<Index> ids) {
    for (Index& id : ids) id = newIdOf[id];
    return ids;
  };
  const std::vector<Index> places{12, 17, 66, 61};
  std::vector<Index> expected = renamed(selected(mesh, {through(places)}));
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(selected(test::renumbered(mesh, newIdOf), {through(renamed(places))}), expected);
}

TEST(CurveSelector, SelectsTheSameRegionOfASoupOfFaces)
{
  const Mesh mesh = test::plate(9, 8);
  const Mesh soup = test::soup(mesh);
  InsideCurve curve;
  for (const Index v : {12, 17, 66, 61}) curve.through.emplace_back(AtNear{mesh.positions.row(v)});
  const std::vector<Index> expected = selected(mesh, {curve});
  std::vector<Index> corners;
  Index corner = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f]) {
      if (std::binary_search(expected.begin(), expected.end(), v)) corners.push_back(corner);
      ++corner;
    }
  EXPECT_EQ(selected(soup, {curve}), corners);
}

TEST(CurveSelector, TakesEveryLocationAtItsNearestVertex)
{
  const Mesh mesh = test::grid(8, 8);
  const std::vector<Index> expected = selected(mesh, {through({20, 24, 60, 56})});
  const auto corners = mesh.faces[100];
  const auto nearest = std::find(corners.begin(), corners.end(), 56);
  ASSERT_NE(nearest, corners.end());
  AtFace face{100, {0.2, 0.2, 0.2}};
  face.weights[nearest - corners.begin()] = 0.6;
  InsideCurve curve;
  curve.through = {AtVertex{20}, AtEdge{24, 25, 0.75}, AtNear{{6.2, 6.3, 5}}, face};
  EXPECT_EQ(selected(mesh, {curve}), expected);
}

TEST(CurveSelector, WorksInsideOtherSelections)
{
  const Mesh mesh = test::icosphere(2);
  const Selection curve{through({20, 90, 140})};
  const Selection top{InHalfSpace{Vector3::Zero(), Vector3::UnitZ()}};
  const std::vector<Index> inside = selected(mesh, curve);
  const std::vector<Index> above = selected(mesh, top);
  std::vector<Index> expected;
  std::set_difference(above.begin(), above.end(), inside.begin(), inside.end(), std::back_inserter(expected));
  EXPECT_EQ(selected(mesh, {AllOf{{top, {NotIn{std::make_shared<const Selection>(Selection{curve})}}}}}), expected);
  expected.clear();
  std::set_union(above.begin(), above.end(), inside.begin(), inside.end(), std::back_inserter(expected));
  EXPECT_EQ(selected(mesh, {AnyOf{{top, curve}}}), expected);
}

/// `around` times `along` quadrilaterals, vertex (i, j) has the id j `around` + i.
Mesh torus(Index around, Index along)
{
  Mesh mesh{Positions(around * along, 3), {}};
  for (Index j = 0; j < along; ++j)
    for (Index i = 0; i < around; ++i) {
      const double small = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      const double large = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(along);
      const double radius = 3 + std::cos(small);
      mesh.positions.row(j * around + i) << radius * std::cos(large), radius * std::sin(large), std::sin(small);
      const Index nextI = (i + 1) % around;
      const Index nextJ = (j + 1) % along;
      mesh.faces.add({j * around + i, nextJ * around + i, nextJ * around + nextI, j * around + nextI});
    }
  return mesh;
}

TEST(CurveSelector, RefusesCurvesThatDoNotDivideTheSurface)
{
  const Mesh ring = torus(12, 24);
  EXPECT_THAT(refusal(ring, {through({0, 4, 8})}, ".curve"), HasSubstr("does not divide the surface in two"));
  EXPECT_THAT(refusal(ring, {through({0, 96, 192})}, ".curve"), HasSubstr("around a hole as of a torus"));
  EXPECT_EQ(refusal(ring, {through({24, 28, 76, 72})}, ""), "") << "a patch of it";
  const Mesh sheet = test::grid(4, 4);
  EXPECT_THAT(refusal(sheet, {through({0, 4, 24, 20})}, ".curve"), HasSubstr("along the border"));
  EXPECT_THAT(refusal(sheet, {through({6, 7, 12})}, ".curve"), HasSubstr("no vertex is left within"));
}

TEST(CurveSelector, RefusesPlacesThatMakeNoCurve)
{
  const Mesh mesh = test::withVertex(test::merged(test::icosphere(1), test::grid(4, 4)), {9, 9, 9});
  EXPECT_THAT(refusal(mesh, {through({0, 20, 99})}, ".curve.through[2].vertex"), HasSubstr("no vertex 99"));
  EXPECT_THAT(refusal(mesh, {through({0, 20, 0})}, ".curve.through[2]"),
              HasSubstr("goes to vertex 0, as through[0] does; leave one of them out"));
  EXPECT_THAT(refusal(mesh, {through({0, 20, 50})}, ".curve.through[2]"),
              HasSubstr("lies on part 1 of the mesh, through[0] on part 0"));
  EXPECT_THAT(refusal(mesh, {through({0, 67, 20})}, ".curve.through[1]"), HasSubstr("no face uses vertex 67"));
  EXPECT_THAT(refusal(mesh, {through({})}, ".curve"), HasSubstr("does not divide"));
  const Selection nested{
      AnyOf{{{InComponent{0}}, {NotIn{std::make_shared<const Selection>(Selection{through({0, -1, 2})})}}}}};
  EXPECT_THAT(refusal(mesh, nested, ".any[1].not.curve.through[1].vertex"), HasSubstr("no vertex -1"));
}

TEST(CurveSelector, DrawsAroundAnEyeOfTheHead)
{
  const Mesh head = readMesh(test::dataFolder() + "/head.ply").mesh;
  InsideCurve curve;
  curve.through = {AtNear{{41, -76, 25}}, AtNear{{27, -76, 39}}, AtNear{{13, -76, 25}}, AtNear{{27, -76, 11}}};
  const std::vector<Index> eye = selected(head, {curve});
  std::size_t count = 0;
  for (Index v = 0; v < head.vertexCount(); ++v) {
    const Vector3 p = head.positions.row(v);
    const double away = std::hypot(p.x() - 27, p.z() - 25);
    const bool isSelected = std::binary_search(eye.begin(), eye.end(), v);
    const bool isFarInside = p.y() < -40 && away < 8;
    const bool isFarOutside = p.y() > -40 || away > 17;
    EXPECT_TRUE(isSelected ? !isFarOutside : !isFarInside) << p.transpose();
    count += isSelected ? 1 : 0;
  }
  EXPECT_GT(count, 60U);
}

}  // namespace
}  // namespace holdfast
