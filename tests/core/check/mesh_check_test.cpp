#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/check/mesh_check.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

using IdsByKind = std::map<std::string, std::vector<Index>>;

std::vector<Finding> check(const Mesh& mesh)
{
  const Triangulation triangulation = triangulate(mesh);
  return checkMesh(mesh, triangulation, makeSolverMesh(mesh, triangulation));
}

IdsByKind findingsOf(const Mesh& mesh)
{
  IdsByKind result;
  for (const Finding& finding : check(mesh)) result[finding.kind] = finding.ids;
  return result;
}

TEST(CheckMesh, FindsNothingWrongWithClosedMeshes)
{
  EXPECT_THAT(findingsOf(test::icosphere(2)), IsEmpty());
  EXPECT_THAT(findingsOf(test::box(Vector3(1, 2, 3), 3)), IsEmpty());
  EXPECT_THAT(findingsOf(test::quadBox(Vector3(1, 2, 3), 3)), IsEmpty());
}

TEST(CheckMesh, NamesAVertexOfEachPart)
{
  EXPECT_THAT(findingsOf(test::merged(test::tetrahedron(), test::moved(test::tetrahedron(), {9, 0, 0}))),
              ElementsAre(Pair("components", ElementsAre(0, 4))));
}

TEST(CheckMesh, NamesVerticesThatNoFaceUses)
{
  EXPECT_THAT(findingsOf(test::withVertex(test::tetrahedron(), {9, 9, 9})),
              ElementsAre(Pair("unreferenced_vertices", ElementsAre(4))));
}

/// The message of the finding of this kind.
std::string messageOf(const Mesh& mesh, const std::string& kind)
{
  for (const Finding& finding : check(mesh))
    if (finding.kind == kind) return finding.message;
  return "no finding";
}

