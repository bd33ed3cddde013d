#pragma once
/// Fixed, handle and rigid regions as tinted faces with outlines.

#include <memory>
#include <vector>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/marks/face_tint.h>

namespace holdfast {

/// The tints of regions, each in the colour that its glyphs have, and of those that are selected.
class RegionTints {
 public:
  /// `mesh` stays alive as long as this.
  explicit RegionTints(const MeshActor& mesh);

  /// Of what is drawn of the mesh now: after `MeshActor::setHidden`. O(T).
  void refresh();

  /// Not null. O(T) where regions or their statuses have changed.
  void show(const std::shared_ptr<const MarkSet>& marks);
  /// Places in the list. O(T).
  void highlight(std::vector<Index> constraints);

  /// In the order in which they are drawn, the selected ones last.
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
