#pragma once
/// What holdfast-batch is asked for, and does.

#include <functional>
#include <stdexcept>
#include <string>

#include <holdfast/document/stated_options.h>

#include "batch/formats.h"

namespace holdfast::batch {

/// The options of `holdfast-batch deform` and `holdfast-batch check`. Files that were left out are empty.
struct Command {
  std::string mesh;
  std::string constraints;
  std::string out;
  std::string report;
  std::string fields;
  PictureRequest picture;
  StatedOptions options;  ///< those of the command line
  bool isQuiet = false;
};

/// The command line cannot be understood; `what()` says why and what to do.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// docs/errors.md explains them.
enum ExitCode : int { kAllMet = 0, kUsage = 2, kInput = 3, kConflicts = 4, kNumerical = 5, kOutput = 6, kBug = 70 };

/// Each throws `InputError` and `OutputError`; numerical failure and conflicts are in the exit code. Results go to
/// stdout, conflicts, warnings and progress to stderr.
[[nodiscard]] ExitCode runDeform(const Command& command);
[[nodiscard]] ExitCode runCheck(const Command& command);

/// What the command line asks for: one of these, or the text that `--help` or `--version` asks for. Throws
/// `UsageError`: unknown options and values, outputs of unknown formats, two outputs with one name, outputs that would
/// overwrite an input.
[[nodiscard]] std::function<ExitCode()> parseCommandLine(int argc, const char* const* argv);

}  // namespace holdfast::batch
