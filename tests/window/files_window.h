#pragma once
/// \file
/// A window with an editor and its files, in a folder and with settings of its own.

#include <QWidget>
#include <filesystem>
#include <string>
#include <vector>

#include <holdfast/window/files/document_files.h>
#include <holdfast/window/model/editor.h>

#include "support/temporary_folder.h"

namespace holdfast::test {

/// Settings that are gone with this.
class OwnSettings {
 public:
  OwnSettings();

 private:
  TemporaryFolder folder_;
};

/// Files are asked for in the order of `answers`; without one the dialog is cancelled.
struct FilesWindow {
  FilesWindow();

  /// Opens and waits until the document is open and solved.
  [[nodiscard]] bool open(const std::filesystem::path& path);
  [[nodiscard]] bool waitForCurrent();
  /// A copy of a sample in the folder of this window.
  [[nodiscard]] std::filesystem::path sample(const std::string& name) const;
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder.path() / name; }
  [[nodiscard]] FileChooser chooser();
  /// One edit: a point is held where it is.
  void holdVertex(Index vertex);

  OwnSettings settings;
  TemporaryFolder folder;
  QWidget window;
  Editor editor;
  DocumentFiles files{editor, &window};
  std::vector<std::filesystem::path> answers;
  std::vector<FileQuestion> questions;
};

}  // namespace holdfast::test
