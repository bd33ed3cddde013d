#pragma once
/// Draws the outline by which a region is selected.

#include <vector>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>

/// Draws a closed line over the picture, or nothing (the default). The line is light below dark, so that it is seen on
/// every surface.
class vtkHoldfastRegionRepresentation : public holdfast::DrawnByProps<vtkWidgetRepresentation> {
 public:
  static vtkHoldfastRegionRepresentation* New();
  vtkTypeMacro(vtkHoldfastRegionRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Shows a polygon, filled faintly where `ScreenPolygon` has its inside. The corners are pixels as a cursor names
  /// them.
  void ShowPolygon(std::vector<holdfast::DisplayPoint> corners) { this->Show(std::move(corners), true); }
  /// Shows a circle around the centre of a pixel, not filled. The radius is in pixels of the window.
  void ShowCircle(const holdfast::DisplayPoint& center, double radius)
  {
    constexpr int kCorners = 72;
    this->Show(holdfast::circle(center, radius, kCorners), false);
  }
  void ShowNothing() { this->Show({}, false); }
  [[nodiscard]] const std::vector<holdfast::DisplayPoint>& GetOutline() const { return this->Outline; }

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;

 protected:
  vtkHoldfastRegionRepresentation();
  ~vtkHoldfastRegionRepresentation() override = default;

 private:
  void Show(std::vector<holdfast::DisplayPoint> outline, bool isFilled);

  std::vector<holdfast::DisplayPoint> Outline;
  bool IsFilled = false;
  double PixelRatio = 1;
  vtkNew<vtkPolyData> FillData;  // in pixels of the window
  vtkNew<vtkPolyData> LineData;
  vtkNew<vtkActor2D> Fill;
  vtkNew<vtkActor2D> LightLine;
  vtkNew<vtkActor2D> DarkLine;
};
