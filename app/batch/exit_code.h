#pragma once
/// \file
/// The exit codes of holdfast-batch. docs/errors.md explains them.

namespace holdfast::batch {

enum ExitCode : int { kAllMet = 0, kUsage = 2, kInput = 3, kConflicts = 4, kNumerical = 5, kOutput = 6, kBug = 70 };

}  // namespace holdfast::batch
