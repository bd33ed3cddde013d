#pragma once
/// The outline that selects a region of the surface.

#include <vector>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {

/// A closed line over the picture, light below dark, so that it is seen on every surface; or nothing (the default).
class RegionRepresentation : public DrawnByProps<vtkWidgetRepresentation> {
 public:
  static RegionRepresentation* New();
  vtkTypeMacro(RegionRepresentation, vtkWidgetRepresentation)

  /// A polygon that is filled faintly where `ScreenPolygon` has its inside. Corners are pixels as a cursor names them.
  void ShowPolygon(std::vector<DisplayPoint> corners) { this->Show(std::move(corners), true); }
  /// A circle, not filled, around the center of a pixel; radius in pixels of the window.
  void ShowCircle(const DisplayPoint& center, double radius);
  void ShowNothing() { this->Show({}, false); }
  /// Corners of what is shown.
  [[nodiscard]] const std::vector<DisplayPoint>& GetOutline() const { return this->Outline; }

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;

 protected:
  RegionRepresentation();
  ~RegionRepresentation() override = default;

 private:
  void Show(std::vector<DisplayPoint> outline, bool isFilled);

  std::vector<DisplayPoint> Outline;
  bool IsFilled = false;
  double PixelRatio = 1;
  vtkNew<vtkPolyData> FillData;  // in pixels of the window
  vtkNew<vtkPolyData> LineData;
  vtkNew<vtkActor2D> Fill;
  vtkNew<vtkActor2D> LightLine;
  vtkNew<vtkActor2D> DarkLine;
};

}  // namespace holdfast
