#pragma once
/// Reads what holdfast-batch is asked for, does it, and says what came of it.

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <holdfast/deform/deform.h>
#include <holdfast/document/session_file.h>

namespace holdfast::batch {

/// The values of `--snapshot`, `--color-by` and `--size`. `path` is empty if no picture is wanted.
struct PictureRequest {
  std::string path;
  std::string colorBy = "displacement";
  std::string size = "1280x960";
};

/// The options of `holdfast-batch deform` and `holdfast-batch check`. Files that were left out are empty.
struct Command {
  std::string mesh;
  std::string constraints;
  std::string out;
  std::string report;
  std::string fields;
  PictureRequest picture;
  StatedOptions options;  ///< those of the command line
  BadRows badRows = BadRows::Refuse;
  bool isQuiet = false;
};

/// The command line cannot be understood; `what()` says why and what to do.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// docs/errors.md explains them.
enum ExitCode : int { kAllMet = 0, kUsage = 2, kInput = 3, kConflicts = 4, kNumerical = 5, kOutput = 6, kBug = 70 };

/// Runs a command. This function and the next throw `InputError` and `OutputError`. Numerical failure and conflicts are
/// in the exit code.
[[nodiscard]] ExitCode runDeform(const Command& command);
[[nodiscard]] ExitCode runCheck(const Command& command);

/// Returns a call of `runDeform` or `runCheck`, or one that prints help. Throws `UsageError`, also if two outputs have
/// one name or an output has the name of an input.
[[nodiscard]] std::function<ExitCode()> parseCommandLine(int argc, const char* const* argv);

/// Returns the extensions of meshes that are read, as one text for people: ".obj, .ply, ...".
[[nodiscard]] std::string knownFormats();

/// Throws `UsageError` unless this build can write the outputs under these names and with these options.
void requireFormats(const Command& command);

/// There are two programs. One has VTK, and loading its libraries takes a tenth of a second. The other one has none,
/// and goes on as that one for pictures, help and whatever it does not understand. These functions differ between the
/// two.

/// Throws `UsageError` unless this program can draw such a picture under such a name.
void requirePicture(const PictureRequest& picture);

/// Returns the values of `--color-by`, as one text for people. The text is empty without VTK.
[[nodiscard]] std::string knownColorings();

/// Throws `OutputError` if no picture can be drawn here. This takes about a tenth of a second.
void requireDisplay(const PictureRequest& picture);

/// Returns the bytes of a picture (PNG). Throws `OutputError`.
[[nodiscard]] std::string snapshot(const PictureRequest& picture, const Model& model, const DeformResult& deformation,
                                   const std::string& units);

/// Goes on as the program with VTK that lies beside this one. Returns where it is not there, or is this one.
void goOnWithVtk(char** argv);

/// Returns a summary: the mesh and its findings, the constraints in numbers, the solve, and which constraints pull
/// hardest.
[[nodiscard]] std::string summary(const Report& report, const std::string& meshName, const std::string& units);

/// Returns a line for each row of the point list `source` that was left out, for standard error.
[[nodiscard]] std::string skippedLines(const Report& report, const std::string& source);

/// Returns messages for standard error: doubtful findings, the first few conflict sets with gap and repairs, and why
/// solving failed.
[[nodiscard]] std::string messageLines(const Report& report, const std::string& units);

/// Returns a line with the options that come from the session `source` because they were not asked for. It is empty if
/// there are none.
[[nodiscard]] std::string optionsLine(const StatedOptions& asked, const StatedOptions& session,
                                      const std::string& source);

/// Writes to standard output at once. Throws `OutputError` where the text does not arrive there (disk full, closed).
void printResult(std::string_view text);

/// Writes to standard error. Failures are ignored: there is no other place to report them.
void printMessage(std::string_view text) noexcept;

}  // namespace holdfast::batch
