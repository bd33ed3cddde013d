#pragma once
/// Constraints in words, as tables and panels show them.

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/report.h>

namespace holdfast {

[[nodiscard]] QString kindText(const Constraint& constraint);

/// "vertex 12", "edge 12–13, t 0.25", "face 77: 0.2, 0.3, 0.5", "near (4.1, 0.2, 0.9)".
[[nodiscard]] QString locationText(const SurfaceLocation& location);

/// "25 vertices", "box", "sphere or sphere", "curve through 5 places", ...
[[nodiscard]] QString selectionText(const Selection& selection);

/// What the constraint holds: its location, its selection, or both ends.
[[nodiscard]] QString whereText(const Constraint& constraint);

/// "met", "conflicting", ...; "not solved" where there is none yet.
[[nodiscard]] QString statusText(std::optional<ConstraintStatus> status);

/// Whether what is missed is no more than rounding may leave.
[[nodiscard]] inline bool isWithinLimit(const ConstraintOutcome& outcome)
{
  return outcome.residual && outcome.limit && *outcome.residual <= *outcome.limit;
}

/// What the status means, one sentence.
[[nodiscard]] QString statusMeaning(std::optional<ConstraintStatus> status);

/// “P1”; cut where it is long, and on one line: see `shortened`.
[[nodiscard]] QString quoted(const std::string& name);

/// The same without quotes, for menus.
[[nodiscard]] QString nameText(const std::string& name);

/// “measured…t 0017”: the beginning and the end of a name that has more than `letters`; more of them as long as one of
/// `others`, other than it, would read the same.
[[nodiscard]] QString quotedEnds(const std::string& name, const std::vector<std::string>& others, int letters);

/// “P1”, “P2” and “P3”; of many the first few and how many others.
[[nodiscard]] QString quotedList(const std::vector<std::string>& names);

}  // namespace holdfast
