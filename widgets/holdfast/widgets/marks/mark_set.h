#pragma once
/// Marks show where constraints act. They have places, targets and statuses, and some of them are drawn. Any thread may
/// make them.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <holdfast/constraints/known_places.h>
#include <holdfast/deform/deform.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/widgets/marks/constraint_guides.h>

namespace holdfast {

/// The kind of a mark says what a constraint holds there. Each kind has its own shape in pictures.
enum class MarkKind {
  Selection,  ///< a vertex of a fixed region or of a handle
  Rigid,      ///< a vertex of a rigid region
  Vertex,     ///< a single point on a vertex
  Edge,       ///< a single point on an edge
  Face,       ///< a single point in a face
  Relative    ///< the place that `from` of a relative constraint names
};

/// Tells whether the mark is a constraint of type point or relative. Users find those one by one. Any other mark is one
/// vertex of many.
[[nodiscard]] constexpr bool isSinglePoint(MarkKind kind)
{
  return kind != MarkKind::Selection && kind != MarkKind::Rigid;
}

/// A mark is one row of B in a picture. A disabled constraint has marks for the rows that it would have.
struct ConstraintMark {
  Vector3 place;   ///< where the point is, model units
  Vector3 target;  ///< where the point should be
  ConstraintStatus status = ConstraintStatus::Met;
  MarkKind kind = MarkKind::Selection;
  Index constraint = 0;  ///< the place of the constraint in the list
  /// The place of the point at rest. Marks are thinned by it, so that none flickers.
  Vector3 rest = {0, 0, 0};
  /// The place that `to` of a relative constraint names.
  std::optional<Vector3> other = std::nullopt;
  Index unknown = -1;    ///< of a region: the unknown of the vertex
  Index reference = -1;  ///< of a rigid region: its first vertex, to which the others refer
  Index nearest = -1;    ///< of the unknowns that make the place, the one with the largest weight
};

/// Makes a mark for each row that has terms, in the order of rows. The mark of a rigid region lies at its vertex. The
/// mark of a relative constraint lies at the place that `from` names. The target of both is where they should lie as
/// the other place is now. O(rows).
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const DeformResult& deformation);

/// Makes the same marks and adds those of the disabled constraints of `list`. These lie where the constraints would
/// act. `deformation` was made of `list`. `places` are those that earlier lists on the same model had.
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                                          const DeformResult& deformation, KnownPlaces& places);
/// Makes the same marks. No places of earlier lists are known.
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                                          const DeformResult& deformation);

/// Tells whether a constraint of this status is not where it should be.
[[nodiscard]] bool isOff(ConstraintStatus status);

/// No more dots than this are drawn of one status for regions. Marks that conflict or are missed are always drawn.
inline constexpr Index kMostDots = 800;

/// The number of looks of a region. A region looks as its status, in the order of `ConstraintStatus`. The last look is
/// that of rigid regions that are met.
inline constexpr std::size_t kRegionLooks = 7;

/// The looks of regions at vertices. Each look of a region that the vertex is in has a bit.
using RegionLooks = std::vector<std::uint8_t>;

/// Returns the looks at all unknowns of a model. A region has the most serious status of its marks. It is redundant
/// only where all its marks are.
[[nodiscard]] RegionLooks regionLooks(const Model& model, const std::vector<ConstraintMark>& marks);

/// Returns the places in `marks` of those that are drawn, in the order of drawing. The most serious status is drawn
/// last. `isCovered` says for each unknown whether a tint covers it. An empty vector means none. Dots of regions at
/// covered unknowns are left out where all is well with them.
[[nodiscard]] std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks,
                                            const std::vector<char>& isCovered = {});

/// Marks with the choice of those that are drawn. A set never changes once it is shared.
struct MarkSet {
  std::vector<ConstraintMark> marks;
  std::vector<Index> drawn;                  ///< their `drawnMarks`, beside the tints of regions
  std::shared_ptr<const RegionLooks> looks;  ///< their `regionLooks`; null where there are no marks
  std::vector<ConstraintGuide> guides;       ///< what is drawn beside them
};

/// Makes a set of `marks`. `before` is the set that was shown before, or null at first. Its choice of dots and its
/// looks stay where places at rest and statuses are the same.
///
///     auto marks = markSet(model, constraintMarks(model, result), nullptr, constraintGuides(model, result));
///     scene.showMarks(marks);  // SceneContents
///     marks = markSet(model, constraintMarks(model, nextResult), marks, constraintGuides(model, nextResult));
///     scene.showMarks(marks);
[[nodiscard]] std::shared_ptr<const MarkSet> markSet(const Model& model, std::vector<ConstraintMark> marks,
                                                     const std::shared_ptr<const MarkSet>& before,
                                                     std::vector<ConstraintGuide> guides = {});

}  // namespace holdfast
