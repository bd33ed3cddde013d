#pragma once
/// Reports in words, for the terminal.

#include <string>

#include <holdfast/deform/report.h>
#include <holdfast/document/stated_options.h>

namespace holdfast::batch {

/// The mesh and its findings, the constraints in numbers, the solve, and which constraints pull hardest; several lines.
/// `units` may be empty.
[[nodiscard]] std::string summary(const Report& report, const std::string& meshName, const std::string& units);

/// For standard error: a line for each finding that warns of the solution; for each constraint in conflict a line for
/// each set of earlier ones with which it cannot hold, the largest gaps first and only a few, with the gap and repairs;
/// why solving failed.
[[nodiscard]] std::string messageLines(const Report& report, const std::string& units);

/// The options that come from the session `source` because the command line leaves them out. Empty if there are none.
[[nodiscard]] std::string optionsLine(const StatedOptions& taken, const std::string& source);

}  // namespace holdfast::batch
