#include "holdfast/widgets/scene/kept_scene.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/widgets/scene/scene_contents.h>

#include "render/drawn_window.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

/// A box, and in a layer above, which shares camera and depths with it, a ball that it hides by half.
class KeptBox : public ::testing::Test {
 protected:
  using Colors = std::vector<unsigned char>;

  KeptBox()
  {
    window->SetNumberOfLayers(2);
    window->AddRenderer(above);
    addLights(*scene);
    contents.addTo(*scene);
    scene->ResetCamera();
    above->SetLayer(1);
    above->SetActiveCamera(scene->GetActiveCamera());
    above->PreserveDepthBufferOn();
    ball->SetRadius(0.7);
    ball->SetCenter(1, 1, 1);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(1, 0, 0);
    above->AddActor(actor);
    kept.emplace(*scene, *scene);
  }

  [[nodiscard]] Colors shown() { return test::pixelsOf(*window, test::DrawnBuffer::Front); }

  [[nodiscard]] Colors drawnWhole()
  {
    window->Render();
    return shown();
  }

  [[nodiscard]] Colors drawnAbove()
  {
    kept->drawLayersAbove();
    return shown();
  }

  /// The scene anew, with what is above it.
  [[nodiscard]] Colors drawnSmooth()
  {
    window->Render();
    return drawnAbove();
  }

  const Model model = makeModel(test::box({1, 1, 1}, 4), "box");
  SceneContents contents{model};
  const test::OffscreenWindow offscreen{{320, 240}};
  vtkRenderWindow* const window = &offscreen.window();
  vtkRenderer* const scene = &offscreen.renderer();
  vtkNew<vtkRenderer> above;
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkActor> actor;
  std::optional<KeptScene> kept;
};

TEST_F(KeptBox, LayersAboveAreDrawnOntoItAsIfAllWereDrawn)
{
  const Colors before = drawnSmooth();
  ball->SetCenter(0, 0.4, 1);
  const Colors moved = drawnAbove();
  EXPECT_NE(moved, before);
  EXPECT_EQ(moved, drawnSmooth());
  actor->VisibilityOff();
  EXPECT_EQ(drawnAbove(), drawnSmooth()) << "nothing of what was there stays behind";
}

TEST_F(KeptBox, EdgesAreSmoothedOnceWhateverIsDrawnAbove)
{
  actor->VisibilityOff();
  scene->GetActiveCamera()->Azimuth(25);
  scene->GetActiveCamera()->Elevation(20);
  const Colors rough = drawnWhole();
  EXPECT_TRUE(kept->isRough());
  const Colors smooth = drawnAbove();
  EXPECT_FALSE(kept->isRough());
  EXPECT_EQ(drawnAbove(), smooth) << "not once more";
  EXPECT_EQ(drawnWhole(), rough) << "a scene that is drawn is not smoothed by itself";

  // A pixel lies between its neighbours where a line or an outline passes; elsewhere nothing changes.
  int changed = 0;
  for (std::size_t k = 0; k < rough.size(); ++k) changed += rough[k] != smooth[k] ? 1 : 0;
  EXPECT_GT(changed, 1500) << "of " << rough.size();
  EXPECT_LT(changed, static_cast<int>(rough.size()) / 8);
}

TEST_F(KeptBox, SharpEdgesStaySolidWhenTheyAreSmoothed)
{
  constexpr int kDark = 90;
  constexpr int kFaint = 40;
  actor->VisibilityOff();
  scene->SetBackground(1, 1, 1);
  scene->GetActiveCamera()->Azimuth(25);
  scene->GetActiveCamera()->Elevation(20);
  const Colors rough = drawnWhole();
  const Colors smooth = drawnAbove();
  const int width = window->GetSize()[0];
  const auto green = [&](const Colors& colors, int x, int y) { return int{colors[3 * (y * width + x) + 1]}; };
  int lines = 0;
  int faint = 0;
  for (int y = 1; y + 1 < window->GetSize()[1]; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      if (green(rough, x, y) >= kDark) continue;
      int darkest = 255;
      for (int k = 0; k < 9; ++k) darkest = std::min(darkest, green(smooth, x + k % 3 - 1, y + k / 3 - 1));
      ++lines;
      faint += darkest > green(rough, x, y) + kFaint ? 1 : 0;
    }
  EXPECT_GT(lines, 200);
  EXPECT_LT(faint, lines / 50) << "of " << lines;
}

TEST_F(KeptBox, WhatIsNotKeptIsNotSmoothed)
{
  kept->setKeeping(false);
  static_cast<void>(drawnWhole());
  EXPECT_FALSE(kept->isRough());
}

TEST_F(KeptBox, IsKeptAsAWholeWhereTheLastOfItsLayersIsASmallPartOfTheWindow)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> axes;
  axes->SetMapper(mapper);
  vtkNew<vtkRenderer> corner;
  corner->AddActor(axes);
  corner->SetViewport(0.7, 0.7, 1, 1);
  corner->SetLayer(1);
  window->SetNumberOfLayers(3);
  window->AddRenderer(corner);
  above->SetLayer(2);
  kept.emplace(*scene, *corner);
  const Colors before = drawnSmooth();
  ball->SetCenter(-1, 0.4, 1);
  const Colors moved = drawnAbove();
  EXPECT_NE(moved, before);
  EXPECT_EQ(moved, drawnSmooth());
}

TEST_F(KeptBox, TheSceneIsNotDrawnForIt)
{
  static_cast<void>(drawnWhole());
  int count = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&count);
  counter->SetCallback([](vtkObject*, unsigned long, void* result, void*) { ++*static_cast<int*>(result); });
  scene->AddObserver(vtkCommand::StartEvent, counter);
  static_cast<void>(drawnAbove());
  EXPECT_EQ(count, 0) << "smoothing draws it no more than the layers above do";
  static_cast<void>(drawnWhole());
  EXPECT_EQ(count, 1);
}

TEST_F(KeptBox, IsCurrentUntilTheCameraMovesOrTheWindowHasAnotherSize)
{
  EXPECT_FALSE(kept->isCurrent());
  static_cast<void>(drawnWhole());
  EXPECT_TRUE(kept->isCurrent());
  scene->GetActiveCamera()->Azimuth(1);
  EXPECT_FALSE(kept->isCurrent());
  static_cast<void>(drawnWhole());
  EXPECT_TRUE(kept->isCurrent());
  window->SetSize(300, 240);
  EXPECT_FALSE(kept->isCurrent());
  const Colors before = drawnSmooth();
  ASSERT_TRUE(kept->isCurrent());
  EXPECT_EQ(drawnAbove(), before);
}

}  // namespace
}  // namespace holdfast
