#pragma once
/// \file
/// A whole job of a user: files of its own, the window, and a picture at the end.

#include <filesystem>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "window/files_window.h"
#include "window/window_user.h"

namespace holdfast::test {

class JobWindow : public WindowUser {
 protected:
  void TearDown() override;

  /// Until the window has the keys: a dialog that closes gives them back a moment later.
  void waitForKeys();
  /// Ctrl+O and the file; ends when it is open, solved and drawn.
  void openFile(const std::filesystem::path& path);
  /// A copy of a file of data/ in the folder of this job.
  [[nodiscard]] std::filesystem::path sample(const std::string& name) const;
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder.path() / name; }

  /// Chooses a tool by its key, and drags with the left button.
  void dragWith(Qt::Key tool, const std::vector<QPointF>& way);
  /// Selects vertices by a drag of a tool, and makes a constraint of them by a key. Its place in the list.
  Index constrainBy(Qt::Key tool, const std::vector<QPointF>& way, Qt::Key kind);

  [[nodiscard]] Vector3 restOf(Index vertex);
  [[nodiscard]] Vector3 nowOf(Index vertex);
  [[nodiscard]] const std::vector<Index>& verticesOf(Index constraint);

  /// All enabled constraints are met, within the limit that the report promises.
  void expectAllMet();
  /// Writes the window as jobs/SUITE.TEST.png beside the test program. The surface is seen where the camera says that
  /// it is, and beside it is the backdrop.
  void expectPicture();

  OwnSettings settings;
  TemporaryFolder folder;
};

}  // namespace holdfast::test
