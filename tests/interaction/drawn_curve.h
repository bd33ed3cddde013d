#pragma once
/// \file
/// A curve widget in a window of VTK alone, and what it tells.

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/surface/edge_graph.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h>

#include "interaction/interaction_fixture.h"
#include "interaction/widget_events.h"
#include "support/meshes.h"

namespace holdfast::test {

/// A window with a curve widget.
class DrawnCurve {
 public:
  explicit DrawnCurve(Mesh mesh, int width = 400, int height = 300) : fixture(std::move(mesh), width, height)
  {
    widget->SetSurface(fixture.surface());
    widget->SetRegions(std::make_shared<VertexRegions>(fixture.model().mesh, fixture.model().solverMesh));
    for (const unsigned long event : {kBegins, kPlaces, kMoves, kChanges, kEnds, kCancels})
      widget->AddObserver(event, this, &DrawnCurve::hear);
    fixture.enable(*widget);
  }

  void hear(vtkObject* /*widget*/, unsigned long event, void* callData)
  {
    events.push_back(event);
    if (event == kPlaces)
      placed.push_back(*static_cast<Index*>(callData));
    else
      told = *static_cast<std::vector<Index>*>(callData);
  }

  [[nodiscard]] Mouse& mouse() { return fixture.mouse(); }
  [[nodiscard]] vtkHoldfastSurfaceCurveRepresentation& curve() { return *widget->GetSurfaceCurveRepresentation(); }
  void click(Index vertex) { mouse().click(fixture.pixelOfVertex(vertex)); }
  void click(const std::vector<Index>& vertices)
  {
    for (const Index vertex : vertices) click(vertex);
  }

  InteractionFixture fixture;
  vtkNew<vtkHoldfastSurfaceCurveWidget> widget;
  std::vector<unsigned long> events;
  std::vector<Index> placed;
  std::vector<Index> told;
};

/// Vertex (i, j) of the grid is 11 j + i.
struct CurveOnGrid : testing::Test, DrawnCurve {
  CurveOnGrid() : DrawnCurve(grid(10, 8)) {}

  [[nodiscard]] std::vector<Index> closedThrough(const std::vector<Index>& places)
  {
    return closedCurve(EdgeGraph(fixture.model().solverMesh), places);
  }
};

}  // namespace holdfast::test
