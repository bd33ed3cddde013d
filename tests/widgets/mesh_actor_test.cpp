#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/mesh/mesh_actor.h>
#include <holdfast/widgets/mesh/poly_data.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/source_tree.h"
#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

vtkPolyData& drawnBy(const MeshActor& actor)
{
  return *vtkPolyData::SafeDownCast(actor.surface().GetMapper()->GetInputAsDataSet());
}

TEST(MeshActor, PointsHandedToTheMapperAreThoseOfTheCore)
{
  const Model model = makeModel(test::withAwkwardCoordinates(test::box({1, 2, 3}, 3)), "box");
  MeshActor actor(model);
  const Positions moved = model.mesh.positions * (1.0 / 7);
  actor.setPositions(moved);
  const Positions drawn = positionsOf(drawnBy(actor));
  ASSERT_EQ(drawn.rows(), static_cast<Index>(actor.vertexOf().size()));
  for (Index k = 0; k < drawn.rows(); ++k) EXPECT_EQ(drawn.row(k), moved.row(actor.vertexOf()[k])) << "point " << k;
}

TEST(MeshActor, MovesWithoutNewMemory)
{
  const Model model = makeModel(test::box({1, 2, 3}, 3), "box");
  MeshActor actor(model);
  vtkPolyData& surface = drawnBy(actor);
  const void* const before = surface.GetPoints()->GetVoidPointer(0);
  const auto drawnTime = surface.GetMTime();
  actor.setPositions(2 * model.mesh.positions);
  EXPECT_EQ(surface.GetPoints()->GetVoidPointer(0), before);
  EXPECT_GT(surface.GetMTime(), drawnTime);
  EXPECT_EQ(surface.GetBounds()[5], 6);
}

TEST(MeshActor, ActorsThatOutliveItKeepTheirPoints)
{
  const Model model = makeModel(test::box({1, 2, 3}, 3), "box");
  vtkSmartPointer<vtkActor> surface;
  {
    const MeshActor actor(model);
    surface = &actor.surface();
  }
  auto& drawn = *vtkPolyData::SafeDownCast(surface->GetMapper()->GetInputAsDataSet());
  EXPECT_EQ(positionsOf(drawn).colwise().maxCoeff(), Eigen::RowVector3d(1, 2, 3));
}

TEST(MeshActor, SmoothSurfacesHaveOnePointAVertex)
{
  const Model model = makeModel(test::icosphere(2), "sphere");
  const ShadedSurface surface = cutAtSharpEdges(model);
  EXPECT_EQ(static_cast<Index>(surface.vertexOf.size()), model.mesh.vertexCount());
  EXPECT_TRUE(surface.creases.empty());
}

TEST(MeshActor, BoxesAreCutAlongTheirTwelveEdges)
{
  constexpr Index kDivisions = 4;
  const Model model = makeModel(test::box({1, 2, 3}, kDivisions), "box");
  const ShadedSurface surface = cutAtSharpEdges(model);
  EXPECT_EQ(static_cast<Index>(surface.creases.size()), 12 * kDivisions);
  EXPECT_EQ(static_cast<Index>(surface.vertexOf.size()), 6 * (kDivisions + 1) * (kDivisions + 1));
}

TEST(MeshActor, HiddenTrianglesAreNotDrawnNorEdgesOfThemAlone)
{
  constexpr Index kDivisions = 3;
  const Model model = makeModel(test::box({1, 2, 3}, kDivisions), "box");
  const auto isOnTop = [&](const Triangle& triangle) {
    return std::ranges::all_of(triangle, [&](Index v) { return model.mesh.positions(v, 2) == 3; });
  };
  std::vector<char> isHidden;
  for (const Triangle& triangle : model.triangulation.triangles) isHidden.push_back(isOnTop(triangle) ? 0 : 1);
  MeshActor actor(model);
  const vtkIdType all = drawnBy(actor).GetNumberOfPolys();
  actor.setMeshEdges(MeshEdges::All);
  const auto edges = [](vtkActor& lines) {
    return vtkPolyData::SafeDownCast(lines.GetMapper()->GetInputAsDataSet())->GetNumberOfLines();
  };
  const vtkIdType allEdges = edges(actor.meshEdges());
  actor.setHidden(isHidden);
  EXPECT_EQ(drawnBy(actor).GetNumberOfPolys(), 2 * kDivisions * kDivisions) << "one of six sides";
  EXPECT_EQ(edges(actor.edges()), 4 * kDivisions) << "its rim";
  EXPECT_EQ(edges(actor.meshEdges()), 2 * kDivisions * (kDivisions + 1) + kDivisions * kDivisions);
  EXPECT_FALSE(actor.coarse().isSolid()) << "backs are seen";

  for (char& each : isHidden) each = each != 0 ? 0 : 1;
  actor.setHidden(isHidden);
  EXPECT_EQ(edges(actor.edges()), 12 * kDivisions) << "the rim is that of the sides, too";
  actor.setHidden({});
  EXPECT_EQ(drawnBy(actor).GetNumberOfPolys(), all);
  EXPECT_EQ(edges(actor.meshEdges()), allEdges);
  EXPECT_TRUE(actor.coarse().isSolid());
}

