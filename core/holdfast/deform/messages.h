#pragma once
/// What a solve has to say, in sentences: what was wrong, where, and what to do.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/deform/model.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// Weights are not finite at some vertices.
[[nodiscard]] std::string undefinedRowsMessage(const Model& model, const Operators& operators);

/// The solve failed: `reason`, and the options that may help.
[[nodiscard]] std::string failureMessage(const DeformOptions& options, const std::string& reason);

/// What a solution meets, what it misses (`worst` most), and its accuracy.
[[nodiscard]] std::string solvedMessage(const Report& report, const std::optional<MissedRow>& worst);

/// Hard constraints miss `row`: by how much, why as far as that is known, and what to do.
[[nodiscard]] std::string missedMessage(const Report& report, const MissedRow& row);

/// Parts that stay at rest, constraints that nearly repeat others (`outcomes` have their amplifications), and the notes
/// of `system`.
[[nodiscard]] std::vector<Finding> constraintFindings(const Model& model, const EliminatedConstraints& eliminated,
                                                      const ConstraintSystem& system,
                                                      const std::vector<ConstraintOutcome>& outcomes);

}  // namespace holdfast
