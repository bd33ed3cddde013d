#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/mesh/poly_data.h>
#include <holdfast/widgets/scene/scene_contents.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

vtkPolyData& drawnBy(vtkActor& actor)
{
  return *vtkPolyData::SafeDownCast(actor.GetMapper()->GetInputAsDataSet());
}

DeformResult lifted(const Model& model)
{
  NoProgress progress;
  return deform(model, test::listOf({test::hold({0, 1}), test::moveBy(AtVertex{24}, {0, 0, 1})}), "constraints", {},
                progress);
}

TEST(SceneContents, ShowsPositionsAndMarksOfADeformation)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const DeformResult deformation = lifted(model);
  SceneContents contents(model);
  contents.show(deformation);
  const Positions drawn = positionsOf(drawnBy(contents.mesh().surface()));
  for (Index k = 0; k < drawn.rows(); ++k)
    EXPECT_EQ(drawn.row(k), deformation.positions.row(contents.mesh().vertexOf()[k])) << "point " << k;
  ASSERT_EQ(contents.marks().size(), 3);
  EXPECT_EQ(contents.marks()[2].place, Vector3(4, 4, 1));
}

TEST(SceneContents, OfHiddenFacesNothingIsShown)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  SceneContents contents(model);
  contents.show(lifted(model));
  contents.setSelection({0, 24});
  ASSERT_EQ(contents.marks().size(), 3);
  const auto dots = [&] {
    vtkNew<vtkRenderer> renderer;
    contents.addTo(*renderer);
    vtkIdType count = 0;
    vtkActorCollection& actors = *renderer->GetActors();
    actors.InitTraversal();
    while (vtkActor* const actor = actors.GetNextActor()) count += drawnBy(*actor).GetNumberOfVerts();
    return count;
  };
  const vtkIdType before = dots();
  // This hides the triangles at vertex 24, the last corner, and all beside them.
  std::vector<char> isHidden;
  for (const Triangle& triangle : model.triangulation.triangles)
    isHidden.push_back(std::ranges::all_of(triangle, [](Index v) { return v >= 10; }) ? 1 : 0);
  contents.setHidden(isHidden);
  ASSERT_EQ(contents.marks().size(), 2);
  for (const ConstraintMark& mark : contents.marks()) EXPECT_EQ(mark.constraint, 0);
  EXPECT_LT(dots(), before) << "of the selection";
  contents.show(lifted(model));
  EXPECT_EQ(contents.marks().size(), 2) << "of another deformation, too";
  contents.setHidden({});
  EXPECT_EQ(contents.marks().size(), 3);
  EXPECT_EQ(dots(), before);
}

TEST(SceneContents, OfAFailedDeformationAreTheMeshAtRest)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  DeformResult failed = lifted(model);
  failed.positions = model.mesh.positions;
  failed.rotations.resize(0, 3);
  SceneContents contents(model);
  contents.setRotationDisplay(RotationDisplay::Arrows);
  contents.show(failed);
  EXPECT_EQ(positionsOf(drawnBy(contents.mesh().surface())).colwise().maxCoeff(), Eigen::RowVector3d(4, 4, 0));
}

TEST(SceneContents, ColorsStayWhileTheMeshMoves)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const DeformResult deformation = lifted(model);
  SceneContents contents(model);
  contents.color(coloringOf(model, deformation, ColorBy::Displacement, ""));
  vtkPolyData& surface = drawnBy(contents.mesh().surface());
  vtkDataArray* const shares = surface.GetPointData()->GetScalars();
  const auto made = shares->GetMTime();
  contents.setPositions(2 * model.mesh.positions);
  EXPECT_EQ(surface.GetPointData()->GetScalars(), shares);
  EXPECT_EQ(shares->GetMTime(), made);
  contents.color(std::nullopt);
  EXPECT_FALSE(contents.mesh().surface().GetMapper()->GetScalarVisibility());
}

TEST(SceneContents, AddAllTheirActorsOnce)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  SceneContents contents(model);
  vtkNew<vtkRenderer> renderer;
  contents.addTo(*renderer);
  const int count = renderer->GetActors()->GetNumberOfItems();
  contents.show(lifted(model));
  contents.setMeshEdges(MeshEdges::All);
  contents.setSelection({0, 1, 2});
  EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), count);
}

