#pragma once
/// VTK draws a mesh as a smooth surface with crisp edges, in one colour or coloured by values.

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/mesh/actor_slices.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/coarse_surface.h>
#include <holdfast/widgets/mesh/section_plane.h>
#include <holdfast/widgets/mesh/shaded_surface.h>

namespace holdfast {

/// Surfaces without values have this colour.
inline constexpr Color kPlainColor{0.70, 0.73, 0.77};

/// The edges that are drawn as lines.
enum class MeshEdges {
  Sharp,  ///< the sharp ones and borders
  All,    ///< those of all polygons of the file as well
  None    ///< no edges, not even the sharp ones and borders
};

/// The way in which the triangles are drawn. Only shaded ones hide what is behind them.
enum class SurfaceDisplay { Shaded, Wireframe, Points };

/// The detail with which a large mesh is drawn.
enum class Detail {
  Full,
  /// About `kCoarseTriangles` of its triangles are drawn, and of its edges the sharp ones. This is for what moves.
  Coarse
};

/// The actors of one mesh. One is its surface. Others are its sharp edges and borders as thin dark lines.
///
///     MeshActor mesh(model);
///     mesh.setPositions(result.positions);
///     mesh.setColors(coloring.values, coloring.scale);
///     renderer->AddActor(&mesh.surface());
///     renderer->AddActor(&mesh.edges());
class MeshActor {
 public:
  /// Makes the actors of the mesh at rest, in one colour. `model` must stay alive as long as they. `shaded` was cut
  /// from `model`. Where it is null, the surface is cut here, O(T log T).
  explicit MeshActor(const Model& model, std::shared_ptr<const ShadedSurface> shaded = nullptr);
  ~MeshActor();

  /// Moves the mesh. `positions` has one row for each vertex of the file. O(T). In coarse detail most of that work
  /// waits for the full one.
  void setPositions(const Positions& positions);

  /// Colours the mesh by `values`, one for each vertex of the file. Between vertices the values are interpolated and
  /// then coloured. Where some are NaN, the colours are interpolated. `pointValues` has one value for each point that
  /// is drawn. Unless it is empty, it takes the place of `values`.
  void setColors(const std::vector<double>& values, const ColorScale& scale,
                 const std::vector<double>& pointValues = {});

  /// Draws the mesh in one colour again.
  void clearColors();

  void setMeshEdges(MeshEdges edges);
  void setSurfaceDisplay(SurfaceDisplay display);
  /// Switches the detail. That costs next to nothing once there are coarse triangles.
  void setDetail(Detail detail);
  /// Tells whether the triangles of `coarse` are drawn. A small part of a large mesh is drawn as it is.
  [[nodiscard]] bool isCoarse() const;
  /// Says where the eye is. In coarse detail the backs of a solid are left out while the eye is outside the box around
  /// it. They are drawn where a section opens it. Without a GPU that saves a third of the time.
  void lookFrom(const Vector3& eye);

  /// Returns the slices of `surface` in full detail. They are drawn a part at a time until the next `setDetail`.
  [[nodiscard]] ActorSlices& surfaceSlices() { return surfaceSlices_; }
  /// Returns the slices of `meshEdges`, likewise.
  [[nodiscard]] ActorSlices& meshEdgeSlices() { return meshEdgeSlices_; }

  /// Draws only what a plane keeps. Without a plane, draws everything. Moving the plane costs next to nothing.
  void setSection(const std::optional<SectionPlane>& section);
  /// Returns the planes of `setSection`, for other actors on the mesh.
  [[nodiscard]] vtkPlaneCollection& sectionPlanes() const { return *sectionPlanes_; }

  /// Leaves out the triangles for which `isHidden` holds. It has one entry for each triangle. An empty vector draws
  /// all. Tints on the mesh must be set again afterwards. O(T).
  void setHidden(std::vector<char> isHidden);
  /// Leaves out the same triangles as another actor of the mesh. O(1) unless all edges of this one are drawn.
  void setHiddenAs(const MeshActor& other);

  /// Sets how many pixels of the window are one of the picture. Widths of lines are in pixels of the picture.
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkActor& surface() const { return *surface_; }
  [[nodiscard]] vtkActor& edges() const { return *edges_; }
  /// Returns the actor of the lines of `MeshEdges::All`.
  [[nodiscard]] vtkActor& meshEdges() const { return *meshEdges_; }

  [[nodiscard]] const Model& model() const noexcept { return model_; }

  /// Returns the vertex of the file for each point that is drawn.
  [[nodiscard]] const std::vector<Index>& vertexOf() const noexcept { return shaded_->vertexOf; }
  [[nodiscard]] const std::shared_ptr<const ShadedSurface>& shaded() const noexcept { return shaded_; }
  /// Tells whether a triangle of `shaded` is left out.
  [[nodiscard]] bool isHidden(Index triangle) const { return !isHidden_.empty() && isHidden_[triangle] != 0; }

  /// Returns the points that are drawn, for other actors on the mesh.
  [[nodiscard]] vtkPoints& points() const { return *points_; }
  /// Returns the normals that are drawn. In coarse detail they may be older than the points.
  [[nodiscard]] vtkFloatArray& normals() const { return *normals_; }
  /// Returns the mesh in coarse detail, which moves with the mesh. The first call makes it, O(T log T).
  [[nodiscard]] const CoarseSurface& coarse() const;

 private:
  void update();
  void draw(vtkCellArray* triangles, vtkCellArray* creases);
  void updateNormals();
  void colorCoarse();
  [[nodiscard]] std::vector<std::array<Index, 2>> polygonEdges() const;

  const Model& model_;
  std::shared_ptr<const ShadedSurface> shaded_;
  std::vector<char> isHidden_;                          // of each triangle; empty where all are drawn
  Positions places_;                                    // of the points: what VTK draws lies here
  std::unique_ptr<AreaWeightedNormals> doubleNormals_;  // at the points
  MeshEdges meshEdgesShown_ = MeshEdges::Sharp;
  Detail detail_ = Detail::Full;
  std::optional<Vector3> eye_;
  bool areNormalsOld_ = true;  // older than the places
  mutable bool isCoarseOld_ = true;
  mutable std::unique_ptr<CoarseSurface> coarse_;
  vtkNew<vtkPlane> sectionPlane_;
  vtkNew<vtkPlaneCollection> sectionPlanes_;  // none, or that one
  vtkNew<vtkDoubleArray> coordinates_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkPolyData> surfaceData_;
  vtkNew<vtkPolyData> edgeData_;
  vtkNew<vtkPolyData> meshEdgeData_;
  vtkNew<vtkPolyDataMapper> surfaceMapper_;
  vtkNew<vtkPolyDataMapper> coarseMapper_;
  vtkNew<vtkPolyDataMapper> edgeMapper_;
  vtkNew<vtkPolyDataMapper> meshEdgeMapper_;
  vtkNew<PushedActor> surface_;
  vtkNew<BlendedActor> edges_;
  vtkNew<BlendedActor> meshEdges_;
  ActorSlices surfaceSlices_{*surface_, *surfaceMapper_};
  ActorSlices meshEdgeSlices_{*meshEdges_, *meshEdgeMapper_};
};

}  // namespace holdfast
