#pragma once
/// Tinted faces with outlines show fixed, handle and rigid regions.

#include <memory>
#include <vector>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/face_tint.h>

namespace holdfast {

/// The tints of regions, and of the regions that are selected. Each tint has the colour of the glyphs of its region.
class RegionTints {
 public:
  /// Makes tints without regions. `mesh` must stay alive as long as the tints.
  explicit RegionTints(const MeshActor& mesh);

  /// Tints what is drawn of the mesh now. Call it after `MeshActor::setHidden`. O(T).
  void refresh();

  /// Tints the regions of `marks`, which are not null. Costs O(T) where regions or their statuses have changed.
  void show(const std::shared_ptr<const MarkSet>& marks);
  /// Highlights the regions of these constraints, which are places in the list. O(T).
  void highlight(std::vector<Index> constraints);

  /// Returns the tints in the order in which they are drawn. The tints of selected regions come last.
  [[nodiscard]] const std::vector<std::unique_ptr<FaceTint>>& tints() const noexcept { return tints_; }

 private:
  void set(FaceTint& tint, std::uint8_t bit, const RegionLooks& looks) const;
  void updateHighlight();

  const MeshActor& mesh_;
  std::shared_ptr<const MarkSet> marks_ = std::make_shared<const MarkSet>();
  std::vector<Index> highlighted_;  // ascending
  std::vector<std::unique_ptr<FaceTint>> tints_;
};

}  // namespace holdfast
