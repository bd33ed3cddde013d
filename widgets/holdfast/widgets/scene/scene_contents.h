#pragma once
/// These contents show a document in a renderer, and follow it from frame to frame.

#include <array>
#include <optional>
#include <vector>

#include <vtkWeakPointer.h>

#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/region_tints.h>
#include <holdfast/widgets/marks/rotation_glyphs.h>
#include <holdfast/widgets/marks/selection_overlay.h>
#include <holdfast/widgets/mesh/guide_actor.h>
#include <holdfast/widgets/mesh/mesh_actor.h>

class vtkRenderer;

namespace holdfast {

/// The way in which the shape at rest is shown beside the deformed one.
enum class RestGhost {
  Hidden,
  Edges,   ///< faint lines along its sharp edges and borders
  Surface  ///< these lines and a translucent surface
};

/// The way in which rotations are shown.
enum class RotationDisplay { Hidden, Arrows };

/// The actors of the mesh, its shape at rest, constraints, selection and rotations. They do not draw by themselves.
/// Make all changes, then render once.
///
///     SceneContents scene(model);
///     scene.addTo(*renderer);
///     scene.show(result);
///     scene.color(coloringOf(model, result, ColorBy::Displacement, "mm"));
///     window->Render();
class SceneContents {
 public:
  /// Makes the contents of the mesh at rest, in one colour and without constraints. `model` and `shaded` are as for
  /// `MeshActor`.
  explicit SceneContents(const Model& model, std::shared_ptr<const ShadedSurface> shaded = nullptr);
  ~SceneContents() { leave(); }
  SceneContents(const SceneContents&) = delete;
  SceneContents& operator=(const SceneContents&) = delete;

  /// Adds all actors to `renderer`, hidden ones too. They leave the renderer in which they were. When the contents are
  /// destroyed, they leave `renderer`.
  void addTo(vtkRenderer& renderer);

  /// Shows a deformation: its positions, rotations and constraints. Colours stay as they are (see `color`). O(T +
  /// marks).
  void show(const DeformResult& deformation);

  /// Shows the positions and rotations of a deformation, and the surfaces on which it keeps points. The marks of
  /// constraints stay as they are.
  void showShape(const DeformResult& deformation);

  /// Moves the mesh and the selection on it, nothing else. `positions` has one row for each vertex of the file. O(T).
  void setPositions(const Positions& positions);

  /// Colours the mesh by values, one for each vertex of the file. Without them it has one colour. O(N).
  void color(const std::optional<Coloring>& coloring);

  /// Shows these marks of constraints, without guides.
  void setMarks(std::vector<ConstraintMark> marks)
  {
    showMarks(markSet(mesh_.model(), std::move(marks), glyphs_.marks()));
  }
  /// Shows marks that another thread has made ready. They are not null. O(those that are drawn), and O(T) where regions
  /// have changed.
  void showMarks(std::shared_ptr<const MarkSet> marks);
  /// Returns the marks that are shown, without those of what is hidden.
  [[nodiscard]] const std::vector<ConstraintMark>& marks() const noexcept { return glyphs_.marks()->marks; }
  [[nodiscard]] const std::shared_ptr<const MarkSet>& sharedMarks() const noexcept { return glyphs_.marks(); }
  /// Highlights these constraints, which are places in the list.
  void highlight(std::vector<Index> constraints)
  {
    regions_.highlight(constraints);
    glyphs_.highlight(std::move(constraints));
  }
  void setHiddenMarks(HiddenMarks hidden) { glyphs_.setHiddenMarks(hidden); }

  /// Draws what a plane keeps of the mesh, its shape at rest, the selection, constraints and rotations. Without a
  /// plane, draws all.
  void setSection(const std::optional<SectionPlane>& section);
  /// Draws the lines along which the plane cuts the mesh (`VisibleSurface::cut`).
  void setCut(const std::vector<std::array<Vector3, 2>>& segments);

  /// Leaves out the hidden triangles with all that is drawn on them alone. `isHidden` has one entry for each triangle.
  /// An empty vector draws everything. O(T).
  void setHidden(const std::vector<char>& isHidden);

  void setRestGhost(RestGhost ghost);
  void setMeshEdges(MeshEdges edges) { mesh_.setMeshEdges(edges); }
  void setRotationDisplay(RotationDisplay display);
  void setSelection(const std::vector<Index>& fileVertices) { selection_.set(fileVertices); }
  /// Sets the detail. The shape at rest, where it is shown as a surface, has coarse detail in both.
  void setDetail(Detail detail);
  /// Says where the eye is, as `MeshActor::lookFrom` does.
  void lookFrom(const Vector3& eye) { mesh_.lookFrom(eye); }
  /// Returns the large actors that are shown, in full detail, in the order of drawing. They are drawn first.
  [[nodiscard]] std::vector<ActorSlices*> slices();

  /// Sets how many pixels of the window are one of the screen as users see it, or of a finished picture.
  void setPixelRatio(double ratio);
  /// Sets the diameter of a point's ball, in pixels before that ratio.
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
  GuideActor guides_{mesh_.sectionPlanes()};
  RegionTints regions_;
  SelectionOverlay selection_;
  RotationGlyphs arrows_;
  std::shared_ptr<const MarkSet> allMarks_;
  std::vector<char> isUnknownHidden_;  // empty where nothing is hidden
  ConstraintGlyphs glyphs_;
  vtkNew<vtkPolyData> cutLines_;
  vtkNew<BlendedActor> cut_;
};

/// A user chooses these settings of the colours.
struct ColorSettings {
  ColorBy field = ColorBy::Displacement;
  ColorRange range = AutomaticRange{};  ///< a range for which `whyNoRange` is empty
  /// The map that the user has chosen. Without one, signed fields have a two-sided map and others another one.
  std::optional<ColorMap> map = std::nullopt;
  int bands = 0;  ///< as in `ColorScale`
};

/// The lower corner of the picture that has the legend.
enum class LegendSide { Right, Left, Hidden };

/// A user chooses these settings of the picture.
struct DisplaySettings {
  RestGhost rest = RestGhost::Edges;
  MeshEdges edges = MeshEdges::Sharp;
  SurfaceDisplay surface = SurfaceDisplay::Shaded;
  RotationDisplay rotations = RotationDisplay::Hidden;
  bool areConstraintsShown = true;
  LegendSide legend = LegendSide::Right;

  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// Shows in `contents` what `settings` say of them. A deformation was shown in them before.
void arrange(SceneContents& contents, const DisplaySettings& settings);

/// Returns the triangles and vertices of `shaded` as a `CutSurface`. `shaded` must stay alive as long as that.
[[nodiscard]] inline CutSurface cutSurfaceOf(const ShadedSurface& shaded)
{
  return {shaded.triangles, shaded.vertexOf};
}

/// Makes the values of the chosen field on the chosen scale. `ColorBy::None` gives none. With `shaded`, what is
/// measured on faces is crisp at sharp edges.
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation,
                                                 const ColorSettings& settings, const std::string& units,
                                                 const ShadedSurface* shaded = nullptr);

}  // namespace holdfast