TEST(CheckMesh, SpeaksOfOneThingInTheSingular)
{
  EXPECT_EQ(messageOf(test::grid(2, 2), "boundary_loops"),
            "1 boundary (a vertex of it is named); the surface is open there");
  const Mesh loose = test::withVertex(test::tetrahedron(), {9, 9, 9});
  EXPECT_EQ(messageOf(loose, "unreferenced_vertices"),
            "1 vertex that no face uses; it stays where it is unless pinned");
  EXPECT_EQ(messageOf(test::withVertex(loose, {8, 8, 8}), "unreferenced_vertices"),
            "2 vertices that no face uses; they stay where they are unless pinned");
  Mesh broken = test::tetrahedron();
  broken.positions(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(findNonFinite(broken).front().message,
            "1 vertex has a coordinate that is not a finite number; repair it, nothing can be solved");
}

TEST(CheckMesh, NamesVerticesThatAreWelded)
{
  // The corners of the second triangle, of which two repeat those of the first; the boundary is that of the square.
  EXPECT_THAT(findingsOf(test::soup(test::grid(1, 1))),
              ElementsAre(Pair("boundary_loops", ElementsAre(0)), Pair("welded_vertices", ElementsAre(3, 4))));
}

TEST(CheckMesh, NamesVerticesThatCoincideWithoutBeingWelded)
{
  const Mesh touching = test::merged(test::tetrahedron(), test::moved(test::tetrahedron(), {2, 2, 0}));
  EXPECT_THAT(findingsOf(touching),
              UnorderedElementsAre(Pair("components", ElementsAre(0, 4)), Pair("coincident_vertices", ElementsAre(7))));
}

TEST(CheckMesh, NamesFacesWithARepeatedCorner)
{
  EXPECT_THAT(findingsOf(test::withFace(test::tetrahedron(), {2, 3, 3})),
              ElementsAre(Pair("repeated_corner_faces", ElementsAre(4))));
}

TEST(CheckMesh, NamesFacesWithoutArea)
{
  Mesh mesh = test::grid(2, 1);
  mesh = test::withFace(mesh, {0, 2, 1});  // the bottom side: three vertices in a line
  EXPECT_THAT(findingsOf(mesh)["zero_area_faces"], ElementsAre(4));
  EXPECT_EQ(findingsOf(mesh).count("needle_faces"), 0U);
  EXPECT_EQ(findingsOf(test::grid(2, 1)).count("zero_area_faces"), 0U);
}

TEST(CheckMesh, NamesNeedlesBelowOneDegree)
{
  const auto sliver = [](double height) { return test::triangle({0, 0, 0}, {1, 0, 0}, {1, height, 0}); };
  EXPECT_THAT(findingsOf(sliver(0.0174))["needle_faces"], ElementsAre(0));
  EXPECT_THAT(findingsOf(sliver(1e-12))["needle_faces"], ElementsAre(0));
  EXPECT_EQ(findingsOf(sliver(0.0176)).count("needle_faces"), 0U);
}

TEST(CheckMesh, NamesNeedlesOfAnySizeAndShape)
{
  constexpr double kHalfDegree = 0.0087;
  for (const double size : {1e-170, 1e-60, 1.0, 1e60, 1e140}) {
    const Mesh flat = test::triangle({0, 0, 0}, {2 * size, 0, 0}, {size, kHalfDegree * size, 0});
    EXPECT_THAT(findingsOf(flat)["needle_faces"], ElementsAre(0)) << size;
    const Mesh wide = test::triangle({0, 0, 0}, {2 * size, 0, 0}, {size, 0.04 * size, 0});
    EXPECT_EQ(findingsOf(wide).count("needle_faces"), 0U) << size;
  }
}

TEST(CheckMesh, NamesFacesAtEdgesOfMoreThanTwo)
{
  Mesh mesh = test::withVertex(test::grid(1, 1), {0.5, 0.5, 1});
  mesh = test::withFace(mesh, {0, 3, 4});  // on the diagonal of the square
  EXPECT_THAT(findingsOf(mesh)["non_manifold_edges"], ElementsAre(0, 1, 2));
  EXPECT_EQ(findingsOf(test::grid(1, 1)).count("non_manifold_edges"), 0U);
}

TEST(CheckMesh, NamesVerticesThatJoinSeparateFans)
{
  Mesh mesh = test::withVertex(test::withVertex(test::tetrahedron(), {3, 1, 1}), {1, 3, 3});
  mesh = test::withFace(mesh, {0, 4, 5});
  EXPECT_THAT(findingsOf(mesh)["non_manifold_vertices"], ElementsAre(0));
  EXPECT_EQ(findingsOf(mesh).count("components"), 0U);
  EXPECT_EQ(findingsOf(test::plate(4, 3)).count("non_manifold_vertices"), 0U);
}

TEST(CheckMesh, NamesNeighboursThatDisagreeOnTheOutside)
{
  Mesh mesh{test::tetrahedron().positions, {}};
  for (const auto& face : {std::array<Index, 3>{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 2, 3}}) mesh.faces.add(face);
  EXPECT_THAT(findingsOf(mesh), ElementsAre(Pair("flipped_neighbours", ElementsAre(0, 1, 2, 3))));
}

TEST(CheckMesh, FindsTheOneSideOfAMoebiusStrip)
{
  // Six quadrilaterals in a ring of vertices 2 k (lower) and 2 k + 1 (upper); the last one is glued on with a half
  // turn.
  Mesh strip{Positions(12, 3), {}};
  for (Index k = 0; k < 6; ++k) {
    const double turn = static_cast<double>(k) * std::numbers::pi / 3;
    const Vector3 out(std::cos(turn), std::sin(turn), 0);
    const Vector3 half = 0.3 * (std::cos(turn / 2) * out + std::sin(turn / 2) * Vector3::UnitZ());
    strip.positions.row(2 * k) = out - half;
    strip.positions.row(2 * k + 1) = out + half;
    if (k < 5)
      strip.faces.add({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
    else
      strip.faces.add({10, 1, 0, 11});
  }
  const IdsByKind found = findingsOf(strip);
  EXPECT_THAT(found.at("flipped_neighbours"), ElementsAre(0, 5));
  EXPECT_THAT(found.at("boundary_loops"), ElementsAre(0)) << "one boundary, twice around";
}

TEST(CheckMesh, NamesAVertexOfEachBoundary)
{
  EXPECT_THAT(findingsOf(test::grid(3, 3)), ElementsAre(Pair("boundary_loops", ElementsAre(0))));
  Mesh ring = test::grid(3, 3);
  Polygons left;
  for (Index f = 0; f < ring.faces.size(); ++f)
    if (f != 8 && f != 9) left.add(ring.faces[f]);  // the middle square
  ring.faces = left;
  EXPECT_THAT(findingsOf(ring), ElementsAre(Pair("boundary_loops", ElementsAre(0, 5))));
}

TEST(FindNonFinite, NamesVerticesWithACoordinateThatIsNoNumber)
{
  Mesh mesh = test::icosphere(1);
  EXPECT_THAT(findNonFinite(mesh), IsEmpty());
  mesh.positions(3, 1) = std::numeric_limits<double>::quiet_NaN();
  mesh.positions(7, 2) = -std::numeric_limits<double>::infinity();
  const std::vector<Finding> findings = findNonFinite(mesh);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, "non_finite_coordinates");
  EXPECT_EQ(findings[0].idsOf, "vertex");
  EXPECT_EQ(findings[0].count, 2);
  EXPECT_THAT(findings[0].ids, ElementsAre(3, 7));
}

TEST(CheckMesh, CountsAllAndNamesTheFirstFew)
{
  Mesh mesh = test::tetrahedron();
  for (int k = 0; k < 50; ++k) mesh = test::withVertex(mesh, Vector3(9, 9, k));
  const std::vector<Finding> findings = check(mesh);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].count, 50);
  EXPECT_EQ(findings[0].ids.size(), kMaxFindingIds);
  EXPECT_EQ(findings[0].ids.back(), 4 + static_cast<Index>(kMaxFindingIds) - 1);
  EXPECT_EQ(findings[0].message.substr(0, 3), "50 ");
}

