#pragma once
/// Marks of constraints: places, targets, statuses, and which are drawn. Any thread may make them.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <holdfast/constraints/known_places.h>
#include <holdfast/deform/deform.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// What a constraint holds at a mark. Each kind has its own shape in pictures.
enum class MarkKind {
  Selection,  ///< a vertex of a fixed region or of a handle
  Rigid,      ///< a vertex of a rigid region
  Vertex,     ///< a single point on a vertex
  Edge,       ///< a single point on an edge
  Face,       ///< a single point in a face
  Relative    ///< the place that `from` of a relative constraint names
};

/// A constraint of type point or relative, which users find one by one; else one vertex of many.
[[nodiscard]] constexpr bool isSinglePoint(MarkKind kind)
{
  return kind != MarkKind::Selection && kind != MarkKind::Rigid;
}

/// One row of B in a picture, or one that there would be if its constraint were enabled.
struct ConstraintMark {
  Vector3 place;   ///< where the point is, model units
  Vector3 target;  ///< where it was to be
  ConstraintStatus status = ConstraintStatus::Met;
  MarkKind kind = MarkKind::Selection;
  Index constraint = 0;      ///< place in the list
  Vector3 rest = {0, 0, 0};  ///< where the point is at rest: marks are thinned by this, so that none flickers
  std::optional<Vector3> other = std::nullopt;  ///< of relative constraints: where the place is that `to` names
  Index unknown = -1;                           ///< of regions: the vertex
  Index reference = -1;                         ///< of rigid regions: the first vertex, to which the others refer
  Index nearest = -1;                           ///< of the unknowns that make the place: that of the largest weight
};

/// A mark for each row that has terms, in the order of rows. One of a rigid region lies at its vertex, one of a
/// relative constraint at the place that `from` names; both want to lie as they should to the other place. O(rows).
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const DeformResult& deformation);

/// The same, and where the disabled constraints of `list`, which `deformation` was made of, would act. `places` are
/// those of lists before this one on the same model.
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                                          const DeformResult& deformation, KnownPlaces& places);
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                                          const DeformResult& deformation);

/// Whether a constraint of this status is not where it should be.
[[nodiscard]] bool isOff(ConstraintStatus status);

/// The most dots of one status that are drawn for regions. Marks that conflict or are missed are always drawn.
inline constexpr Index kMostDots = 800;

/// How a region looks: as its status, in the order of `ConstraintStatus`, and last as rigid ones that are met.
inline constexpr std::size_t kRegionLooks = 7;

/// The looks of regions at vertices: a bit for each look of a region that the vertex is in.
using RegionLooks = std::vector<std::uint8_t>;

/// Of all unknowns of a model. A region has the most serious status of its marks; it is redundant where all are.
[[nodiscard]] RegionLooks regionLooks(const Model& model, const std::vector<ConstraintMark>& marks);

/// The places in `marks` of those that are drawn, in the order of drawing: the most serious status is drawn last. Dots
/// of regions at unknowns that are covered by a tint are left out where all is well with them; empty: none is covered.
[[nodiscard]] std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks,
                                            const std::vector<char>& isCovered = {});

/// Never changes once it is shared.
struct MarkSet {
  std::vector<ConstraintMark> marks;
  std::vector<Index> drawn;                  ///< `drawnMarks` of them beside the tints of regions
  std::shared_ptr<const RegionLooks> looks;  ///< `regionLooks` of them; null where there are no marks
};

/// `before` was shown before, null at first: its choice of dots and its looks stay where rest places and statuses are
/// the same.
[[nodiscard]] std::shared_ptr<const MarkSet> markSet(const Model& model, std::vector<ConstraintMark> marks,
                                                     const std::shared_ptr<const MarkSet>& before);

}  // namespace holdfast
