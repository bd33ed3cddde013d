#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

namespace holdfast {
namespace {

/// How far from the middle of the picture a place is seen, along its larger side, in world units.
double reach(vtkCamera& camera, const Vector3& place)
{
  const Vector3 up = Vector3(camera.GetViewUp()).normalized();
  const Vector3 right = sightOf(camera).cross(up);
  const Vector3 away = place - Vector3(camera.GetFocalPoint());
  return std::max(std::abs(away.dot(up)), std::abs(away.dot(right)));
}

TEST(SphereCamera, PlacesAreInThePictureAndOnTheNearSide)
{
  const std::vector<Vector3> places{{0, 0, 1}, Vector3(1, 0, 2).normalized(), Vector3(0.3, 0.8, 1).normalized()};
  vtkNew<vtkCamera> camera;
  lookAtPlaces(*camera, places);
  for (const Vector3& place : places) {
    EXPECT_LT(reach(*camera, place), camera->GetParallelScale());
    EXPECT_LT(place.dot(sightOf(*camera)), 0);
  }
}

TEST(SphereCamera, WhatReachesAroundTheSphereShowsAllOfIt)
{
  vtkNew<vtkCamera> camera;
  lookAtPlaces(*camera, {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}});
  EXPECT_GT(camera->GetParallelScale(), 1);
  EXPECT_EQ(Vector3(camera->GetFocalPoint()), Vector3(0, 0, 0));
}

TEST(SphereCamera, ZoomHasBounds)
{
  vtkNew<vtkCamera> camera;
  lookAtPlaces(*camera, {{0, 0, 1}});
  const double before = camera->GetParallelScale();
  zoomSphere(*camera, 2);
  EXPECT_EQ(camera->GetParallelScale(), before / 2);
  for (int k = 0; k < 100; ++k) zoomSphere(*camera, 2);
  EXPECT_GT(camera->GetParallelScale(), 1e-3);
  for (int k = 0; k < 100; ++k) zoomSphere(*camera, 0.5);
  EXPECT_LT(camera->GetParallelScale(), 100);
}

}  // namespace
}  // namespace holdfast
