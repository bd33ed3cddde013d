#pragma once
/// \file
/// The command line of holdfast-batch.

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include <holdfast/document/stated_options.h>

#include "batch/pictures.h"

namespace holdfast::batch {

/// `holdfast-batch deform`
struct DeformCommand {
  std::filesystem::path mesh;
  std::filesystem::path constraints;
  std::optional<std::filesystem::path> out;
  std::optional<std::filesystem::path> report;
  std::optional<std::filesystem::path> fields;
  std::optional<PictureRequest> picture;
  StatedOptions options;  ///< those of the command line
  bool isQuiet = false;
};

/// `holdfast-batch check`
struct CheckCommand {
  std::filesystem::path mesh;
  std::optional<std::filesystem::path> constraints;
  std::optional<std::filesystem::path> report;
  StatedOptions options;  ///< those of the command line
  bool isQuiet = false;
};

/// The text that `--help` or `--version` asked for.
struct ShowText {
  std::string text;
};

using Command = std::variant<DeformCommand, CheckCommand, ShowText>;

/// The command line cannot be understood; `what()` says why and what to do.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Understands the command line, or throws `UsageError`: unknown options and values, outputs of unknown formats, two
/// outputs with one name, outputs that would overwrite an input.
[[nodiscard]] Command parseCommandLine(int argc, const char* const* argv);

}  // namespace holdfast::batch
