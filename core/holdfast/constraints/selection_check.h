#pragma once
/// \file
/// Whether a selection makes sense on a mesh.

#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/constraints/selection.h>

namespace holdfast {

/// `select`, after a check of every id. Throws `InputError` at `where`, its element followed by the key at fault
/// (".any[1].vertices"): ids of vertices or parts that the mesh does not have; a selection of no vertex at all.
[[nodiscard]] std::vector<Index> selectOrThrow(const Selection& selection, const Mesh& mesh,
                                               const std::vector<Index>& componentOf, Index componentCount,
                                               const InputLocation& where);

}  // namespace holdfast
