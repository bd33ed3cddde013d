#pragma once
/// Draws a point of a surface: on a vertex, on an edge or in a face.

#include <memory>
#include <optional>

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Draws a ring around a mark, and the outline of the edge or the face. The mark differs for vertex, edge and face.
/// Hidden parts of the outline are faint. The surface around the point does not cut the ring, but a surface before it
/// hides it.
class vtkHoldfastSurfacePointRepresentation : public holdfast::DrawnByProps<vtkWidgetRepresentation> {
 public:
  static vtkHoldfastSurfacePointRepresentation* New();
  vtkTypeMacro(vtkHoldfastSurfacePointRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the surface. A point that is shown moves with it, and is removed where the surface is that of another mesh.
  /// With null, the default, no point is shown.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const holdfast::VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Shows the location of `pick`, which is copied. It shows nothing for null, the default, and while there is no
  /// surface.
  void SetPreview(const holdfast::SurfacePick* pick);
  /// Returns what is shown; null where nothing is. It is valid until another point is shown or the surface changes.
  [[nodiscard]] const holdfast::SurfacePick* GetPreview() const { return this->Preview ? &*this->Preview : nullptr; }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;

 protected:
  vtkHoldfastSurfacePointRepresentation();
  ~vtkHoldfastSurfacePointRepresentation() override = default;

 private:
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  std::optional<holdfast::SurfacePick> Preview;
  double PixelRatio = 1;
  holdfast::PointPreview Point;
  vtkNew<vtkPolyData> Outline;
  vtkNew<holdfast::BehindActor> LineBehind;
  vtkNew<holdfast::BlendedActor> LineHalo;
  vtkNew<holdfast::BlendedActor> Line;
};
