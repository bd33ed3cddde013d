#pragma once
/// \file
/// Reports in words, for the terminal.

#include <string>

#include <holdfast/deform/report.h>

namespace holdfast::batch {

/// The mesh and its findings, the constraints in numbers, the solve; several lines. `units` may be empty.
[[nodiscard]] std::string summary(const Report& report, const std::string& meshName, const std::string& units);

/// A line for each constraint that conflicts, with its partners and its gap; empty where there is none.
[[nodiscard]] std::string conflictLines(const Report& report, const std::string& units);

}  // namespace holdfast::batch
