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

/// A ring around a mark that differs for vertex, edge and face, and the outline of the edge or the face; hidden parts
/// of the outline are faint. The surface around the point does not cut the ring, a surface before it hides it.
class SurfacePointRepresentation : public vtkWidgetRepresentation {
 public:
  static SurfacePointRepresentation* New();
  vtkTypeMacro(SurfacePointRepresentation, vtkWidgetRepresentation)

  /// A point that is shown moves with the surface, and is removed where that is another mesh's
  /// (`VisibleSurface::isSameMesh`). Null, the default: nothing is shown.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Shows the location of `pick`; none, the default, and without a surface: nothing.
  void SetPreview(std::optional<SurfacePick> pick);
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview() const { return this->Preview; }

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
