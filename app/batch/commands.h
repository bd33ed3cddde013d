#pragma once
/// \file
/// What holdfast-batch does.

#include "batch/options.h"

namespace holdfast::batch {

/// docs/errors.md explains them.
enum ExitCode : int { kAllMet = 0, kUsage = 2, kInput = 3, kConflicts = 4, kNumerical = 5, kOutput = 6, kBug = 70 };

/// Each throws `InputError` and `OutputError`; numerical failure and conflicts are in the exit code. Results go to
/// stdout, conflicts, warnings and progress to stderr.
[[nodiscard]] ExitCode runDeform(const DeformCommand& command);
[[nodiscard]] ExitCode runCheck(const CheckCommand& command);

}  // namespace holdfast::batch
