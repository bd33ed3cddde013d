#pragma once
/// \file
/// Runs a program as its user does and tells what came of it.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace holdfast::test {

struct ProcessOptions {
  /// A program that takes longer is killed.
  std::chrono::seconds timeout{300};
  /// No file may grow beyond this many bytes: the full disk of the tests.
  std::optional<long> largestFile;
  /// The program may use this many bytes of address space: the small machine of the tests.
  std::optional<long> addressSpace;
  /// Standard output is a pipe whose reader has gone.
  bool isOutUnread = false;
  /// The files that get standard output and standard error; the result has nothing of them then.
  std::string outPath;
  std::string errPath;
  /// Permissions count also where the tests are run by root, for whom otherwise no folder is read-only.
  bool obeysPermissions = false;
  /// `signal` is sent once, as soon as the program's standard error holds `signalAt`.
  int signal = 0;
  std::string signalAt;
};

struct ProcessResult {
  int exitCode = -1;  ///< -1 where a signal ended the program
  int signal = 0;     ///< 0 where the program ended by itself
  bool isTimedOut = false;
  std::string out;
  std::string err;
};

/// The exit code of a program that could not be given its limits: that of prlimit and setpriv (util-linux).
inline constexpr int kNotStarted = 127;

/// Runs `command` (the program's path and its arguments) to its end, with nothing to read. Throws `std::system_error`
/// where no process can be made of it.
[[nodiscard]] ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options = {});

}  // namespace holdfast::test
