#include <random>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <holdfast/widgets/camera/camera_state.h>

namespace holdfast {
namespace {

TEST(CameraState, ComesBackBitForBitFromEveryViewUp)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  const auto vector = [&] { return Vector3(coordinate(random), coordinate(random), coordinate(random)); };
  vtkNew<vtkCamera> camera;
  vtkNew<vtkCamera> other;
  int renormalized = 0;
  for (int k = 0; k < 20000; ++k) {
    const Camera state{vector(), vector(), vector(), 1 + vector().norm(), k % 2 == 0};
    place(*camera, state);
    const Camera kept = cameraOf(*camera);
    EXPECT_NEAR((kept.viewUp - state.viewUp.normalized()).norm(), 0, 1e-15);
    place(*other, kept);
    ASSERT_EQ(cameraOf(*other), kept) << "view up " << state.viewUp.transpose() << ", seed 1";
    camera->SetViewUp(state.viewUp.data());
    other->SetViewUp(camera->GetViewUp());
    renormalized += cameraOf(*other).viewUp == cameraOf(*camera).viewUp ? 0 : 1;
  }
  EXPECT_GT(renormalized, 0) << "the control: VTK alone gives every view up back";
}

}  // namespace
}  // namespace holdfast
