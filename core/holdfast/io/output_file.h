#pragma once
/// \file
/// Output files that are either whole or not there: written aside, then renamed.

#include <filesystem>
#include <string>
#include <string_view>

namespace holdfast {

/// One output of a program. The bytes go to a temporary file beside `path`; `commit` puts it in place with one rename,
/// so that a reader, a full disk or a crash never meets half a file, and what stood at `path` stays until then. A
/// symbolic link is followed, the permissions of a file that is replaced are kept. A path that exists and is not a
/// regular file (a device, a pipe) is written directly at `commit`.
class OutputFile {
 public:
  /// Writes `bytes` aside and flushes them to disk. Throws `OutputError` (folder missing, not writable, disk full)
  /// and leaves nothing behind then.
  OutputFile(std::filesystem::path path, std::string_view bytes);
  /// Removes the temporary file if `commit` was not called.
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Puts the file in place. Throws `OutputError`. Call at most once. To write several files together, make all of
  /// them first, then commit each.
  void commit();

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  // empty once committed, and for what is not a regular file
  std::string direct_;               // bytes for what is not a regular file
};

/// Removes the temporary file of every `OutputFile` that is not yet committed. Safe to call from a signal handler.
void removeUnfinishedOutputs() noexcept;

}  // namespace holdfast
