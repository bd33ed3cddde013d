#pragma once
/// Writes constraints in words, as tables and panels show them.

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/report.h>

namespace holdfast {

[[nodiscard]] QString kindText(const Constraint& constraint);

/// Returns a location in words: "vertex 12", "edge 12–13, t 0.25", "face 77: 0.2, 0.3, 0.5", "near (4.1, 0.2, 0.9)".
[[nodiscard]] QString locationText(const SurfaceLocation& location);

/// Returns " (labelled 100234)" for a vertex or face that has a label in its file. Returns nothing for others.
[[nodiscard]] QString labelText(const Mesh& mesh, const SurfaceLocation& location);

/// Returns a selection in words: "25 vertices", "box", "sphere or sphere", "curve through 5 places", ...
[[nodiscard]] QString selectionText(const Selection& selection);

/// Returns what the constraint holds: its location, its selection, or both ends.
[[nodiscard]] QString whereText(const Constraint& constraint);

/// Returns a status in words: "met", "conflicting", ...; "not solved" where there is none yet.
[[nodiscard]] QString statusText(std::optional<ConstraintStatus> status);

/// Tells whether the residual is no more than rounding may leave.
[[nodiscard]] inline bool isWithinLimit(const ConstraintOutcome& outcome)
{
  return outcome.residual && outcome.limit && *outcome.residual <= *outcome.limit;
}

/// Returns what the status means, in one sentence.
[[nodiscard]] QString statusMeaning(std::optional<ConstraintStatus> status);

/// Returns a name in quotes: “P1”. It is on one line, and a long name is cut: see `shortened`.
[[nodiscard]] QString quoted(const std::string& name);

/// Returns a name as `quoted` does, but without quotes, for menus.
[[nodiscard]] QString nameText(const std::string& name);

/// Returns the beginning and the end of a name that has more than `letters`: “measured…t 0017”. It has more letters as
/// long as one of `others`, other than the name itself, would read the same.
[[nodiscard]] QString quotedEnds(const std::string& name, const std::vector<std::string>& others, int letters);

/// Returns a list of names: “P1”, “P2” and “P3”. Of many names it has the first few, and says how many others there
/// are.
[[nodiscard]] QString quotedList(const std::vector<std::string>& names);

}  // namespace holdfast
