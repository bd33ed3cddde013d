#pragma once
/// Constraints in a picture: glyphs in the shape of what they hold and the colour of their status, lines to targets.

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/section_plane.h>

namespace holdfast {

/// Dark for met, slate where nothing was solved, white for redundant, orange-red for conflicting, purple for missed,
/// grey for disabled: they differ in lightness or hue on every colour of the map.
[[nodiscard]] Color glyphColor(ConstraintStatus status);

/// As that of its status; marks of rigid regions that are met are brown.
[[nodiscard]] Color glyphColor(const ConstraintMark& mark);

/// The colour of vertices that are selected and of what is under the cursor: a violet that no colour map has.
inline constexpr Color kAccentColor{0.61, 0.17, 1.00};

/// The colour of constraints that are selected: a magenta that no colour map has.
inline constexpr Color kSelectedColor{1.00, 0.00, 0.83};

/// Whether single points that lie behind a surface show through it.
enum class HiddenMarks { Invisible, Faint };

/// The actors of some marks, without the tints of regions. Glyphs and lines keep their size in pixels whatever the
/// camera does: balls for points on vertices and for relative constraints, which a dashed line joins to their other
/// place; beads on a bar for points on edges; triangles for points in faces; dots for the vertices of regions and for
/// targets that are not reached. Those of disabled constraints are hollow.
class ConstraintGlyphs {
 public:
  ConstraintGlyphs();

  /// In the place of all that there were; not null. O(those that are drawn).
  void setMarks(std::shared_ptr<const MarkSet> marks);
  [[nodiscard]] const std::shared_ptr<const MarkSet>& marks() const noexcept { return marks_; }

  /// Rings around the points of these constraints, places in the list, and larger dots on their regions.
  void highlight(std::vector<Index> constraints);

  /// The diameter of a single point's ball, in pixels of the window; all other sizes follow.
  void setBallPixels(double pixels);

  void setHiddenMarks(HiddenMarks hidden);

  /// Draws the marks whose places a plane keeps, and the lines that begin or end there; none: all.
  void setSection(const std::optional<SectionPlane>& section);

  /// All of them, in the order in which they are drawn.
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
};

}  // namespace holdfast
