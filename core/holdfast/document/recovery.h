#pragma once
/// Copies of unsaved work outlive a crash. Each open document has one. A lock tells them from copies of running
/// programs. The operating system releases the lock however a program ends.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/document/session_file.h>
#include <holdfast/io/files/file_descriptor.h>

namespace holdfast {

/// Returns `holdfast/recovery` below $XDG_STATE_HOME, or below ~/.local/state.
[[nodiscard]] std::optional<std::filesystem::path> recoveryFolder();

/// A recovery file is the copy of one open document.
class RecoveryFile {
 public:
  /// `folder` is made when the first copy is written.
  explicit RecoveryFile(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~RecoveryFile() { clear(); }
  RecoveryFile(const RecoveryFile&) = delete;
  RecoveryFile& operator=(const RecoveryFile&) = delete;

  /// Puts a copy of `session` in the place of the last one. `originalPath` is where the session is saved, or empty
  /// where it is not yet. The session names the mesh from there, or absolutely. Throws `OutputError`, and the last copy
  /// stays then.
  void write(SessionFile session, const std::filesystem::path& originalPath);

  /// Removes the copy. The next `write` makes another.
  void clear() noexcept;

 private:
  std::filesystem::path folder_;
  std::filesystem::path place_;  // a folder of its own; empty before the first copy
  FileDescriptor lock_;          // held for as long as that is there
};

struct Recoverable {
  std::filesystem::path path;                  ///< the copy, to be read with `readSession`
  std::filesystem::path original;              ///< the session that it is of; empty where that was never saved
  std::filesystem::path mesh;                  ///< absolute; empty where the copy cannot be read
  std::chrono::system_clock::time_point time;  ///< when the copy was written
  std::string name;                            ///< for the user: of the session's file, or of the mesh's
};

/// Returns the copies in `folder` whose programs are no more, the newest first. Copies that cannot be read are among
/// them.
[[nodiscard]] std::vector<Recoverable> recoverable(const std::filesystem::path& folder);

/// Removes the copy for good. This is harmless where another program has done so.
void discard(const Recoverable& copy) noexcept;

}  // namespace holdfast
