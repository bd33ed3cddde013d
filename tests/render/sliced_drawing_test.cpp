#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/scene/kept_scene.h>
#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/widgets/scene/sliced_drawing.h>

#include "render/drawn_window.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using Pixels = std::vector<unsigned char>;

/// A bent plate of several slices in a window that is never shown.
class SlicedPlate : public ::testing::Test {
 protected:
  SlicedPlate()
  {
    window->SetNumberOfLayers(2);
    window->AddRenderer(front);
    front->SetLayer(1);
    addBackground(*scene);
    addLights(*scene);
    contents.addTo(*scene);
    Positions bent = model.mesh.positions;
    for (Index v = 0; v < bent.rows(); ++v) bent(v, 2) += 0.02 * bent(v, 0) * bent(v, 0);
    contents.setPositions(bent);
    contents.setSelection({0, 1, 2, 500});
    scene->ResetCamera();
    scene->GetActiveCamera()->Elevation(-50);
    scene->ResetCameraClippingRange();
    slices.emplace(*scene);
  }

  void color()
  {
    Coloring coloring;
    for (Index v = 0; v < model.mesh.vertexCount(); ++v) coloring.values.push_back(static_cast<double>(v % 1000));
    coloring.scale.high = 1000;
    contents.color(coloring);
  }

  [[nodiscard]] Pixels drawnAtOnce()
  {
    window->Render();
    return shown();
  }

  [[nodiscard]] Pixels drawnInSlices()
  {
    slices->begin(contents);
    while (slices->isUnderWay()) slices->advance();
    return shown();
  }

  [[nodiscard]] Pixels shown() { return test::pixelsOf(*window, test::DrawnBuffer::Front); }

  const Model model = makeModel(test::grid(260, 260), "plate");
  SceneContents contents{model};
  const test::OffscreenWindow offscreen{{320, 240}};
  vtkRenderWindow* const window = &offscreen.window();
  vtkRenderer* const scene = &offscreen.renderer();
  vtkNew<vtkRenderer> front;
  std::optional<SlicedDrawing> slices;
};

TEST_F(SlicedPlate, TheFinishedPictureIsTheOneDrawnAtOnce)
{
  ASSERT_GT(contents.mesh().surfaceSlices().count(), 1);
  const Pixels atOnce = drawnAtOnce();
  EXPECT_EQ(drawnInSlices(), atOnce);
  EXPECT_EQ(drawnAtOnce(), atOnce) << "and nothing of it stays behind";
}

TEST_F(SlicedPlate, TheSmoothPictureIsThatOfTheOneDrawnAtOnce)
{
  KeptScene kept(*scene, *scene);
  const Pixels rough = drawnAtOnce();
  kept.drawLayersAbove();
  const Pixels smooth = shown();
  EXPECT_NE(smooth, rough);
  EXPECT_EQ(drawnInSlices(), rough);
  kept.drawLayersAbove();
  EXPECT_EQ(shown(), smooth);
}

TEST_F(SlicedPlate, ColoursAreThoseDrawnAtOnce)
{
  static_cast<void>(drawnInSlices());
  const Pixels plain = shown();
  color();
  const Pixels atOnce = drawnAtOnce();
  ASSERT_NE(atOnce, plain);
  EXPECT_EQ(drawnInSlices(), atOnce);
  contents.color(std::nullopt);
  EXPECT_EQ(drawnInSlices(), plain);
}

TEST_F(SlicedPlate, LargeSelectionsAndTheEdgesOfPolygonsAreThoseDrawnAtOnce)
{
  std::vector<Index> half;
  for (Index v = 0; v < model.mesh.vertexCount() / 2; ++v) half.push_back(v);
  const Pixels before = drawnAtOnce();
  contents.setSelection(half);
  contents.setMeshEdges(MeshEdges::All);
  ASSERT_EQ(contents.slices().size(), 3u);
  for (const ActorSlices* part : contents.slices()) EXPECT_GT(part->count(), 1);
  const Pixels atOnce = drawnAtOnce();
  ASSERT_NE(atOnce, before);
  EXPECT_EQ(drawnInSlices(), atOnce);
  EXPECT_EQ(drawnAtOnce(), atOnce) << "and nothing of it stays behind";
  contents.setSelection({0, 1, 2, 500});
  contents.setMeshEdges(MeshEdges::Sharp);
  EXPECT_EQ(drawnInSlices(), before);
}

TEST_F(SlicedPlate, NothingIsShownBeforeThePictureIsWhole)
{
  const Pixels before = drawnAtOnce();
  scene->GetActiveCamera()->Azimuth(20);
  slices->begin(contents);
  slices->advance();
  EXPECT_EQ(shown(), before);
  slices->abandon();
  EXPECT_EQ(shown(), before);

  slices->begin(contents);
  while (slices->isUnderWay()) {
    EXPECT_EQ(shown(), before);
    slices->advance();
  }
  EXPECT_NE(shown(), before) << "the camera was turned";
}

}  // namespace
}  // namespace holdfast
