#pragma once
/// \file
/// Marks of constraints, and which of them are drawn. Nothing of VTK: any thread may choose them.

#include <memory>
#include <vector>

#include <holdfast/widgets/marks/constraint_marks.h>

namespace holdfast {

/// Whether a constraint of this status is not where it should be.
[[nodiscard]] bool isOff(ConstraintStatus status);

/// No more dots of one status are drawn for regions than this, evenly spread over what they hold: ten thousand of them
/// would be a stain. What conflicts or is missed is always drawn.
inline constexpr Index kMostDots = 800;

/// The places in `marks` of those that are drawn, in the order in which they are drawn: of several in one place the
/// last is seen, the gravest.
[[nodiscard]] std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks);

/// Never changes once it is shared.
struct MarkSet {
  std::vector<ConstraintMark> marks;
  std::vector<Index> drawn;  ///< `drawnMarks` of them
};

/// `before` is what was shown before, null at first: which dots of regions are drawn is decided anew only where other
/// places are held, or fared otherwise. O(marks log marks).
[[nodiscard]] std::shared_ptr<const MarkSet> markSet(std::vector<ConstraintMark> marks,
                                                     const std::shared_ptr<const MarkSet>& before);

}  // namespace holdfast