TEST(SceneContents, LeaveTheRendererWhenTheyEnd)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  vtkNew<vtkRenderer> renderer;
  {
    SceneContents contents(model);
    contents.addTo(*renderer);
    EXPECT_GT(renderer->GetActors()->GetNumberOfItems(), 0);
  }
  EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), 0);
}

TEST(SceneContents, OutliveTheirRenderer)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  SceneContents contents(model);
  contents.addTo(*vtkNew<vtkRenderer>());
  vtkNew<vtkRenderer> next;
  contents.addTo(*next);
  EXPECT_GT(next->GetActors()->GetNumberOfItems(), 0);
}

TEST(MeshEdges, AreThoseOfThePolygonsOfTheFile)
{
  const Model model = makeModel(test::quadBox({1, 1, 1}, 3), "box");
  MeshActor actor(model);
  EXPECT_FALSE(actor.meshEdges().GetVisibility());
  actor.setMeshEdges(MeshEdges::All);
  EXPECT_TRUE(actor.meshEdges().GetVisibility());
  // Two edges a square of 54, each shared by two: no diagonals.
  constexpr vtkIdType kEdges = 2 * 54;
  vtkPolyData& lines = drawnBy(actor.meshEdges());
  EXPECT_GE(lines.GetNumberOfLines(), kEdges);
  std::set<std::pair<Index, Index>> edges;
  for (vtkIdType k = 0; k < lines.GetNumberOfLines(); ++k) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines.GetCellPoints(k, count, ids);
    ASSERT_EQ(count, 2);
    edges.insert(std::minmax(actor.vertexOf()[ids[0]], actor.vertexOf()[ids[1]]));
  }
  EXPECT_EQ(static_cast<vtkIdType>(edges.size()), kEdges);
}

/// Expects that what is drawn coarsely has the places, normals and values of its vertices.
void expectCopies(vtkPolyData& coarse, vtkPolyData& full, const MeshActor& actor)
{
  ASSERT_EQ(static_cast<std::size_t>(coarse.GetNumberOfPoints()), actor.coarse().vertexOf().size());
  // A sphere has one point for each vertex.
  ASSERT_EQ(full.GetNumberOfPoints(), actor.model().mesh.vertexCount());
  std::vector<vtkIdType> pointOf(actor.vertexOf().size());
  for (std::size_t k = 0; k < pointOf.size(); ++k) pointOf[actor.vertexOf()[k]] = static_cast<vtkIdType>(k);
  for (vtkIdType k = 0; k < coarse.GetNumberOfPoints(); ++k) {
    const vtkIdType v = pointOf[actor.coarse().vertexOf()[k]];
    EXPECT_EQ(Vector3(coarse.GetPoint(k)), Vector3(full.GetPoint(v)));
    EXPECT_EQ(Vector3(coarse.GetPointData()->GetNormals()->GetTuple3(k)),
              Vector3(full.GetPointData()->GetNormals()->GetTuple3(v)));
    EXPECT_EQ(coarse.GetPointData()->GetScalars()->GetTuple1(k), full.GetPointData()->GetScalars()->GetTuple1(v));
  }
}

TEST(Detail, CoarseTrianglesHaveThePlacesNormalsAndColorsOfTheirVertices)
{
  const Model model = makeModel(test::icosphere(6), "sphere");
  MeshActor actor(model);
  vtkPolyData& full = drawnBy(actor.surface());
  actor.setDetail(Detail::Coarse);
  vtkPolyData& coarse = drawnBy(actor.surface());
  EXPECT_LT(coarse.GetNumberOfPolys(), 1.5 * kCoarseTriangles);
  std::vector<double> values;
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) values.push_back(static_cast<double>(v) / 1e5);
  actor.setColors(values, {});
  expectCopies(coarse, full, actor);
  Positions moved = model.mesh.positions;
  moved.col(0) = 2 * moved.col(0) + moved.col(1);
  actor.setPositions(moved);
  std::reverse(values.begin(), values.end());
  actor.setColors(values, {});
  EXPECT_EQ(&drawnBy(actor.surface()), &coarse);
  actor.setDetail(Detail::Full);
  EXPECT_EQ(&drawnBy(actor.surface()), &full);
  expectCopies(coarse, full, actor);
}

