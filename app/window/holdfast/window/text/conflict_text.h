#pragma once
/// \file
/// Conflicts and repetitions of constraints in sentences.

#include <QString>
#include <string>

#include <holdfast/deform/report.h>

namespace holdfast {

/// “P3” asks for a place 0.42 mm away from where “P1” and “P2” put it.
[[nodiscard]] QString conflictText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet,
                                   const std::string& units);

/// How many of the rows, and which way they are off.
[[nodiscard]] QString gapText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet,
                              const std::string& units);

/// “P4” repeats “P1”.
[[nodiscard]] QString repetitionText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet);

}  // namespace holdfast
