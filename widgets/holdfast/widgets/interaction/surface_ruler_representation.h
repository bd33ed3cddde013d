#pragma once
/// \file
/// Shows the distance between two points of a surface.

#include <memory>
#include <optional>
#include <string>

#include <vtkActor2D.h>
#include <vtkDistanceRepresentation2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/surface_handle_representation.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>

namespace holdfast {

/// A line with a ring at each end, on top of the picture, and a label with the distance now and at rest, as
/// "12.34 mm (rest 11.98)". A light halo, and a light ground under the label, tell both from dark and light surfaces.
/// With `ShowVector` the line is an arrow to end 1, and the label has its components: "5 mm: 3, 0, 4 (rest 4.9)".
class SurfaceRulerRepresentation : public vtkDistanceRepresentation2D {
 public:
  static SurfaceRulerRepresentation* New();
  vtkTypeMacro(SurfaceRulerRepresentation, vtkDistanceRepresentation2D)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Places both ends. Its surface, and the ratio of pixels, are set below.
  [[nodiscard]] SurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// What the ends lie on. They follow it where it has moved, and are forgotten where it is that of another mesh.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);

  /// The ends, 0 and 1.
  [[nodiscard]] SurfaceHandleRepresentation& GetHandle(int end) const;
  /// Whether both are placed.
  [[nodiscard]] bool IsPlaced() const;

  /// Model units; 0 before both ends are placed.
  double GetDistance() override;
  [[nodiscard]] double GetRestDistance() const;
  /// From end 0 to end 1; zero before both are placed.
  [[nodiscard]] Vector3 GetVector() const;

  /// Off by default.
  vtkSetMacro(ShowVector, bool);
  vtkGetMacro(ShowVector, bool);
  vtkBooleanMacro(ShowVector, bool);

  /// The user's name of the model's length, in UTF-8; empty by default.
  void SetUnits(const std::string& units);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }
  [[nodiscard]] std::string GetLabel();

  /// Pixels of the window for each of a display of ordinary resolution; 1 by default. Letters as well: the window's
  /// dots per inch do not count.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }

  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;

 protected:
  SurfaceRulerRepresentation();
  ~SurfaceRulerRepresentation() override;

 private:
  SurfaceRulerRepresentation(const SurfaceRulerRepresentation&) = delete;
  void operator=(const SurfaceRulerRepresentation&) = delete;

  void BuildLines();

  vtkNew<SurfacePointPlacer> Placer;
  std::string Units;
  bool ShowVector = false;
  bool IsInView = false;      // both ends are in front of the eye
  vtkNew<vtkPolyData> Lines;  // in pixels of the window
  vtkNew<vtkActor2D> Halo;
  vtkNew<vtkActor2D> Line;
};

}  // namespace holdfast