TEST(Detail, LargeTintsAreCoarseAndSmallOnesAreNot)
{
  const Model model = makeModel(test::icosphere(7), "sphere");
  MeshActor actor(model);
  SelectionOverlay overlay(model, actor);
  std::vector<Index> all(static_cast<std::size_t>(model.mesh.vertexCount()));
  std::iota(all.begin(), all.end(), Index{0});
  overlay.set(all);
  EXPECT_EQ(drawnBy(overlay.tint().faces()).GetNumberOfPolys(), static_cast<vtkIdType>(model.mesh.faces.size()));
  actor.setDetail(Detail::Coarse);
  overlay.tint().updateDetail();
  EXPECT_EQ(drawnBy(overlay.tint().faces()).GetNumberOfPolys(),
            static_cast<vtkIdType>(actor.coarse().triangles().size()));
  EXPECT_EQ(drawnBy(overlay.tint().faces()).GetPoints(), actor.coarse().data().GetPoints());
  // A cap of this share of the sphere.
  const auto isCoarseOnCap = [&](double share) {
    std::vector<Index> cap;
    for (Index v = 0; v < model.mesh.vertexCount(); ++v)
      if (model.mesh.positions(v, 2) > 1 - 2 * share) cap.push_back(v);
    overlay.set(cap);
    return drawnBy(overlay.tint().faces()).GetPoints() == actor.coarse().data().GetPoints();
  };
  EXPECT_TRUE(isCoarseOnCap(0.01));
  EXPECT_GT(drawnBy(overlay.tint().faces()).GetNumberOfPolys(), 100);
  EXPECT_FALSE(isCoarseOnCap(0.004));
}

TEST(Detail, OfSmallMeshesIsAlwaysFull)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  MeshActor actor(model);
  actor.setMeshEdges(MeshEdges::All);
  actor.setDetail(Detail::Coarse);
  EXPECT_EQ(drawnBy(actor.surface()).GetNumberOfPolys(), static_cast<vtkIdType>(model.mesh.faces.size()));
  EXPECT_TRUE(actor.meshEdges().GetVisibility());
}

TEST(SelectionOverlay, TintsWhatLiesBetweenVerticesAndDotsTheOthers)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const MeshActor mesh(model);
  SelectionOverlay overlay(model, mesh);
  EXPECT_FALSE(overlay.dots().GetVisibility());
  overlay.set({0, 1, 5, 6, 24});
  EXPECT_EQ(drawnBy(overlay.dots()).GetNumberOfVerts(), 1);
  EXPECT_EQ(drawnBy(overlay.tint().faces()).GetNumberOfPolys(), 2);
  EXPECT_EQ(drawnBy(*overlay.tint().outline().front()).GetNumberOfLines(), 4);
  EXPECT_EQ(drawnBy(overlay.dots()).GetPoints(), &mesh.points());
  EXPECT_TRUE(overlay.tint().faces().GetVisibility());
  overlay.set({});
  EXPECT_FALSE(overlay.dots().GetVisibility());
  EXPECT_FALSE(overlay.tint().faces().GetVisibility());
}

TEST(SelectionOverlay, TintsSharpEdgesOnBothSides)
{
  const Model model = makeModel(test::box({1, 1, 1}, 2), "box");
  const MeshActor mesh(model);
  SelectionOverlay overlay(model, mesh);
  std::vector<Index> all(static_cast<std::size_t>(model.mesh.vertexCount()));
  std::iota(all.begin(), all.end(), Index{0});
  overlay.set(all);
  EXPECT_EQ(drawnBy(overlay.tint().faces()).GetNumberOfPolys(), static_cast<vtkIdType>(model.mesh.faces.size()));
}

TEST(SelectionOverlay, PassesOverVerticesThatNoFaceUses)
{
  const Model model = makeModel(test::withVertex(test::grid(2, 2), {9, 9, 9}), "grid");
  const MeshActor mesh(model);
  SelectionOverlay overlay(model, mesh);
  overlay.set({9});
  EXPECT_FALSE(overlay.dots().GetVisibility());
}

