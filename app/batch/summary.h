#pragma once
/// \file
/// Reports in words, for the terminal.

#include <string>

#include <holdfast/deform/report.h>
#include <holdfast/document/stated_options.h>

namespace holdfast::batch {

/// The mesh and its findings, the constraints in numbers, the solve, and which constraints pull hardest; several lines.
/// `units` may be empty.
[[nodiscard]] std::string summary(const Report& report, const std::string& meshName, const std::string& units);

/// A line for each finding that warns of the solution. Empty where there is none.
[[nodiscard]] std::string warningLines(const Report& report);

/// For each constraint that conflicts a line for each set of earlier ones with which it cannot hold, the largest gaps
/// first and no more than a few: by how much it is off, and what would mend it. Empty where there is none.
[[nodiscard]] std::string conflictLines(const Report& report, const std::string& units);

/// What was taken from the session `source` because the command line does not say it. Empty where there is none.
[[nodiscard]] std::string optionsLine(const StatedOptions& taken, const std::string& source);

}  // namespace holdfast::batch
