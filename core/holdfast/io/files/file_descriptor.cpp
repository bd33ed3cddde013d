#include "holdfast/io/files/file_descriptor.h"

#include <cerrno>

#include <unistd.h>

namespace holdfast {

int FileDescriptor::close() noexcept
{
  if (descriptor_ < 0) return 0;
  // Not tried again after EINTR: Linux has closed the descriptor by then.
  return ::close(std::exchange(descriptor_, -1)) == 0 || errno == EINTR ? 0 : errno;
}

int writeAll(const FileDescriptor& file, std::string_view bytes) noexcept
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

}  // namespace holdfast