TEST(SelectionOverlay, OfManyVerticesWithoutAFaceHasFewDots)
{
  const Model model = makeModel(test::grid(150, 150), "grid");
  const MeshActor mesh(model);
  SelectionOverlay overlay(model, mesh);
  std::vector<Index> alternate;
  for (Index v = 0; v < model.mesh.vertexCount(); v += 2) alternate.push_back(v);
  overlay.set(alternate);
  EXPECT_FALSE(overlay.tint().faces().GetVisibility());
  EXPECT_LT(drawnBy(overlay.dots()).GetNumberOfVerts(), 1.3 * kMostSelectionDots);
}

/// A fixed square, a rigid one beside it, and one vertex apart.
ConstraintList regions()
{
  return {"",
          {{"fixed", true, FixedConstraint{{VertexIds{{0, 1, 5, 6}}}}},
           {"rigid", true, RigidConstraint{{VertexIds{{18, 19, 23, 24}}}}},
           {"apart", true, FixedConstraint{{VertexIds{{4}}}}}}};
}

TEST(RegionTints, AreFacesWithOutlinesAndOnlyVerticesApartHaveDots)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const MeshActor mesh(model);
  RegionTints tints(mesh);
  const DeformResult deformation = deform(model, regions());
  const auto marks = markSet(model, constraintMarks(model, deformation), nullptr);
  tints.show(marks);
  const auto faces = [&](std::size_t look) {
    const FaceTint& tint = *tints.tints()[look];
    return tint.faces().GetVisibility() != 0 ? drawnBy(tint.faces()).GetNumberOfPolys() : 0;
  };
  EXPECT_EQ(faces(static_cast<std::size_t>(ConstraintStatus::Met)), 2);
  EXPECT_EQ(faces(kRegionLooks - 1), 2) << "rigid, with the vertex to which the others refer";
  ASSERT_EQ(marks->drawn.size(), 1u);
  EXPECT_EQ(marks->marks[marks->drawn[0]].constraint, 2);

  EXPECT_EQ(faces(kRegionLooks), 0);
  tints.highlight({1});
  EXPECT_EQ(faces(kRegionLooks), 2);
  tints.highlight({});
  EXPECT_EQ(faces(kRegionLooks), 0);
  tints.show(std::make_shared<const MarkSet>());
  for (std::size_t look = 0; look <= kRegionLooks; ++look) EXPECT_EQ(faces(look), 0) << look;
}

TEST(RegionTints, ShowTheMostSeriousStatusOfARegion)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list = regions();
  list.constraints.push_back({"pulled", true, HandleConstraint{{VertexIds{{0}}}, {}, Vector3(0, 0, 1), {}}});
  list.constraints.push_back({"again", true, FixedConstraint{{VertexIds{{5, 6, 10, 11}}}}});
  const auto looks = regionLooks(model, constraintMarks(model, deform(model, list)));
  const auto bit = [](ConstraintStatus status) { return 1U << static_cast<unsigned>(status); };
  EXPECT_EQ(looks[0], bit(ConstraintStatus::Met) | bit(ConstraintStatus::Conflicting));
  EXPECT_EQ(looks[5], bit(ConstraintStatus::Met)) << "of the rows of \"again\" only half are redundant";
  EXPECT_EQ(looks[2], 0);
}

TEST(PointPreview, ShowsOneShapeAndARing)
{
  PointPreview preview;
  const auto shown = [&] {
    const auto actors = preview.actors();
    return std::count_if(actors.begin(), actors.end(), [](vtkActor* actor) { return actor->GetVisibility() != 0; });
  };
  EXPECT_EQ(shown(), 0);
  for (const MarkKind kind : {MarkKind::Vertex, MarkKind::Edge, MarkKind::Face}) {
    preview.set(PreviewedPoint{{1, 2, 3}, kind});
    EXPECT_EQ(shown(), 2);
  }
  preview.set({});
  EXPECT_EQ(shown(), 0);
}

}  // namespace
}  // namespace holdfast
