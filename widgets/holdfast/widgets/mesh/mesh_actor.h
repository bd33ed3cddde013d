#pragma once
/// A mesh as VTK draws it: a smooth surface with crisp edges, in one colour or coloured by values.

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

/// The colour of surfaces without values.
inline constexpr Color kPlainColor{0.70, 0.73, 0.77};

/// Which edges are drawn as lines besides the sharp ones and borders.
enum class MeshEdges {
  Sharp,  ///< none
  All,    ///< those of all polygons of the file
  None    ///< not even the sharp ones and borders
};

/// How the triangles are drawn. Only shaded ones hide what is behind them.
enum class SurfaceDisplay { Shaded, Wireframe, Points };

/// How much of a large mesh is drawn.
enum class Detail {
  Full,
  Coarse  ///< about `kCoarseTriangles` of its triangles, and of its edges the sharp ones: for what moves
};

/// The actors of one mesh: its surface and, as thin dark lines, its sharp edges and borders.
class MeshActor {
 public:
  /// At rest, in one colour. `model` stays alive as long as this. `shaded` was cut from it; if null it is, O(T log T).
  explicit MeshActor(const Model& model, std::shared_ptr<const ShadedSurface> shaded = nullptr);
  ~MeshActor();

  /// Moves the mesh: one row for each vertex of the file. O(T); in coarse detail most of it waits for the full one.
  void setPositions(const Positions& positions);

  /// Colours by `values`, one for each vertex of the file. Between vertices the values are interpolated and then
  /// coloured; where some are NaN, the colours are interpolated. `pointValues`, one for each point that is drawn, take
  /// the place of those of vertices where there are any.
  void setColors(const std::vector<double>& values, const ColorScale& scale,
                 const std::vector<double>& pointValues = {});

  void clearColors();

  void setMeshEdges(MeshEdges edges);
  void setSurfaceDisplay(SurfaceDisplay display);
  /// Switching costs next to nothing once there are coarse triangles.
  void setDetail(Detail detail);
  /// Whether the triangles of `coarse` are drawn. A small part of a large mesh is drawn as it is.
  [[nodiscard]] bool isCoarse() const;
  /// In coarse detail the backs of a solid are not drawn while the eye is outside the box around it and no section
  /// opens it, which saves a third of the time without a GPU.
  void lookFrom(const Vector3& eye);

  /// `surface` and `meshEdges` in full detail, a part at a time, until the next `setDetail`.
  [[nodiscard]] ActorSlices& surfaceSlices() { return surfaceSlices_; }
  [[nodiscard]] ActorSlices& meshEdgeSlices() { return meshEdgeSlices_; }

  /// Draws only what a plane keeps; none: everything. Moving the plane costs next to nothing.
  void setSection(const std::optional<SectionPlane>& section);
  /// The planes of `setSection`, for other actors on the mesh.
  [[nodiscard]] vtkPlaneCollection& sectionPlanes() const { return *sectionPlanes_; }

  /// Leaves out the triangles for which `isHidden`, one for each; empty: draws all. Tints on the mesh are set again
  /// afterwards. O(T).
  void setHidden(std::vector<char> isHidden);
  /// The same as another actor of the mesh. O(1) where all its edges are not drawn.
  void setHiddenAs(const MeshActor& other);

  /// How many pixels of the window are one of the picture: widths of lines are in pixels of the picture.
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkActor& surface() const { return *surface_; }
  [[nodiscard]] vtkActor& edges() const { return *edges_; }
  /// The lines of `MeshEdges::All`.
  [[nodiscard]] vtkActor& meshEdges() const { return *meshEdges_; }

  [[nodiscard]] const Model& model() const noexcept { return model_; }

  /// The file vertex of each point that is drawn.
  [[nodiscard]] const std::vector<Index>& vertexOf() const noexcept { return shaded_->vertexOf; }
  [[nodiscard]] const std::shared_ptr<const ShadedSurface>& shaded() const noexcept { return shaded_; }
  /// Whether a triangle of `shaded` is left out.
  [[nodiscard]] bool isHidden(Index triangle) const { return !isHidden_.empty() && isHidden_[triangle] != 0; }

  /// The points and normals that are drawn, for other actors on the mesh.
  [[nodiscard]] vtkPoints& points() const { return *points_; }
  /// In coarse detail they may be older than the points.
  [[nodiscard]] vtkFloatArray& normals() const { return *normals_; }
  /// The mesh in coarse detail. Made by the first call, O(T log T); moves with the mesh.
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
