#pragma once
/// \file
/// A mesh as VTK draws it: a smooth surface with crisp edges, in one colour or coloured by values.

#include <vector>

#include <vtkNew.h>

#include <holdfast/view/color_map.h>
#include <holdfast/view/shaded_surface.h>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;

namespace holdfast {

/// The colour of surfaces without values.
inline constexpr Color kPlainColor{0.70, 0.73, 0.77};

/// The actors of one mesh: its surface and, as thin dark lines, its sharp edges and borders.
class MeshActor {
 public:
  /// At rest, in one colour. O(T log T).
  explicit MeshActor(const Model& model);
  ~MeshActor();
  MeshActor(const MeshActor&) = delete;
  MeshActor& operator=(const MeshActor&) = delete;

  /// Moves the mesh: one row for each vertex of the file. O(T).
  void setPositions(const Positions& positions);

  /// Colours by `values`, one for each vertex of the file. Between vertices the values are interpolated and then
  /// coloured; where some are NaN, the colours are interpolated.
  void setColors(const std::vector<double>& values, const ColorScale& scale);

  /// How many pixels of the window are one of the picture: widths of lines are in pixels of the picture.
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkActor& surface() const { return *surface_; }
  [[nodiscard]] vtkActor& edges() const { return *edges_; }

  /// The file vertex of each point that is drawn.
  [[nodiscard]] const std::vector<Index>& vertexOf() const noexcept { return shaded_.vertexOf; }

 private:
  ShadedSurface shaded_;
  vtkNew<vtkPolyData> surfaceData_;
  vtkNew<vtkPolyData> edgeData_;
  vtkNew<vtkPolyDataMapper> surfaceMapper_;
  vtkNew<vtkPolyDataMapper> edgeMapper_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkActor> edges_;
};

}  // namespace holdfast
