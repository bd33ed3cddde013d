#pragma once
/// Draws a ruler between two points of a surface.

#include <memory>
#include <string>

#include <vtkActor2D.h>
#include <vtkDistanceRepresentation2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Draws a line with a ring at each end, on top of the picture. A label has the distance now and at rest, as "12.34 mm
/// (rest 11.98)". With `ShowVector` the line is an arrow to end 1, and the label has its components: "5 mm: 3, 0, 4
/// (rest 4.9)".
class vtkHoldfastSurfaceRulerRepresentation : public vtkDistanceRepresentation2D {
 public:
  static vtkHoldfastSurfaceRulerRepresentation* New();
  vtkTypeMacro(vtkHoldfastSurfaceRulerRepresentation, vtkDistanceRepresentation2D)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns the placer of both ends. Set its surface and its ratio of pixels by the functions below.
  [[nodiscard]] vtkHoldfastSurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// Sets the surface. The ends move with it, and are removed where it is that of another mesh.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);

  /// Returns an end, 0 or 1.
  [[nodiscard]] vtkHoldfastSurfaceHandleRepresentation& GetHandle(int end) const
  {
    return *static_cast<vtkHoldfastSurfaceHandleRepresentation*>(end == 0 ? this->Point1Representation
                                                                          : this->Point2Representation);
  }
  /// Tells whether both ends are placed.
  [[nodiscard]] bool IsPlaced() const
  {
    return this->GetHandle(0).GetPlacement() != nullptr && this->GetHandle(1).GetPlacement() != nullptr;
  }

  /// Return the distance now and at rest, in model units; 0 before both ends are placed.
  double GetDistance() override { return this->GetVector().stableNorm(); }
  [[nodiscard]] double GetRestDistance() const
  {
    return this->IsPlaced() ? (this->GetHandle(0).GetRestPlace() - this->GetHandle(1).GetRestPlace()).stableNorm() : 0;
  }
  /// Returns the vector from end 0 to end 1; zero before both are placed.
  [[nodiscard]] holdfast::Vector3 GetVector() const
  {
    return this->IsPlaced() ? holdfast::Vector3(this->GetHandle(1).GetPlace() - this->GetHandle(0).GetPlace())
                            : holdfast::Vector3::Zero();
  }

  /// Sets whether the line is an arrow and the label has its components; off by default.
  vtkSetMacro(ShowVector, bool);
  vtkGetMacro(ShowVector, bool);
  vtkBooleanMacro(ShowVector, bool);

  /// Sets the user's name of the model's length, in UTF-8; empty by default.
  vtkSetMacro(Units, std::string);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }
  [[nodiscard]] std::string GetLabel();
  /// Sets whether VTK draws the label; on by default. A window that writes in a font of its own switches it off.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);

  /// Sets the number of window pixels for each pixel of ordinary resolution. The window's dots per inch do not change
  /// sizes.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }

  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;

 protected:
  vtkHoldfastSurfaceRulerRepresentation();
  ~vtkHoldfastSurfaceRulerRepresentation() override = default;

 private:
  void BuildLines();

  vtkNew<vtkHoldfastSurfacePointPlacer> Placer;
  std::string Units;
  bool ShowVector = false;
  bool LabelVisibility = true;
  bool IsInView = false;      // both ends are in front of the eye
  vtkNew<vtkPolyData> Lines;  // in pixels of the window
  vtkNew<vtkActor2D> Halo;
  vtkNew<vtkActor2D> Line;
};
