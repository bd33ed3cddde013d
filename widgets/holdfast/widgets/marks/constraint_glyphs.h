#pragma once
/// Glyphs show constraints in a picture. Their shape says what a constraint holds, and their colour is its status.
/// Lines lead to targets.

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/numbers/types.h>
#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/section_plane.h>

namespace holdfast {

/// Returns the colour of a status. It is dark for met, slate where nothing was solved, and white for redundant. It is
/// orange-red for conflicting, purple for missed, and grey for disabled. They differ in lightness or hue on every
/// colour of the map.
[[nodiscard]] Color glyphColor(ConstraintStatus status);

/// Returns the colour of a mark, which is that of its status. Marks of rigid regions that are met are brown.
[[nodiscard]] Color glyphColor(const ConstraintMark& mark);

/// Selected vertices and what is under the cursor have this violet. No colour map has it.
inline constexpr Color kAccentColor{0.61, 0.17, 1.00};

/// Selected constraints have this magenta. No colour map has it.
inline constexpr Color kSelectedColor{1.00, 0.00, 0.83};

/// The way in which single points behind a surface show: not at all, or faintly through it.
enum class HiddenMarks { Invisible, Faint };

/// The actors of some marks, without the tints of regions. Glyphs and lines keep their size in pixels whatever the
/// camera does. Glyphs of disabled constraints are hollow. These are the shapes:
/// - Points on vertices and relative constraints are balls. A dashed line joins a relative constraint to its other
///   place.
/// - Points on edges are beads on a bar.
/// - Points in faces are triangles.
/// - The vertices of regions and the targets that are not reached are dots.
/// - Guides (`ConstraintGuide`) are lines, and planes have a faint face as well.
///
///     ConstraintGlyphs glyphs;
///     glyphs.setMarks(markSet(model, constraintMarks(model, result), nullptr));
///     for (vtkActor* const actor : glyphs.actors()) renderer->AddActor(actor);
class ConstraintGlyphs {
 public:
  ConstraintGlyphs();

  /// Shows `marks` in place of all marks that there were. They are not null. O(those that are drawn).
  void setMarks(std::shared_ptr<const MarkSet> marks);
  [[nodiscard]] const std::shared_ptr<const MarkSet>& marks() const noexcept { return marks_; }

  /// Draws rings around the points of these constraints, and larger dots on their regions. `constraints` are places in
  /// the list.
  void highlight(std::vector<Index> constraints);

  /// Sets the diameter of a single point's ball, in pixels of the window. All other sizes follow it.
  void setBallPixels(double pixels);

  void setHiddenMarks(HiddenMarks hidden);

  /// Draws only the marks whose places a plane keeps, and the lines that begin or end there. Without a plane, draws
  /// all.
  void setSection(const std::optional<SectionPlane>& section);

  /// Returns all actors, in the order in which they are drawn.
  [[nodiscard]] std::vector<vtkActor*> actors() const;

 private:
  void update();
  void resize();

  std::shared_ptr<const MarkSet> marks_;
  std::vector<Index> highlighted_;  // ascending
  HiddenMarks hidden_ = HiddenMarks::Faint;
  std::optional<SectionPlane> section_;
  double ballPixels_ = 10;
  bool isCrowded_ = false;
  std::vector<std::unique_ptr<PointSprites>> layers_;
  vtkNew<vtkPolyData> lineData_;
  vtkNew<vtkActor> lines_;
  vtkNew<vtkPolyData> faceData_;
  vtkNew<BlendedActor> faces_;
};

}  // namespace holdfast
