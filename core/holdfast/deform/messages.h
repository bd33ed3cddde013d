#pragma once
/// These functions write what a solve has to say: what was wrong, where, and what to do. An accuracy is an estimated
/// relative error: of the unknowns that constraints leave free, or of those that constraints determine.

#include <holdfast/deform/determined_part.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// A solution less accurate than this is no answer: in a picture the error would show.
inline constexpr double kUsableAccuracy = 1e-6;

/// A solution less accurate than this gets a warning. It is a thousand times what doubles lose on a well-shaped mesh.
inline constexpr double kDoubtfulAccuracy = 1e-9;

/// Says why a solution of this accuracy is refused. Empty where it is usable.
[[nodiscard]] std::string accuracyFailure(double accuracy);

/// Warns of `what` ("the solution"), with a finding of the kind `kind`. Returns none unless the accuracy is usable and
/// doubtful.
[[nodiscard]] std::optional<Finding> accuracyWarning(const std::string& kind, const std::string& what, double accuracy);

/// Says why a solution is refused whose rows determine a part only that accurately. Empty where it is usable.
[[nodiscard]] std::string determinedFailure(const DeformDetails& details, const DeterminedPart& part);

/// Warns of such a part, with a finding of the kind "low_accuracy". Returns none unless it is usable and doubtful.
[[nodiscard]] std::optional<Finding> determinedWarning(const DeformDetails& details, const DeterminedPart& part);

/// Warns that rotations were not found within the iterations of `options`.
[[nodiscard]] Finding unconvergedWarning(const RotationIterations& iterations, const RotationOptions& options);

/// Says that weights are not finite at some vertices.
[[nodiscard]] std::string undefinedRowsMessage(const Model& model, const Operators& operators);

/// Says that the solve failed, by `reason`, and which options may help.
[[nodiscard]] std::string failureMessage(const DeformOptions& options, const std::string& reason);

/// Says what a solution meets, what it misses (`worst` most), and its accuracy.
[[nodiscard]] std::string solvedMessage(const Report& report, const std::optional<MissedRow>& worst);

/// Says that hard constraints miss `row`: by how much, why as far as that is known, and what to do.
[[nodiscard]] std::string missedMessage(const Report& report, const MissedRow& row);

/// Returns findings about parts that stay at rest and constraints that nearly repeat others, and the notes of the
/// system.
[[nodiscard]] std::vector<Finding> constraintFindings(const Model& model, const EliminatedByAxes& eliminated,
                                                      const DeformDetails& details);

/// Returns a note about a constraint as a finding.
[[nodiscard]] Finding noteFinding(const ConstraintNote& note, const ConstraintLabels& labels);

/// Says what helps where more constraints contradict others than a person mends one by one. Returns none where they are
/// fewer.
[[nodiscard]] std::optional<Finding> crowdedFinding(const DeformDetails& details);

}  // namespace holdfast
