#pragma once
/// Constraints as text for the clipboard, and back: points as a table that spreadsheets know, all else as JSON.

#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// The constraints at `indices`, all of type point, as a point list (docs/formats.md), in the order of the list and
/// with every double in its shortest exact form. A point lies at its `near` place, or else where it is at rest; a shift
/// becomes the target that it leads to. Whether a point is enabled is not said. Throws `InputError` for points that the
/// mesh does not have.
[[nodiscard]] std::string toPointListCsv(const ConstraintList& list, const std::vector<Index>& indices,
                                         const Model& model);

/// A point list where all of the constraints are points, a constraint file otherwise. (`constraintsToJson` of what
/// `extracted` takes out says all, also of points.) Throws as `toPointListCsv` and `constraintsToJson` do.
[[nodiscard]] std::string toClipboardText(const ConstraintList& list, const std::vector<Index>& indices,
                                          const Model& model);

/// The constraints of a text from the clipboard: a constraint file or session, a point list, or the cells of one as
/// spreadsheets copy them, with tabs. Throws `InputError` as `readConstraints` does.
[[nodiscard]] ConstraintList fromClipboardText(std::string_view text);

}  // namespace holdfast
