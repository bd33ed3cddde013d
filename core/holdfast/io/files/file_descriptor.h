#pragma once
/// A `FileDescriptor` closes its open file by itself. Two functions write all of a text to it.

#include <cerrno>
#include <string_view>
#include <utility>

#include <unistd.h>

namespace holdfast {

/// Owns the descriptor of an open file of the operating system, and closes it. -1 means that there is none.
class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor = -1) noexcept : descriptor_(descriptor) {}
  ~FileDescriptor() { static_cast<void>(close()); }
  FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept
  {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  [[nodiscard]] int get() const noexcept { return descriptor_; }
  [[nodiscard]] bool isOpen() const noexcept { return descriptor_ >= 0; }

  /// Closes the file now. Returns 0, or the errno of a write that failed only then.
  [[nodiscard]] int close() noexcept
  {
    if (descriptor_ < 0) return 0;
    // The close is not tried again after EINTR, because Linux has closed the descriptor by then.
    return ::close(std::exchange(descriptor_, -1)) == 0 || errno == EINTR ? 0 : errno;
  }

 private:
  int descriptor_;
};

/// Writes all of `bytes`. Returns 0, or an errno. An error may leave part of the bytes written.
[[nodiscard]] inline int writeAll(const FileDescriptor& file, std::string_view bytes) noexcept
{
  while (!bytes.empty()) {
    const auto written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;  // a device that takes nothing would be asked for ever
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Writes all of `bytes` and closes the file. Returns 0, or an errno. Some file systems say only at the close that they
/// are full.
[[nodiscard]] inline int writeAndClose(FileDescriptor file, std::string_view bytes) noexcept
{
  const int writing = file.isOpen() ? writeAll(file, bytes) : errno;
  const int closing = file.close();
  return writing != 0 ? writing : closing;
}

}  // namespace holdfast
