#include <cstdint>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/display_transform.h>

#include "support/point_constraints.h"
#include "support/random.h"
#include "widgets/plain_view.h"
#include "widgets/view_without_window.h"

namespace holdfast {
namespace {

using test::Projection;
using test::ViewWithoutWindow;

Vector3 randomPlace(test::Random& random, double size)
{
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

TEST(DisplayTransform, PlacesAreShownWhereTheCameraSaysItsParameters)
{
  test::Random random(31);
  for (const Projection projection : {Projection::Perspective, Projection::Parallel})
    for (int k = 0; k < 50; ++k) {
      const test::PlainView view{randomPlace(random, 9), randomPlace(random, 2), projection};
      const test::PlainScreen screen(view);
      const DisplayTransform display(screen.renderer());
      const Vector3 place = randomPlace(random, 3);
      const Vector3 expected = view.shown(place);
      const DisplayTransform::Shown shown = display.show(place);
      EXPECT_NEAR(shown.depth, expected[2], 1e-12);
      if (expected[2] < 0.1) continue;
      EXPECT_NEAR(shown.point.x(), expected[0], 1e-9);
      EXPECT_NEAR(shown.point.y(), expected[1], 1e-9);
    }
}

TEST(DisplayTransform, RaysLeadThroughWhatIsShownThere)
{
  test::Random random(32);
  for (const Projection projection : {Projection::Perspective, Projection::Parallel})
    for (int k = 0; k < 50; ++k) {
      const test::PlainView view{randomPlace(random, 9), randomPlace(random, 2), projection};
      const test::PlainScreen screen(view);
      const DisplayTransform display(screen.renderer());
      const DisplayPoint point(random.uniform(0, view.width), random.uniform(0, view.height));
      const double depth = random.uniform(0.1, 20);
      const Vector3 place = view.placeAt(point, depth);
      const Ray ray = display.rayThrough(point);
      EXPECT_NEAR((ray.origin + depth * ray.direction - place).norm(), 0, 1e-12 * (1 + depth));
      const Ray toPlace = display.rayTo(place);
      EXPECT_NEAR((toPlace.origin - ray.origin).norm(), 0, 1e-12 * (1 + depth));
      EXPECT_NEAR((toPlace.origin + toPlace.direction - place).norm(), 0, 1e-14 * (1 + depth));
    }
}

TEST(DisplayTransform, RaysDoNotDependOnTheClippingRange)
{
  const test::PlainView view;
  const test::PlainScreen screen(view);
  const DisplayTransform before(screen.renderer());
  screen.renderer().ResetCameraClippingRange(-1, 1, -1, 1, -1, 1);
  const DisplayTransform after(screen.renderer());
  const Ray a = before.rayThrough({12.5, 200.5});
  const Ray b = after.rayThrough({12.5, 200.5});
  EXPECT_NEAR((a.origin - b.origin).norm(), 0, 1e-13);
  EXPECT_NEAR((a.direction - b.direction).norm(), 0, 1e-13);
}

TEST(DisplayTransform, PartsOfAWindowShowTheSameElsewhere)
{
  const test::PlainView whole;
  test::PlainView half = whole;
  half.width = 200;
  const test::PlainScreen screen(whole);
  screen.renderer().SetViewport(0.5, 0, 1, 1);
  const DisplayTransform display(screen.renderer());
  const Vector3 place(0.3, -0.2, 0.7);
  const Vector3 expected = half.shown(place);
  EXPECT_NEAR(display.show(place).point.x(), 200 + expected[0], 1e-9);
  EXPECT_NEAR(display.show(place).point.y(), expected[1], 1e-9);
  EXPECT_TRUE(display.isInside({201, 10}));
  EXPECT_FALSE(display.isInside({199, 10}));
  EXPECT_FALSE(display.isInside({300, 301}));
}

/// Calls `check(fixture, view, place)` for views from anywhere, of both projections, and a place that is seen in each.
template <class Check>
void forEachView(std::uint32_t seed, const Check& check)
{
  test::Random random(seed);
  for (int k = 0; k < 40; ++k) {
    ViewWithoutWindow fixture;
    fixture.lookFrom(test::randomVector(random, 20), test::randomVector(random, 2),
                     k % 2 == 0 ? Projection::Parallel : Projection::Perspective);
    const DisplayTransform view = fixture.view();
    const Vector3 place = test::randomVector(random, 1);
    check(fixture, view, place);
  }
}

TEST(DisplayTransform, PutsPlacesWhereVtkDoes)
{
  forEachView(1, [](ViewWithoutWindow& fixture, const DisplayTransform& view, const Vector3& place) {
    vtkRenderer& renderer = fixture.renderer();
    renderer.SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer.WorldToView();
    const double* const cube = renderer.GetViewPoint();
    const DisplayPoint expected((cube[0] + 1) / 2 * ViewWithoutWindow::kWidth,
                                (cube[1] + 1) / 2 * ViewWithoutWindow::kHeight);
    ASSERT_TRUE(toDisplay(view, place));
    EXPECT_LT((*toDisplay(view, place) - expected).norm(), 1e-6);
  });
}

TEST(DisplayTransform, RaysGoThroughThePlacesThatAreSeenThere)
{
  forEachView(2, [](ViewWithoutWindow& /*fixture*/, const DisplayTransform& view, const Vector3& place) {
    const Ray ray = view.rayThrough(*toDisplay(view, place));
    EXPECT_LT((place - ray.origin).cross(ray.direction.normalized()).norm(), 1e-10);
    EXPECT_GT((place - ray.origin).dot(ray.direction), 0);
    EXPECT_LT(view.sightOf(place).cross(ray.direction.normalized()).norm(), 1e-10);
    EXPECT_NEAR(view.sightOf(place).norm(), 1, 1e-12);
  });
}

TEST(DisplayTransform, APixelIsAsLongAsTheStepToTheNextOne)
{
  forEachView(3, [](ViewWithoutWindow& /*fixture*/, const DisplayTransform& view, const Vector3& place) {
    const double pixel = view.worldPerPixel(place);
    for (const Vector3& across : {view.right(), view.up()})
      EXPECT_NEAR((*toDisplay(view, place + pixel * across) - *toDisplay(view, place)).norm(), 1, 1e-9);
    EXPECT_NEAR((*toDisplay(view, place + pixel * view.up()) - *toDisplay(view, place)).y(), 1, 1e-9);
    EXPECT_NEAR((*toDisplay(view, place + pixel * view.right()) - *toDisplay(view, place)).x(), 1, 1e-9);
  });
}

TEST(DisplayTransform, KnowsNothingOfClippingPlanes)
{
  ViewWithoutWindow fixture;
  fixture.lookFrom({3, 4, 5}, {0, 0, 0}, Projection::Perspective);
  const DisplayPoint before = *toDisplay(fixture.view(), {1, 0, 0.5});
  fixture.renderer().GetActiveCamera()->SetClippingRange(1e-6, 1e12);
  EXPECT_LT((*toDisplay(fixture.view(), {1, 0, 0.5}) - before).norm(), 1e-9);
}

TEST(DisplayTransform, WhatIsNotInFrontOfTheEyeIsNowhere)
{
  ViewWithoutWindow fixture;
  fixture.lookFrom({0, -10, 0}, {0, 0, 0}, Projection::Perspective);
  const DisplayTransform view = fixture.view();
  EXPECT_FALSE(toDisplay(view, {0, -11, 0}));
  EXPECT_FALSE(toDisplay(view, view.eye()));
  EXPECT_EQ(view.worldPerPixel({0, -11, 0}), 0);
}

}  // namespace
}  // namespace holdfast
