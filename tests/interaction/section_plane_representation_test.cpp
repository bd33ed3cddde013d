#include <array>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkRenderWindow.h>

#include "holdfast/widgets/interaction/vtkHoldfastSectionPlaneRepresentation.h"
#include "interaction/interaction_fixture.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

/// A sphere of radius 1 that a plane cuts in half, seen from obliquely above the cut.
struct CutSphere : testing::Test, test::InteractionFixture {
  CutSphere() : InteractionFixture(test::icosphere(4))
  {
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetPosition(1, 3, 6);
    camera.SetFocalPoint(0, 0, 0);
    camera.SetParallelProjection(1);
    camera.SetParallelScale(2);
    renderer().ResetCameraClippingRange(-3, 3, -3, 3, -3, 3);
    widget->SetInteractor(&interactor());
    widget->SetRepresentation(plane);
    widget->SetDefaultRenderer(&renderer());
    std::array<double, 6> bounds{-1.5, 1.5, -1.5, 1.5, -1.5, 1.5};
    plane->SetPlaceFactor(1);
    plane->PlaceWidget(bounds.data());
    plane->SetOrigin(0, 0, 0);
    plane->SetNormal(0, 0, -1);
    plane->OutlineTranslationOff();
    plane->DrawOutlineOff();
    plane->SetSurface(
        std::make_shared<const VisibleSurface>(surface()->withSection(SectionPlane{{0, 0, 0}, {0, 0, -1}})));
    widget->On();
    window().Render();
  }

  ~CutSphere() override { widget->SetInteractor(nullptr); }

  [[nodiscard]] int stateAt(const Vector3& place)
  {
    const DisplayPoint pixel = pixelOf(place);
    plane->SetInteractionState(vtkImplicitPlaneRepresentation::Moving);
    return plane->ComputeInteractionState(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  }

  vtkNew<vtkImplicitPlaneWidget2> widget;
  vtkNew<vtkHoldfastSectionPlaneRepresentation> plane;
};

// On the plane: before the surface behind it, beside it, and what handles there are.
const Vector3 kBeforeSurface(0.5, -0.3, 0);
const Vector3 kBeside(1.3, 1.3, 0);
const Vector3 kTip(0, 0, -0.3 * 3 * 1.7320508);

TEST_F(CutSphere, ThePlaneTakesTheMouseBesideTheSurfaceAlone)
{
  EXPECT_EQ(stateAt(kBeforeSurface), vtkImplicitPlaneRepresentation::Outside);
  EXPECT_EQ(stateAt(kBeside), vtkImplicitPlaneRepresentation::Pushing);
  EXPECT_EQ(stateAt(Vector3::Zero()), vtkImplicitPlaneRepresentation::MovingOrigin);
  EXPECT_EQ(stateAt(kTip), vtkImplicitPlaneRepresentation::Rotating) << "behind the plane, too";
  EXPECT_EQ(stateAt(-kTip), vtkImplicitPlaneRepresentation::Rotating);
  EXPECT_EQ(stateAt(kBeforeSurface), vtkImplicitPlaneRepresentation::Outside);
}

TEST_F(CutSphere, WithoutASurfaceThePlaneTakesItEverywhere)
{
  plane->SetSurface(nullptr);
  EXPECT_EQ(stateAt(kBeforeSurface), vtkImplicitPlaneRepresentation::Pushing);
}

TEST_F(CutSphere, ADragBeforeTheSurfaceIsLeftToOthers)
{
  const test::EventLog moves(*widget, {vtkCommand::InteractionEvent});
  mouse().drag({pixelOf(kBeforeSurface), pixelOf(kBeforeSurface) + DisplayPoint(9, 20)});
  EXPECT_TRUE(moves.events().empty());
  EXPECT_EQ(Vector3(plane->GetOrigin()), Vector3::Zero());
  mouse().drag({pixelOf(kBeside), pixelOf(kBeside) + DisplayPoint(9, 20)});
  EXPECT_FALSE(moves.events().empty());
  EXPECT_NE(Vector3(plane->GetOrigin()).z(), 0);
}

}  // namespace
}  // namespace holdfast
