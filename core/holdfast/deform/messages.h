#pragma once
/// What a solve has to say, in sentences: what was wrong, where, and what to do. An accuracy is an estimated relative
/// error: of the unknowns that the constraints leave free, or of what the constraints determine.

#include <holdfast/deform/determined_part.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// Solutions less accurate than this are no answer: in a picture the error would show.
inline constexpr double kUsableAccuracy = 1e-6;

/// Solutions less accurate than this are warned of: a thousand times what doubles lose on a well-shaped mesh.
inline constexpr double kDoubtfulAccuracy = 1e-9;

/// Why a solution of this accuracy is refused; empty where it is usable.
[[nodiscard]] std::string accuracyFailure(double accuracy);

/// The warning of `what` ("the solution"), of the kind `kind`, where it is usable and doubtful.
[[nodiscard]] std::optional<Finding> accuracyWarning(const std::string& kind, const std::string& what, double accuracy);

/// Why a solution is refused of which the rows determine a part that accurately; empty where it is usable.
[[nodiscard]] std::string determinedFailure(const DeformDetails& details, const DeterminedPart& part);

/// The warning of such a part, of the kind "low_accuracy", where it is usable and doubtful.
[[nodiscard]] std::optional<Finding> determinedWarning(const DeformDetails& details, const DeterminedPart& part);

/// The warning that rotations were not found within the iterations of `options`.
[[nodiscard]] Finding unconvergedWarning(const RotationIterations& iterations, const RotationOptions& options);

/// Weights are not finite at some vertices.
[[nodiscard]] std::string undefinedRowsMessage(const Model& model, const Operators& operators);

/// The solve failed: `reason`, and the options that may help.
[[nodiscard]] std::string failureMessage(const DeformOptions& options, const std::string& reason);

/// What a solution meets, what it misses (`worst` most), and its accuracy.
[[nodiscard]] std::string solvedMessage(const Report& report, const std::optional<MissedRow>& worst);

/// Hard constraints miss `row`: by how much, why as far as that is known, and what to do.
[[nodiscard]] std::string missedMessage(const Report& report, const MissedRow& row);

/// Parts that stay at rest, constraints that nearly repeat others, and the notes of the system.
[[nodiscard]] std::vector<Finding> constraintFindings(const Model& model, const EliminatedConstraints& eliminated,
                                                      const DeformDetails& details);

/// A finding that says what helps where more constraints contradict others than a person mends one by one; none where
/// they are fewer.
[[nodiscard]] std::optional<Finding> crowdedFinding(const DeformDetails& details);

}  // namespace holdfast
