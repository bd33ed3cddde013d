#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/widgets/camera/camera_state.h>

#include "holdfast/widgets/interaction/vtkHoldfastOrientationWidget.h"
#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

struct OrientationOfGrid : testing::Test, test::InteractionFixture {
  OrientationOfGrid() : InteractionFixture(test::grid(4, 3))
  {
    window().SetNumberOfLayers(2);
    widget->SetParentRenderer(&renderer());
    widget->AnimateOff();
    widget->On();
    lookFromCorner();
  }

  ~OrientationOfGrid() override { widget->SetInteractor(nullptr); }

  void lookFromCorner()
  {
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetFocalPoint(2, 1.5, 0);
    camera.SetPosition(7, 5, 9);
    camera.SetViewUp(0, 1, 0);
    renderer().ResetCamera();
    window().Render();
  }

  void clickBall(int axis, bool isPositive)
  {
    vtkNew<vtkPropCollection> parts;
    widget->GetOrientationRepresentation()->GetActors(parts);
    // The container, and for each axis the shafts and two balls.
    auto* ball = vtkActor::SafeDownCast(parts->GetItemAsObject(1 + 3 * axis + (isPositive ? 1 : 2)));
    mouse().click(toDisplay(*widget->GetDefaultRenderer(), Vector3(ball->GetCenter())).head<2>());
    window().Render();
  }

  [[nodiscard]] Vector3 sight() const { return Vector3(renderer().GetActiveCamera()->GetDirectionOfProjection()); }

  vtkNew<vtkHoldfastOrientationWidget> widget;
};

TEST_F(OrientationOfGrid, ABallLooksFromItsEndAndTheOneThatFacesTheViewerFromBehind)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      lookFromCorner();
      clickBall(axis, side > 0);
      EXPECT_LT((sight() + side * Vector3::Unit(axis)).norm(), 1e-6);
      lookFromCorner();
      clickBall(axis, side > 0);
      EXPECT_LT((sight() + side * Vector3::Unit(axis)).norm(), 1e-6) << "whatever was clicked before";
      clickBall(axis, side > 0);
      EXPECT_LT((sight() - side * Vector3::Unit(axis)).norm(), 1e-6);
    }
}

/// Returns when each part of a representation was made, as GPUs are told.
std::vector<vtkMTimeType> makingsOf(vtkCameraOrientationRepresentation& representation)
{
  vtkNew<vtkPropCollection> parts;
  representation.GetActors(parts);
  std::vector<vtkMTimeType> times;
  for (int k = 0; k < parts->GetNumberOfItems(); ++k) {
    auto& part = *vtkActor::SafeDownCast(parts->GetItemAsObject(k));
    times.push_back(part.GetMapper()->GetInputAsDataSet()->GetMTime());
    if (part.GetTexture() != nullptr) times.push_back(part.GetTexture()->GetInput()->GetMTime());
  }
  return times;
}

TEST_F(OrientationOfGrid, NoPartIsMadeAnewWhereTheCameraTurns)
{
  const auto before = makingsOf(*widget->GetOrientationRepresentation());
  renderer().GetActiveCamera()->Azimuth(30);
  window().Render();
  EXPECT_EQ(makingsOf(*widget->GetOrientationRepresentation()), before);
  // The control.
  vtkNew<vtkCameraOrientationWidget> ofVtk;
  ofVtk->SetParentRenderer(&renderer());
  ofVtk->On();
  window().Render();
  auto& balls = *vtkCameraOrientationRepresentation::SafeDownCast(ofVtk->GetRepresentation());
  const auto ofBefore = makingsOf(balls);
  renderer().GetActiveCamera()->Azimuth(30);
  window().Render();
  EXPECT_NE(makingsOf(balls), ofBefore);
  ofVtk->SetInteractor(nullptr);
}

TEST_F(OrientationOfGrid, BallsAndLettersAreWhereVtkHasThem)
{
  const auto corner = [&] {
    lookFromCorner();
    vtkNew<vtkUnsignedCharArray> colors;
    window().GetPixelData(240, 150, 399, 299, 0, colors);
    return std::vector<unsigned char>(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
  };
  const auto differing = [](const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) {
    int count = 0;
    for (std::size_t k = 0; k < a.size(); ++k) count += std::abs(a[k] - b[k]) > 40 ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(a.size());
  };
  const auto ours = corner();
  widget->GetRepresentation()->VisibilityOff();
  const auto empty = corner();
  vtkNew<vtkCameraOrientationWidget> ofVtk;
  ofVtk->SetParentRenderer(&renderer());
  ofVtk->On();
  const auto theirs = corner();
  ofVtk->SetInteractor(nullptr);
  EXPECT_GT(differing(empty, theirs), 0.01);
  EXPECT_LT(differing(ours, theirs), 0.1 * differing(empty, theirs)) << "edges of letters alone";
}

TEST_F(OrientationOfGrid, HasItsSizeInPixelsOfTheDisplay)
{
  const auto size = [&] {
    window().Render();
    return Eigen::Vector2i(widget->GetDefaultRenderer()->GetSize());
  };
  widget->SetPixelRatio(1);
  EXPECT_NEAR(size().x(), 120, 1);
  EXPECT_NEAR(size().y(), 120, 1);
  widget->SetPixelRatio(1.5);
  EXPECT_NEAR(size().x(), 180, 1);
  EXPECT_NEAR(size().y(), 180, 1);
}

}  // namespace
}  // namespace holdfast
