#pragma once
/// The exceptions of Holdfast. A file, an option or an output that cannot be used throws one of these. The exception
/// carries what a program needs to say where the fault is. `what()` is the whole sentence for the user, on one
/// printable line (see `printable`). Constraints that cannot be met and numerical outcomes are values, never
/// exceptions.

#include <stdexcept>
#include <string>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A place in something that the user gave. Only `file` need be set.
struct InputLocation {
  std::string file;     ///< the path as the user wrote it
  Index line = 0;       ///< the line from 1; 0 where lines mean nothing (binary files) or are not known
  std::string element;  ///< a JSON path ("constraints[3].at.face"), "vertex 12" or "byte 1024"; may be empty
};

/// This is thrown when an input cannot be read or is not usable. `what()` is "file:line: element: reason".
///
///     try {
///       show(readMesh("bracket.obj").mesh);
///     } catch (const InputError& error) {
///       std::cerr << error.what() << '\n';
///       highlightLine(error.location().file, error.location().line);
///     }
class InputError : public std::runtime_error {
 public:
  /// `reason` says what is wrong and what to do about it, without the place.
  InputError(InputLocation location, const std::string& reason);

  [[nodiscard]] const InputLocation& location() const noexcept { return location_; }
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  InputLocation location_;
  std::string reason_;
};

/// This is thrown when an output cannot be written. `what()` is "path: reason". Nothing is left half-written.
class OutputError : public std::runtime_error {
 public:
  OutputError(std::string path, const std::string& reason);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

}  // namespace holdfast
