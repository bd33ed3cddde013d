#pragma once
/// \file
/// Constraints of every type on the plate, with conflicts and repetitions that are known beforehand.

#include <string>

#include "grouped_mesh.h"

namespace holdfast::generate {

/// A constraint file for the plate. Nothing turns, so that every gap is the number that was planted; the name of each
/// constraint says how it fares.
[[nodiscard]] std::string plantedConflicts(const GroupedMesh& plate);

}  // namespace holdfast::generate
