#pragma once
/// Everything that shows a document in a renderer, and follows it from frame to frame.

#include <array>
#include <optional>
#include <vector>

#include <vtkWeakPointer.h>

#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/region_tints.h>
#include <holdfast/widgets/marks/rotation_glyphs.h>
#include <holdfast/widgets/marks/selection_overlay.h>
#include <holdfast/widgets/mesh/mesh_actor.h>

class vtkRenderer;

namespace holdfast {

/// How the shape at rest is shown beside the deformed one.
enum class RestGhost {
  Hidden,
  Edges,   ///< faint lines along its sharp edges and borders
  Surface  ///< the same and a translucent surface
};

enum class RotationDisplay { Hidden, Arrows };

/// The actors of the mesh, its shape at rest, constraints, selection and rotations. Nothing is drawn by itself: make
/// all changes, then render once.
class SceneContents {
 public:
  /// At rest, in one colour, without constraints. Both are as for `MeshActor`.
  explicit SceneContents(const Model& model, std::shared_ptr<const ShadedSurface> shaded = nullptr);
  ~SceneContents() { leave(); }
  SceneContents(const SceneContents&) = delete;
  SceneContents& operator=(const SceneContents&) = delete;

  /// Adds all actors, also hidden ones, in the place of where they were. They leave `renderer` when this ends.
  void addTo(vtkRenderer& renderer);

  /// A deformation: its positions, rotations and constraints. Colours stay (see `color`). O(T + marks).
  void show(const DeformResult& deformation);

  void showShape(const DeformResult& deformation);

  /// Moves the mesh and the selection on it, nothing else: one row for each vertex of the file. O(T).
  void setPositions(const Positions& positions);

  /// Colours by values, one for each vertex of the file; none: one colour. O(N).
  void color(const std::optional<Coloring>& coloring);

  void setMarks(std::vector<ConstraintMark> marks)
  {
    showMarks(markSet(mesh_.model(), std::move(marks), glyphs_.marks()));
  }
  /// Those that another thread has made ready; not null. O(those that are drawn), and O(T) where regions have changed.
  void showMarks(std::shared_ptr<const MarkSet> marks);
  /// Without those of what is hidden.
  [[nodiscard]] const std::vector<ConstraintMark>& marks() const noexcept { return glyphs_.marks()->marks; }
  [[nodiscard]] const std::shared_ptr<const MarkSet>& sharedMarks() const noexcept { return glyphs_.marks(); }
  /// Places in the list of constraints.
  void highlight(std::vector<Index> constraints)
  {
    regions_.highlight(constraints);
    glyphs_.highlight(std::move(constraints));
  }
  void setHiddenMarks(HiddenMarks hidden) { glyphs_.setHiddenMarks(hidden); }

  /// Draws what a plane keeps of the mesh, its shape at rest, the selection, constraints and rotations; none: all.
  void setSection(const std::optional<SectionPlane>& section);
  /// Draws the lines along which the plane cuts the mesh (`VisibleSurface::cut`).
  void setCut(const std::vector<std::array<Vector3, 2>>& segments);

  /// Leaves out the triangles for which `isHidden`, one for each, with all that is drawn on them alone; empty: draws
  /// everything. O(T).
  void setHidden(const std::vector<char>& isHidden);

  void setRestGhost(RestGhost ghost);
  void setMeshEdges(MeshEdges edges) { mesh_.setMeshEdges(edges); }
  void setRotationDisplay(RotationDisplay display);
  void setSelection(const std::vector<Index>& fileVertices) { selection_.set(fileVertices); }
  /// The shape at rest, where it is shown as a surface, is that of coarse detail in both.
  void setDetail(Detail detail);
  /// As `MeshActor::lookFrom`.
  void lookFrom(const Vector3& eye) { mesh_.lookFrom(eye); }
  /// The large actors that are shown, in full detail, in the order of drawing: they are drawn first.
  [[nodiscard]] std::vector<ActorSlices*> slices();

  /// How many pixels of the window are one of the screen as users see it, or of a finished picture.
  void setPixelRatio(double ratio);
  /// The diameter of a point's ball, in pixels before that ratio.
  void setBallSize(double pixels);

  [[nodiscard]] MeshActor& mesh() { return mesh_; }

 private:
  void leave();
  [[nodiscard]] std::vector<vtkActor*> actors();
  [[nodiscard]] std::vector<FaceTint*> tints();
  void resize();
  void updateArrows()
  {
    if (rotationDisplay_ == RotationDisplay::Arrows) arrows_.set(positions_, rotations_);
  }
  void updateDetail();
  [[nodiscard]] std::shared_ptr<const MarkSet> shownMarks() const;

  vtkWeakPointer<vtkRenderer> renderer_;
  double pixelRatio_ = 1;
  double ballSize_ = 10;
  RestGhost ghost_ = RestGhost::Edges;
  Detail detail_ = Detail::Full;
  RotationDisplay rotationDisplay_ = RotationDisplay::Hidden;
  Positions positions_;
  Columns3 rotations_;
  MeshActor mesh_;
  MeshActor rest_;
  vtkNew<BlendedActor> restSurface_;  // draws that of `rest_`
  RegionTints regions_;
  SelectionOverlay selection_;
  RotationGlyphs arrows_;
  std::shared_ptr<const MarkSet> allMarks_;
  std::vector<char> isUnknownHidden_;  // empty where nothing is hidden
  ConstraintGlyphs glyphs_;
  vtkNew<vtkPolyData> cutLines_;
  vtkNew<BlendedActor> cut_;
};

struct ColorSettings {
  ColorBy field = ColorBy::Displacement;
  ColorRange range = AutomaticRange{};         ///< `whyNoRange` of it is empty
  std::optional<ColorMap> map = std::nullopt;  ///< without one a two-sided map for signed fields, another for others
  int bands = 0;                               ///< as in `ColorScale`
};

/// In which lower corner of the picture the legend is.
enum class LegendSide { Right, Left, Hidden };

struct DisplaySettings {
  RestGhost rest = RestGhost::Edges;
  MeshEdges edges = MeshEdges::Sharp;
  SurfaceDisplay surface = SurfaceDisplay::Shaded;
  RotationDisplay rotations = RotationDisplay::Hidden;
  bool areConstraintsShown = true;
  LegendSide legend = LegendSide::Right;

  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// Shows in `contents`, to which a deformation was shown, what `settings` say of them.
void arrange(SceneContents& contents, const DisplaySettings& settings);

[[nodiscard]] inline CutSurface cutSurfaceOf(const ShadedSurface& shaded)
{
  return {shaded.triangles, shaded.vertexOf};
}

/// The values of the chosen field on the chosen scale; none for `ColorBy::None`. With `shaded`, what is measured on
/// faces is crisp at sharp edges.
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation,
                                                 const ColorSettings& settings, const std::string& units,
                                                 const ShadedSurface* shaded = nullptr);

}  // namespace holdfast
