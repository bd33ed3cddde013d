#include "batch/standard_streams.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

#include <holdfast/base/error.h>
#include <holdfast/io/files/file_descriptor.h>

namespace holdfast::batch {

void printResult(std::string_view text)
{
  if (text.empty()) return;
  FileDescriptor output(::dup(STDOUT_FILENO));
  const int writing = output.isOpen() ? writeAll(output, text) : errno;
  // Some file systems report only now that there was no room.
  const int closing = output.close();
  if (writing == 0 && closing == 0) return;
  throw OutputError("standard output", fmt::format("cannot be written ({}): send it where there is room for it",
                                                   std::strerror(writing != 0 ? writing : closing)));
}

void printMessage(std::string_view text) noexcept
{
  const FileDescriptor output(::dup(STDERR_FILENO));
  if (output.isOpen()) static_cast<void>(writeAll(output, text));
}

}  // namespace holdfast::batch
