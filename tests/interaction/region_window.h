#pragma once
/// \file
/// A region widget in a window of VTK alone, and a selection that follows it.

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/widgets/interaction/vtkHoldfastRegionWidget.h>

#include "interaction/interaction_fixture.h"
#include "interaction/widget_events.h"
#include "support/meshes.h"

namespace holdfast::test {

/// A window with a region widget, and a selection that follows it as an observer is told to.
class RegionWindow {
 public:
  explicit RegionWindow(Mesh mesh, int width = 400, int height = 300) : fixture(std::move(mesh), width, height)
  {
    widget->SetSurface(fixture.surface());
    widget->SetRegions(std::make_shared<VertexRegions>(fixture.model().mesh, fixture.model().solverMesh));
    for (const unsigned long event : {kBegins, kMoves, kEnds, kCancels})
      widget->AddObserver(event, this, &RegionWindow::follow);
    fixture.enable(*widget);
  }

  void follow(vtkObject* /*widget*/, unsigned long event, void* callData)
  {
    const auto& data = *static_cast<RegionCallData*>(callData);
    if (event == kBegins) before = selected;
    if (event == kMoves || event == kEnds) selected = joined(before, data.reached, data.mode);
    if (event == kCancels) selected = before;
    events.push_back(event);
    reached.push_back(data.reached);
    modes.push_back(data.mode);
  }

  /// Leaves the interactor of the stage for another one.
  void listenTo(vtkRenderWindowInteractor& interactor)
  {
    widget->Off();
    interactor.SetRenderWindow(&fixture.window());
    interactor.SetInteractorStyle(nullptr);
    interactor.Initialize();
    widget->SetInteractor(&interactor);
    widget->SetCurrentRenderer(&fixture.renderer());
    widget->On();
  }

  [[nodiscard]] Mouse& mouse() { return fixture.mouse(); }
  [[nodiscard]] DisplayPoint pixelOf(double x, double y) const { return fixture.pixelOf({x, y, 0}); }
  [[nodiscard]] const std::vector<DisplayPoint>& outline() const
  {
    return widget->GetRegionRepresentation()->GetOutline();
  }
  /// Pixels between the places of the grid (0, 0) and (1, 0).
  [[nodiscard]] double pixelsOfUnit() const { return (pixelOf(1, 0) - pixelOf(0, 0)).norm(); }

  InteractionFixture fixture;
  vtkNew<vtkHoldfastRegionWidget> widget;
  std::vector<Index> before;
  std::vector<Index> selected;
  std::vector<unsigned long> events;
  std::vector<std::vector<Index>> reached;
  std::vector<SelectionMode> modes;
};

/// Vertex (i, j) of the grid is 11 j + i.
struct RegionsOfGrid : testing::Test, RegionWindow {
  RegionsOfGrid() : RegionWindow(grid(10, 8)) {}
};

}  // namespace holdfast::test
