#pragma once
/// \file
/// A window whose work is kept against a crash, and a program that works in one until it is killed.

#include <filesystem>
#include <memory>
#include <vector>

#include <holdfast/window/files/autosave.h>

#include "files_window.h"

namespace holdfast::test {

/// A window that keeps copies a moment after each change.
struct KeptWindow : FilesWindow {
  explicit KeptWindow(const std::filesystem::path& recoveryFolder);

  /// Tells whether that many copies were written.
  [[nodiscard]] bool waitForCopy(int number);

  int kept = 0;
  std::unique_ptr<Autosave> autosave;
};

/// The copies that lie below `folder`, of living programs as well.
[[nodiscard]] std::vector<std::filesystem::path> copiesIn(const std::filesystem::path& folder);

/// `list` with work that is lost without a copy: numbers with all their digits, and what is disabled.
[[nodiscard]] ConstraintList workOf(const ConstraintList& list);

/// An argument of the test program, followed by a folder: in the place of running tests it opens part.holdfast there,
/// or bracket.obj, works (`workOf`, uniform weights), keeps copies in recovery/, says `kWorkIsKept` on standard error,
/// and waits to be killed.
inline constexpr const char* kWorkUntilKilled = "--work-until-killed";
inline constexpr const char* kWorkIsKept = "the work is kept";
[[nodiscard]] int workUntilKilled(const std::filesystem::path& folder);

}  // namespace holdfast::test
