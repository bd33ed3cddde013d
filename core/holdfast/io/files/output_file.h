#pragma once
/// An output file is either whole or not there: it is written aside, then renamed.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace holdfast {

/// An output file writes its bytes to a temporary file beside `path`. `commit` puts that in place with one rename.
/// Symbolic links are followed, and a file that is replaced keeps its permissions. Devices and pipes are written
/// directly at `commit`. So is the file that standard output or standard error already goes to. The temporary file is
/// locked while the output is unfinished. The next output in the folder removes those that a killed program has left.
class OutputFile {
 public:
  /// Writes `bytes` aside and flushes them to disk. Throws `OutputError` (folder missing, not writable, disk full), and
  /// leaves nothing behind then. O(bytes + files in the folder).
  OutputFile(std::filesystem::path path, std::string_view bytes);
  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Puts the file in place, once. Throws `OutputError`. To write several files together, make all of them first, then
  /// commit each. Commit those that are `isDirect` before the others: a device may be full, a rename hardly fails.
  void commit();

  /// Tells whether the bytes go to a device, a pipe or a standard stream at `commit`, and not aside before.
  [[nodiscard]] bool isDirect() const noexcept { return target_.empty(); }

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  struct Temporary;

  [[nodiscard]] int openTemporary(bool isReplacing);

  std::filesystem::path path_;            // as the user wrote it
  std::filesystem::path target_;          // with symbolic links followed; empty for what is written directly
  std::unique_ptr<Temporary> temporary_;  // null once committed, and for what is written directly
  std::string direct_;                    // bytes for what is written directly
};

/// `removeUnfinishedOutputs` can know of this many outputs at a time. Destructors alone remove those beyond.
inline constexpr int kTrackedOutputs = 32;

/// Removes the temporary file of every `OutputFile` that is not yet committed. A signal handler may call this.
void removeUnfinishedOutputs() noexcept;

}  // namespace holdfast
