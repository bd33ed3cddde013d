#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/constraints/selector.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/edge_graph.h>

#include "interaction/drawn_curve.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/plain_curve.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

using test::DrawnCurve;
using testing::Contains;
using testing::ElementsAre;
using testing::Gt;
using testing::IsEmpty;
using testing::SizeIs;

TEST(CurveOnParts, PlacesOfAnotherPartAreRefused)
{
  DrawnCurve curve(test::merged(test::grid(4, 4), test::moved(test::grid(4, 4), {5, 0, 0})));
  curve.click({6, 8});
  curve.click(25 + 12);
  EXPECT_THAT(curve.widget->GetPlaces(), ElementsAre(6, 8));
  curve.mouse().moveTo(curve.fixture.pixelOfVertex(25 + 12));
  EXPECT_THAT(curve.curve().GetPreview(), IsEmpty());
  curve.click({18, 16});
  curve.mouse().key("Return");
  // Nor can one be dragged there.
  curve.mouse().drag({curve.fixture.pixelOfVertex(8), curve.fixture.pixelOfVertex(25 + 6)});
  EXPECT_THAT(curve.widget->GetPlaces(), ElementsAre(6, 8, 18, 16));
}

TEST(CurveOnSoup, PathsCrossFacesThatShareNoVertices)
{
  DrawnCurve curve(test::soup(test::grid(6, 6)));
  const Model& model = curve.fixture.model();
  const auto vertexAt = [&](double x, double y) {
    Index nearest = 0;
    (model.mesh.positions.rowwise() - Vector3(x, y, 0).transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return nearest;
  };
  const std::vector<Index> corners{vertexAt(1, 1), vertexAt(5, 1), vertexAt(5, 5)};
  curve.click(corners);
  curve.mouse().key("Return");
  ASSERT_TRUE(curve.widget->IsClosed());
  std::vector<Index> unknowns;
  for (const Index vertex : curve.widget->GetPath()) unknowns.push_back(model.solverMesh.weld.unknownOf[vertex]);
  std::vector<Index> expected;
  for (const Index vertex : corners) expected.push_back(model.solverMesh.weld.unknownOf[vertex]);
  EXPECT_EQ(unknowns, closedCurve(EdgeGraph(model.solverMesh), expected));
  // Corners at one place are one place.
  EXPECT_EQ(model.solverMesh.unknownCount(), 49);
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
    if (model.mesh.positions.row(v) != model.mesh.positions.row(corners[0])) continue;
    EXPECT_FALSE(curve.curve().InsertPlace(3, v));
  }
}

/// The head from the front.
struct CurveOnHead : testing::Test, DrawnCurve {
  CurveOnHead() : DrawnCurve(readMesh(test::dataFolder() + "/head.ply").mesh, 640, 480)
  {
    fixture.lookFromFront();
    fixture.renderer().GetActiveCamera()->Zoom(1.7);
  }

  [[nodiscard]] std::vector<Index> aroundAnEye() const
  {
    std::vector<Index> places;
    for (const Vector3& place :
         {Vector3(41, -76, 25), Vector3(27, -76, 39), Vector3(13, -76, 25), Vector3(27, -76, 11)}) {
      Index nearest = 0;
      (fixture.model().mesh.positions.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
      places.push_back(nearest);
    }
    return places;
  }
};

TEST_F(CurveOnHead, ACurveAroundAnEyeEnclosesWhatItsConstraintWould)
{
  const std::vector<Index> places = aroundAnEye();
  click(places);
  mouse().key("Return");
  ASSERT_EQ(told, places);
  nlohmann::json plain;
  InsideCurve inside;
  for (const Index vertex : told) {
    const Vector3 exact = fixture.model().mesh.positions.row(vertex).transpose();
    plain["through"].push_back({{"near", {exact.x(), exact.y(), exact.z()}}});
    inside.through.push_back(AtVertex{vertex});
  }
  const Model& model = fixture.model();
  SurfaceLocator locator(model.mesh, model.triangulation);
  const std::vector<Index> selected = Selector(model.mesh, model.solverMesh, locator).select({inside}, {});
  EXPECT_THAT(selected, SizeIs(Gt(10u)));
  EXPECT_EQ(std::set<long>(selected.begin(), selected.end()),
            test::insidePlain(plain, test::readPlainMesh(test::dataFolder() + "/head.ply")));
  for (const Index vertex : widget->GetPath()) EXPECT_THAT(selected, Contains(vertex));
}

/// How many of these places have a pixel beside them that is more red than blue by `difference`.
int countRed(vtkRenderWindow& window, const std::vector<DisplayPoint>& places, int difference)
{
  window.Render();
  const int width = window.GetSize()[0];
  vtkNew<vtkUnsignedCharArray> colors;
  window.GetPixelData(0, 0, width - 1, window.GetSize()[1] - 1, 0, colors);
  const auto isRed = [&](const DisplayPoint& place) {
    const vtkIdType pixel = 3 * (static_cast<vtkIdType>(place.y()) * width + static_cast<vtkIdType>(place.x()));
    return colors->GetValue(pixel) > colors->GetValue(pixel + 2) + difference;
  };
  return static_cast<int>(std::count_if(places.begin(), places.end(), [&](const DisplayPoint& place) {
    bool isAnyRed = false;
    for (int k = 0; k < 9; ++k) isAnyRed = isAnyRed || isRed(place + DisplayPoint(k % 3 - 1, k / 3 - 1));
    return isAnyRed;
  }));
}

constexpr int kSolidRed = 140;
constexpr int kFaintRed = 12;

TEST_F(CurveOnHead, NoneOfItSinksIntoTheSurface)
{
  click(aroundAnEye());
  mouse().key("Return");
  for (const double degrees : {0.0, 20.0, -35.0}) {
    fixture.renderer().GetActiveCamera()->Azimuth(degrees);
    std::vector<DisplayPoint> visible;
    for (const Index vertex : widget->GetPath())
      if (fixture.surface()->isVertexVisible(vertex, DisplayTransform(fixture.renderer())))
        visible.push_back(fixture.pixelOfVertex(vertex));
    EXPECT_THAT(visible, SizeIs(Gt(20u)));
    EXPECT_EQ(countRed(fixture.window(), visible, kSolidRed), static_cast<int>(visible.size())) << degrees;
  }
}

TEST_F(CurveOnHead, WhatLiesBehindIsFaint)
{
  click(aroundAnEye());
  mouse().key("Return");
  const std::vector<int> orange{199, 61, 0};
  const int inFront = fixture.countPixels(orange, 25);
  EXPECT_GT(inFront, 150);
  fixture.renderer().GetActiveCamera()->Azimuth(180);
  fixture.renderer().ResetCameraClippingRange();
  EXPECT_LT(fixture.countPixels(orange, 25), inFront / 20);
  std::vector<DisplayPoint> hidden;
  for (const Index vertex : widget->GetPath()) hidden.push_back(fixture.pixelOfVertex(vertex));
  EXPECT_EQ(countRed(fixture.window(), hidden, kSolidRed), 0);
  EXPECT_EQ(countRed(fixture.window(), hidden, kFaintRed), static_cast<int>(hidden.size()));
  widget->Off();
  EXPECT_EQ(countRed(fixture.window(), hidden, kFaintRed), 0);
}

}  // namespace
}  // namespace holdfast
