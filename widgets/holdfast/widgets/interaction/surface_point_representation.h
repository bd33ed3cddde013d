#pragma once
/// \file
/// Shows the point of a surface that a click would take.

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/picking/surface_picker.h>

namespace holdfast {

/// A ring around a mark that tells a vertex, an edge and a face apart, and the outline of the edge or the face. The
/// point is drawn as a whole in front of the surface around it and hidden by what lies before that; hidden parts of
/// the outline are faint.
class SurfacePointRepresentation : public vtkWidgetRepresentation {
 public:
  static SurfacePointRepresentation* New();
  vtkTypeMacro(SurfacePointRepresentation, vtkWidgetRepresentation)

  /// What the point lies on. A point that is shown stays at its location where the surface has moved, and goes where
  /// it is another one (`VisibleSurface::isSameMesh`). Null, the default: nothing is shown.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// The point, of which the location counts; none, the default, and without a surface: nothing is shown.
  void SetPreview(std::optional<SurfacePick> pick);
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview() const { return this->Preview; }

  /// Pixels of the window for each of a display of ordinary resolution; 1 by default.
  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;
  void GetActors(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;

 protected:
  SurfacePointRepresentation();
  ~SurfacePointRepresentation() override = default;

 private:
  void AddLines(vtkSmartPointer<vtkActor> actor, const Color& color);
  [[nodiscard]] std::vector<Index> OutlineVertices() const;

  std::shared_ptr<const VisibleSurface> Surface;
  std::optional<SurfacePick> Preview;
  double PixelRatio = 1;
  PointPreview Point;
  vtkNew<vtkPolyData> Outline;
  std::vector<vtkSmartPointer<vtkActor>> Lines;  // in the order in which they are drawn
};

}  // namespace holdfast
