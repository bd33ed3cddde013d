#pragma once
/// \file
/// What holdfast-batch does.

#include "batch/exit_code.h"
#include "batch/options.h"

namespace holdfast::batch {

/// Each throws `InputError` and `OutputError`; numerical failure and conflicts are in the exit code. Results go to
/// stdout, conflicts, warnings and progress to stderr.
[[nodiscard]] ExitCode runDeform(const DeformCommand& command);
[[nodiscard]] ExitCode runCheck(const CheckCommand& command);

}  // namespace holdfast::batch