TEST(GuardFindings, SpeakOfSliversOnly)
{
  const auto found = [](const Mesh& mesh) {
    const SolverMesh solver = makeSolverMesh(mesh, triangulate(mesh));
    IdsByKind result;
    for (const Finding& finding : guardFindings(makeOperators(solver, Weights::Cotangent), solver))
      result[finding.kind] = finding.ids;
    return result;
  };
  for (const test::NamedMesh& named : test::lawMeshes()) EXPECT_THAT(found(named.mesh), IsEmpty()) << named.name;
  // A corner cut off so thinly that its angle is below that of the cap, and its area below the floor.
  Mesh mesh = test::withFace(test::withVertex(test::grid(4, 4), {0.5, -1e-4, 0}), {0, 25, 1});
  EXPECT_THAT(found(mesh), UnorderedElementsAre(Pair("capped_cotangents", ElementsAre(0, 1, 25)),
                                                Pair("floored_areas", ElementsAre(25))));
}

TEST(CheckMesh, CountsVerticesThatNearlyCoincideAtOpenEdges)
{
  const auto seamed = [](double gap) {
    return test::merged(test::grid(2, 2), test::moved(test::grid(2, 2), {2 + gap, 0, 0}));
  };
  for (const double gap : {1e-9, 1e-7})
    EXPECT_THAT(findingsOf(seamed(gap)).at("nearly_coincident_vertices"), ElementsAre(9, 12, 15)) << gap;
  EXPECT_FALSE(findingsOf(seamed(0)).contains("nearly_coincident_vertices")) << "it is welded";
  EXPECT_FALSE(findingsOf(seamed(1e-3)).contains("nearly_coincident_vertices")) << "a gap";
  Mesh torn = test::soup(test::icosphere(1));
  torn.positions(30, 0) = std::nextafter(torn.positions(30, 0), 9);
  EXPECT_EQ(findingsOf(torn).at("nearly_coincident_vertices").size(), 1U);
  const Mesh far = test::moved(seamed(1e-4), {5000, 0, 0});
  EXPECT_TRUE(findingsOf(far).contains("nearly_coincident_vertices")) << "single precision says no more there";
}

TEST(CheckMesh, TellsVerticesThatAreWeldedWithinATolerance)
{
  const Mesh mesh = test::merged(test::grid(2, 2), test::moved(test::grid(2, 2), {2 + 1e-9, 0, 0}));
  const Triangulation triangulation = triangulate(mesh);
  IdsByKind found;
  for (const Finding& finding : checkMesh(mesh, triangulation, makeSolverMesh(mesh, triangulation, 1e-8)))
    found[finding.kind] = finding.ids;
  EXPECT_THAT(found.at("welded_near_vertices"), ElementsAre(9, 12, 15));
  EXPECT_FALSE(found.contains("nearly_coincident_vertices"));
  EXPECT_FALSE(found.contains("components"));
}

}  // namespace
}  // namespace holdfast