TEST(MeshActor, BordersAreDrawn)
{
  const ShadedSurface surface = cutAtSharpEdges(makeModel(test::grid(5, 3), "grid"));
  EXPECT_EQ(surface.creases.size(), 16);
}

TEST(MeshActor, ShortEndsOfLinesOnASmoothSurfaceAreNotDrawn)
{
  const Model head = makeModel(readMesh(test::dataFolder() + "/head.ply").mesh, "head");
  EXPECT_TRUE(cutAtSharpEdges(head).creases.empty());
}

TEST(ShadedSurface, IsCutWhereItBendsByMoreThan42Degrees)
{
  for (const double degrees : {41.9, 42.1}) {
    const double angle = degrees * std::numbers::pi / 180;
    Mesh hinge = test::triangle({1, 0, 0}, {0, 0, 0}, {0, -1, 0});
    hinge = test::withVertex(std::move(hinge), {0, std::cos(angle), std::sin(angle)});
    hinge = test::withFace(std::move(hinge), {1, 0, 3});
    EXPECT_EQ(cutAtSharpEdges(makeModel(hinge, "hinge")).vertexOf.size(), degrees < 42 ? 4u : 6u) << degrees;
  }
}

TEST(MeshActor, CutsStayWhereTheyAreWhileTheMeshBends)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  MeshActor actor(model);
  const std::size_t points = actor.vertexOf().size();
  Positions folded = model.mesh.positions;
  folded.col(2) = (folded.col(0).array() - 2).abs() * 5;
  actor.setPositions(folded);
  EXPECT_EQ(positionsOf(drawnBy(actor)).rows(), static_cast<Index>(points));
}

TEST(MeshActor, NormalsOfABoxAreThoseOfItsSides)
{
  const Model model = makeModel(test::box({1, 2, 3}, 2), "box");
  const MeshActor actor(model);
  vtkDataArray& normals = *drawnBy(actor).GetPointData()->GetNormals();
  for (vtkIdType k = 0; k < normals.GetNumberOfTuples(); ++k) {
    const double* const n = normals.GetTuple3(k);
    EXPECT_NEAR(std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])}), 1, 1e-6) << "point " << k;
  }
}

TEST(MeshActor, ColorsAtVerticesAreThoseOfTheScale)
{
  const Model model = makeModel(test::icosphere(1), "sphere");
  MeshActor actor(model);
  const ColorScale scale{"", Scaling::Linear, 0, 10, {}};
  std::vector<double> values;
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) values.push_back(0.37 * static_cast<double>(v));
  actor.setColors(values, scale);
  vtkMapper& mapper = *actor.surface().GetMapper();
  vtkDataArray& shares = *drawnBy(actor).GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < shares.GetNumberOfTuples(); ++k) {
    const Color color = colorOf(scale, values[actor.vertexOf()[k]]);
    const unsigned char* const drawn = mapper.GetLookupTable()->MapValue(shares.GetTuple1(k));
    EXPECT_NEAR(drawn[0], 255 * color.red, 1);
    EXPECT_NEAR(drawn[1], 255 * color.green, 1);
    EXPECT_NEAR(drawn[2], 255 * color.blue, 1);
  }
  EXPECT_TRUE(mapper.GetInterpolateScalarsBeforeMapping());
}

TEST(MeshActor, VerticesWithoutAValueAreGrey)
{
  const Model model = makeModel(test::tetrahedron(), "tetrahedron");
  MeshActor actor(model);
  actor.setColors(std::vector<double>(4, std::numeric_limits<double>::quiet_NaN()), {"", Scaling::Linear, 0, 1, {}});
  const double share = drawnBy(actor).GetPointData()->GetScalars()->GetTuple1(0);
  const unsigned char* const drawn = actor.surface().GetMapper()->GetLookupTable()->MapValue(share);
  EXPECT_EQ(drawn[0], std::lround(255 * kNoValueColor.red));
  EXPECT_EQ(drawn[1], drawn[0]);
  EXPECT_EQ(drawn[2], drawn[0]);
  EXPECT_FALSE(actor.surface().GetMapper()->GetInterpolateScalarsBeforeMapping());
}

}  // namespace
}  // namespace holdfast
