#include <algorithm>
#include <memory>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "widgets/plain_view.h"
#include "widgets/screen_vertices.h"

namespace holdfast {
namespace {

using test::Projection;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<DisplayPoint> rectangle(double left, double bottom, double right, double top)
{
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

const std::vector<DisplayPoint> kEverything = rectangle(-10, -10, 1000, 1000);

std::vector<Index> select(const Model& model, const test::PlainView& view, const std::vector<DisplayPoint>& polygon,
                          ScreenReach reach)
{
  const test::PlainScreen screen(view);
  return test::verticesInScreenPolygon(screen.renderer(), std::make_shared<const VisibleSurface>(model), polygon,
                                       reach);
}

TEST(ScreenSelection, OfASphereTheVisibleVerticesAreThoseOfFacesTurnedToTheEye)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  for (const Projection projection : {Projection::Perspective, Projection::Parallel}) {
    const test::PlainView view{{3, 4, 5}, {0, 0, 0}, projection};
    std::vector<bool> isTurned(static_cast<std::size_t>(model.mesh.vertexCount()), false);
    for (const Triangle& triangle : model.triangulation.triangles) {
      const Vector3 a = model.mesh.positions.row(triangle[0]);
      const Vector3 b = model.mesh.positions.row(triangle[1]);
      const Vector3 c = model.mesh.positions.row(triangle[2]);
      const Vector3 toEye = projection == Projection::Parallel ? view.eye : Vector3(view.eye - a);
      if ((b - a).cross(c - a).dot(toEye) > 0)
        for (const Index v : triangle) isTurned[v] = true;
    }
    std::vector<Index> expected;
    for (Index v = 0; v < model.mesh.vertexCount(); ++v)
      if (isTurned[v]) expected.push_back(v);
    EXPECT_EQ(select(model, view, kEverything, ScreenReach::VisibleOnly), expected);
    EXPECT_EQ(static_cast<Index>(select(model, view, kEverything, ScreenReach::Through).size()),
              model.mesh.vertexCount());
  }
}

TEST(ScreenSelection, VerticesAreThoseThatASearchThroughAllTrianglesSees)
{
  test::Random random(51);
  std::size_t total = 0;
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Model model = makeModel(named.mesh, named.name);
    const Vector3 middle = named.mesh.positions.colwise().mean().transpose();
    const Vector3 away(random.uniform(2, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const test::PlainView view{middle + away, middle};
    const std::vector<Index> visible = select(model, view, rectangle(150, 30, 300, 220), ScreenReach::VisibleOnly);
    const std::vector<Index> all = select(model, view, rectangle(150, 30, 300, 220), ScreenReach::Through);
    for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
      const Vector3 place = model.mesh.positions.row(v);
      const Vector3 shown = view.shown(place);
      const bool isInside = shown[2] > 0 && shown[0] > 150.5 && shown[0] < 300.5 && shown[1] > 30.5 && shown[1] < 220.5;
      EXPECT_EQ(std::binary_search(all.begin(), all.end(), v), isInside) << v;
      const auto isVisible =
          test::isPlainlyVisible(view, place, {v}, model.mesh.positions, model.triangulation.triangles);
      if (isVisible) {
        EXPECT_EQ(std::binary_search(visible.begin(), visible.end(), v), isInside && *isVisible) << v;
      }
    }
    total += visible.size();
  }
  EXPECT_GT(total, 60U);
}

TEST(ScreenSelection, PlatesHideWhatLiesBehindThemFromBothSides)
{
  const Mesh front = test::moved(test::grid(2, 2), {-1, -1, 0});
  const Model model = makeModel(test::merged(front, test::moved(front, {0, 0, -3})), "plates");
  const std::vector<Index> nine{0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<Index> others{9, 10, 11, 12, 13, 14, 15, 16, 17};
  const auto visibleFrom = [&](double z) {
    return select(model, {{0, 0, z}, {0, 0, 0}}, kEverything, ScreenReach::VisibleOnly);
  };
  EXPECT_EQ(visibleFrom(10), nine);
  EXPECT_EQ(visibleFrom(-13), others) << "seen from behind";
  EXPECT_EQ(select(model, {{0, 0, 10}, {0, 0, 0}}, kEverything, ScreenReach::Through).size(), 18U);
}

TEST(ScreenSelection, FollowsTheSurface)
{
  const Model model = makeModel(test::merged(test::grid(1, 1), test::moved(test::grid(1, 1), {0, 0, -1})), "plates");
  const test::PlainScreen screen({{0.5, 0.5, 10}, {0.5, 0.5, 0}});
  const auto visible = [&](const VisibleSurface& surface) {
    return test::verticesInScreenPolygon(screen.renderer(), std::make_shared<const VisibleSurface>(surface),
                                         kEverything, ScreenReach::VisibleOnly);
  };
  const VisibleSurface atRest(model);
  EXPECT_THAT(visible(atRest), ElementsAre(0, 1, 2, 3));
  Positions swapped = model.mesh.positions;
  swapped.bottomRows(4).col(2).setConstant(1);
  const VisibleSurface moved = atRest.movedTo(std::make_shared<const Positions>(swapped));
  EXPECT_THAT(visible(moved), ElementsAre(4, 5, 6, 7));
  EXPECT_THAT(visible(atRest), ElementsAre(0, 1, 2, 3)) << "what another was made from stays where it is";
}

TEST(ScreenSelection, VerticesThatNoFaceUsesAndThoseBehindTheEyeAreLeftOut)
{
  const Mesh mesh = test::withVertex(test::triangle({-1, -1, 0}, {1, -1, 0}, {0, 0, 20}), {0, 0, 1});
  const Model model = makeModel(mesh, "triangle");
  for (const Projection projection : {Projection::Perspective, Projection::Parallel})
    for (const ScreenReach reach : {ScreenReach::VisibleOnly, ScreenReach::Through})
      EXPECT_THAT(select(model, {{0, 0, 10}, {0, 0, 0}, projection}, kEverything, reach), ElementsAre(0, 1));
}

TEST(ScreenSelection, WhatLiesOutsideThePictureIsNotSelected)
{
  const Model model = makeModel(test::grid(40, 1), "grid");
  const test::PlainView view{{0, 0, 10}, {0, 0, 0}};
  const std::vector<Index> selected = select(model, view, kEverything, ScreenReach::Through);
  const std::vector<Index> expected{0, 1, 2, 3, 41, 42, 43, 44};
  EXPECT_EQ(selected, expected);
}

TEST(ScreenSelection, HolesOfALassoAreLeftOut)
{
  const Model model = makeModel(test::moved(test::grid(2, 2), {-1, -1, 0}), "grid");
  const test::PlainView view{{0, 0, 10}, {0, 0, 0}};
  std::vector<DisplayPoint> lasso = rectangle(50, 50, 350, 250);
  lasso.push_back(lasso.front());
  const std::vector<DisplayPoint> hole = rectangle(190, 140, 210, 160);
  lasso.insert(lasso.end(), hole.begin(), hole.end());
  lasso.push_back(hole.front());
  EXPECT_THAT(select(model, view, lasso, ScreenReach::VisibleOnly), ElementsAre(0, 1, 2, 3, 5, 6, 7, 8));
  EXPECT_THAT(select(model, view, hole, ScreenReach::VisibleOnly), ElementsAre(4));
  EXPECT_THAT(select(model, view, {}, ScreenReach::VisibleOnly), IsEmpty());
}

TEST(ScreenSelection, VerticesOfUnweldedFacesDoNotHideOneAnother)
{
  const Model whole = makeModel(test::box({1, 1, 1}, 3), "box");
  const Model parts = makeModel(test::soup(whole.mesh), "soup");
  const test::PlainView view{{3, 4, 5}, {0.5, 0.5, 0.5}};
  const std::vector<Index> visible = select(whole, view, kEverything, ScreenReach::VisibleOnly);
  std::vector<Index> expected;
  Index corner = 0;
  for (Index f = 0; f < whole.mesh.faces.size(); ++f)
    for (const Index v : whole.mesh.faces[f]) {
      if (std::binary_search(visible.begin(), visible.end(), v)) expected.push_back(corner);
      ++corner;
    }
  EXPECT_EQ(visible.size(), 37U);
  EXPECT_EQ(select(parts, view, kEverything, ScreenReach::VisibleOnly), expected);
}

}  // namespace
}  // namespace holdfast
