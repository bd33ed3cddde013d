#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>
#include <holdfast/window/panels/histogram_panel.h>
#include <holdfast/window/panels/sphere_panel.h>

#include "window_user.h"

namespace holdfast {
namespace {

class PanelDocksOfBar : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
  }

  [[nodiscard]] Index residualsShown() { return charts().residualView().histogram().valueCount; }
  [[nodiscard]] HistogramPanel& charts() { return find<HistogramPanel>("histogramPanel"); }
};

TEST_F(PanelDocksOfBar, OnlyPanelsInFrontFollowWhatIsShown)
{
  EXPECT_FALSE(charts().isVisible());
  EXPECT_FALSE(find<SpherePanel>("spherePanel").isVisible());
  EXPECT_EQ(residualsShown(), 0);

  openPanel("Distributions");
  EXPECT_TRUE(charts().isVisible());
  const auto all = static_cast<Index>(list().constraints.size());
  EXPECT_EQ(residualsShown(), all);

  openPanel("Constraints");
  EXPECT_FALSE(charts().isVisible());
  editor().edit("delete", removed(list(), {0}));
  ASSERT_TRUE(settle());
  EXPECT_EQ(residualsShown(), all) << "nobody looks";
  openPanel("Distributions");
  EXPECT_EQ(residualsShown(), all - 1);
}

TEST_F(PanelDocksOfBar, PanelsYieldToThePictureWhereTheWindowBecomesNarrower)
{
  window.resize(1600, 1000);
  ASSERT_TRUE(settle());
  window.resize(1024, 700);
  EXPECT_TRUE(test::waitUntil([this] { return viewport().width() >= 600; })) << viewport().width();
}

TEST_F(PanelDocksOfBar, NothingMovesFromTabToTab)
{
  const QRect picture = viewport().geometry();
  for (const char* const panel :
       {"Colours", "Rotations", "Distributions", "Constraints", "Conflicts", "Mesh", "Solution", "Selected"}) {
    openPanel(panel);
    ASSERT_TRUE(settle());
    EXPECT_EQ(viewport().geometry(), picture) << panel;
  }
}

class WarmedUpPanels : public PanelDocksOfBar {
 protected:
  void SetUp() override
  {
    window.warmUp();
    EXPECT_EQ(residualsShown(), 0) << "of the example";
    EXPECT_EQ(sphere().sphere(), nullptr);
    EXPECT_EQ(viewport().renderer().GetViewProps()->GetNumberOfItems(), 0);
    PanelDocksOfBar::SetUp();
  }

  [[nodiscard]] SpherePanel& sphere() { return find<SpherePanel>("spherePanel"); }
};

TEST_F(WarmedUpPanels, KeepNothingOfTheExample)
{
  openPanel("Distributions");
  EXPECT_EQ(residualsShown(), static_cast<Index>(list().constraints.size()));
  openPanel("Rotations");
  ASSERT_TRUE(test::waitUntil([&] { return sphere().isCurrent(); }));
  ASSERT_NE(sphere().sphere(), nullptr);
  EXPECT_GT(sphere().sphere()->placed().places.size(), 3000u);
  auto& view = find<QVTKOpenGLNativeWidget>("sphereView");
  EXPECT_EQ(view.renderWindow()->GetRenderers()->GetNumberOfItems(), 1);
}

}  // namespace
}  // namespace holdfast
