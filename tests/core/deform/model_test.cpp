#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/model.h>
#include <holdfast/operators/operators.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/one_core.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// Cones beside one another, each of `sides` triangles that meet at its tip, its first vertex.
Mesh cones(Index count, Index sides)
{
  Mesh mesh{Positions(count * (sides + 1), 3), {}};
  for (Index c = 0; c < count; ++c) {
    const Index tip = c * (sides + 1);
    mesh.positions.row(tip) << 3.0 * static_cast<double>(c), 0, 1;
    for (Index k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides);
      mesh.positions.row(tip + 1 + k) << 3.0 * static_cast<double>(c) + std::cos(angle), std::sin(angle), 0;
      mesh.faces.add({tip, tip + 1 + k, tip + 1 + (k + 1) % sides});
    }
  }
  return mesh;
}

std::string refusal(const Mesh& mesh)
{
  try {
    static_cast<void>(makeModel(mesh, "cones.obj"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(Model, RefusesAVertexOfSoManyTrianglesThatItsEquationsWouldFillTheMemory)
{
  EXPECT_EQ(refusal(cones(1, kMostTrianglesAtAVertex)), "taken");
  EXPECT_THAT(refusal(cones(1, kMostTrianglesAtAVertex + 1)),
              testing::HasSubstr("cones.obj: vertex 0: 8001 triangles meet here, which would fill the memory"));
}

TEST(Model, CountsSuchVerticesTogether)
{
  EXPECT_EQ(refusal(cones(3, kMostTrianglesAtAVertex / 2)), "taken");
  EXPECT_THAT(refusal(cones(5, kMostTrianglesAtAVertex / 2)), testing::HasSubstr("vertex 0: 4000 triangles meet here"));
  EXPECT_EQ(refusal(cones(100, 1000)), "taken");
}

TEST(Model, RefusesFacesThatAreNone)
{
  Mesh mesh = cones(1, 5);
  mesh.faces.add({0, 1, 6});
  EXPECT_THAT(refusal(mesh), testing::HasSubstr("face 5: vertex 6 does not exist: the mesh has 6, numbered from 0"));
  mesh = cones(1, 5);
  mesh.faces = {};
  mesh.faces.add({0, 1});
  EXPECT_THAT(refusal(mesh), testing::HasSubstr("the mesh has no faces of three corners or more"));
}

TEST(Model, KeepsFacesOfFewCorners)
{
  Mesh mesh = cones(1, 5);
  mesh.faces.add({0, 1});
  mesh.faces.add(std::vector<Index>{});
  mesh.faces.add({0, 1, 2});
  const Model model = makeModel(mesh);
  EXPECT_EQ(model.mesh.faces, mesh.faces);
  EXPECT_EQ(model.triangulation.faceOf.back(), 7);
  const auto finding = std::ranges::find(model.findings, "faces_of_few_corners", &Finding::kind);
  ASSERT_NE(finding, model.findings.end());
  EXPECT_THAT(finding->ids, testing::ElementsAre(5, 6));
}

TEST(Model, APolygonBesideAFaceOfTwoCornersKeepsItsOwn)
{
  Mesh mesh{Positions(4, 3), {}};
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  mesh.faces.add({0, 1});
  mesh.faces.add({0, 1, 2, 3});  // as many corners as two triangles
  const Model model = makeModel(mesh);
  ASSERT_EQ(model.triangulation.triangles.size(), 2U);
  for (Index t = 0; t < 2; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(model.triangulation.triangles[t][k], model.triangulation.cornersOf(t)[k]);
}

TEST(Model, GivesAPlaceToVerticesThatNeedNone)
{
  Mesh mesh = test::withVertex(cones(1, 5), {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh = test::withVertex(mesh, {0, -std::numeric_limits<double>::infinity(), 0});
  mesh.faces.add({6, 7});
  const Model model = makeModel(mesh);
  EXPECT_TRUE(model.mesh.positions.allFinite());
  EXPECT_EQ(model.solverMesh.diagonal, makeModel(cones(1, 5)).solverMesh.diagonal);
  EXPECT_THAT(model.solverMesh.withoutPlace, testing::ElementsAre(6, 7));
  const auto finding = std::ranges::find(model.findings, "non_finite_unused_vertices", &Finding::kind);
  ASSERT_NE(finding, model.findings.end());
  EXPECT_THAT(finding->ids, testing::ElementsAre(6, 7));
  for (const char* kind : {"coincident_vertices", "unreferenced_vertices"})
    EXPECT_EQ(std::ranges::find(model.findings, kind, &Finding::kind), model.findings.end()) << kind;
}

TEST(Model, OfAFileSaysWhatIsOddInIt)
{
  const Model model = makeModelOfFile({cones(1, 5), nullptr, {"one", "two"}}, "file");
  ASSERT_GE(model.findings.size(), 2U);
  const Finding& last = model.findings.back();
  EXPECT_EQ(last.kind, "unusual_file");
  EXPECT_EQ(last.message, "two");
  EXPECT_EQ(last.idsOf, "file");
  EXPECT_THAT(last.ids, testing::IsEmpty());
}

TEST(Model, IsMadeOfMatrices)
{
  const Mesh mesh = cones(2, 5);
  Triangles triangles(10, 3);
  for (Index f = 0; f < 10; ++f) triangles.row(f) << mesh.faces[f][0], mesh.faces[f][1], mesh.faces[f][2];
  EXPECT_EQ(makeModel({mesh.positions, Polygons(triangles)}).mesh.faces, mesh.faces);
}

void expectSameBits(const Model& a, const Model& b)
{
  EXPECT_EQ(a.solverMesh.triangles, b.solverMesh.triangles);
  EXPECT_EQ(a.solverMesh.weld.unknownOf, b.solverMesh.weld.unknownOf);
  EXPECT_TRUE(std::ranges::equal(a.findings, b.findings, {}, &Finding::message, &Finding::message));
  EXPECT_TRUE(std::ranges::equal(a.findings, b.findings, {}, &Finding::ids, &Finding::ids));
  for (const Weights weights : test::allWeights()) {
    const Operators ofA = makeOperators(a.solverMesh, weights);
    const test::OneCore one;
    const Operators ofB = makeOperators(b.solverMesh, weights);
    EXPECT_EQ(ofA.delta, ofB.delta);
    EXPECT_EQ(ofA.rowWeights, ofB.rowWeights);
    EXPECT_EQ(ofA.rowFactors, ofB.rowFactors);
    EXPECT_TRUE(std::ranges::equal(ofA.S->coeffs(), ofB.S->coeffs()));
    EXPECT_EQ(ofA.clampedCotangents, ofB.clampedCotangents);
  }
}

TEST(Model, HasTheSameBitsOnOneCoreAsItsOperatorsHave)
{
  const Mesh plate = test::plate(90, 70);
  for (const Mesh& mesh : {plate, test::soup(plate)}) {
    const Model onAll = makeModel(mesh);
    ASSERT_FALSE(onAll.findings.empty());
    const auto onOne = [&] {
      const test::OneCore one;
      return makeModel(mesh);
    };
    expectSameBits(onAll, onOne());
  }
}

}  // namespace
}  // namespace holdfast
