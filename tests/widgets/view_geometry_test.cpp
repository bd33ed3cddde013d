#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "support/point_constraints.h"
#include "widgets/view_without_window.h"

namespace holdfast {
namespace {

using test::Projection;
using test::ViewWithoutWindow;

TEST(ViewGeometry, PutsPlacesWhereVtkDoes)
{
  test::Random random(1);
  for (int k = 0; k < 40; ++k) {
    ViewWithoutWindow fixture;
    fixture.lookFrom(test::randomVector(random, 20), test::randomVector(random, 2),
                     k % 2 == 0 ? Projection::Parallel : Projection::Perspective);
    const ViewGeometry view = fixture.view();
    const Vector3 place = test::randomVector(random, 1);
    vtkRenderer& renderer = fixture.renderer();
    renderer.SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer.WorldToView();
    const double* const cube = renderer.GetViewPoint();
    const DisplayPoint expected((cube[0] + 1) / 2 * ViewWithoutWindow::kWidth,
                                (cube[1] + 1) / 2 * ViewWithoutWindow::kHeight);
    ASSERT_TRUE(toDisplay(view, place));
    EXPECT_LT((*toDisplay(view, place) - expected).norm(), 1e-6);
  }
}

TEST(ViewGeometry, RaysGoThroughThePlacesThatAreSeenThere)
{
  test::Random random(2);
  for (int k = 0; k < 40; ++k) {
    ViewWithoutWindow fixture;
    fixture.lookFrom(test::randomVector(random, 20), test::randomVector(random, 2),
                     k % 2 == 0 ? Projection::Parallel : Projection::Perspective);
    const ViewGeometry view = fixture.view();
    const Vector3 place = test::randomVector(random, 1);
    const ViewRay ray = rayThrough(view, *toDisplay(view, place));
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
    EXPECT_LT((place - ray.origin).cross(ray.direction).norm(), 1e-10);
    EXPECT_GT((place - ray.origin).dot(ray.direction), 0);
    EXPECT_LT(sightOf(view, place).cross(ray.direction).norm(), 1e-10);
  }
}

TEST(ViewGeometry, APixelIsAsLongAsTheStepToTheNextOne)
{
  test::Random random(3);
  for (int k = 0; k < 40; ++k) {
    ViewWithoutWindow fixture;
    fixture.lookFrom(test::randomVector(random, 20), test::randomVector(random, 2),
                     k % 2 == 0 ? Projection::Parallel : Projection::Perspective);
    const ViewGeometry view = fixture.view();
    const Vector3 place = test::randomVector(random, 1);
    const double pixel = worldPerPixel(view, place);
    for (const Vector3& across : {view.right, view.up})
      EXPECT_NEAR((*toDisplay(view, place + pixel * across) - *toDisplay(view, place)).norm(), 1, 1e-9);
    EXPECT_NEAR((*toDisplay(view, place + pixel * view.up) - *toDisplay(view, place)).y(), 1, 1e-9);
    EXPECT_NEAR((*toDisplay(view, place + pixel * view.right) - *toDisplay(view, place)).x(), 1, 1e-9);
  }
}

TEST(ViewGeometry, KnowsNothingOfClippingPlanes)
{
  ViewWithoutWindow fixture;
  fixture.lookFrom({3, 4, 5}, {0, 0, 0}, Projection::Perspective);
  const DisplayPoint before = *toDisplay(fixture.view(), {1, 0, 0.5});
  fixture.renderer().GetActiveCamera()->SetClippingRange(1e-6, 1e12);
  EXPECT_LT((*toDisplay(fixture.view(), {1, 0, 0.5}) - before).norm(), 1e-9);
}

TEST(ViewGeometry, WhatIsNotInFrontOfTheEyeIsNowhere)
{
  ViewWithoutWindow fixture;
  fixture.lookFrom({0, -10, 0}, {0, 0, 0}, Projection::Perspective);
  const ViewGeometry view = fixture.view();
  EXPECT_FALSE(toDisplay(view, {0, -11, 0}));
  EXPECT_FALSE(toDisplay(view, view.eye));
  EXPECT_EQ(worldPerPixel(view, {0, -11, 0}), 0);
}

}  // namespace
}  // namespace holdfast
