#pragma once
/// \file
/// What is doubtful about a set of constraints though it can be solved.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/model.h>
#include <holdfast/deform/report.h>
#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// Parts that stay at rest, constraints that nearly repeat others (`outcomes` have their amplifications), and the notes
/// of `system`.
[[nodiscard]] std::vector<Finding> constraintFindings(const Model& model, const EliminatedConstraints& eliminated,
                                                      const ConstraintSystem& system,
                                                      const std::vector<ConstraintOutcome>& outcomes);

}  // namespace holdfast
