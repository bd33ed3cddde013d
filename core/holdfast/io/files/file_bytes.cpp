#include "holdfast/io/files/file_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include <holdfast/words/error.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
  throw InputError({path.string(), 0, {}}, reason);
}

fs::file_status checkedStatus(const fs::path& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) fail(path, "there is no such file: check the name and the folder");
  if (error) fail(path, fmt::format("cannot be looked up ({}): check the name and the folder", error.message()));
  if (fs::is_directory(status)) fail(path, "is a directory: name a file in it");
  return status;
}

std::string contents(const fs::path& path, std::size_t most, const BlockCheck& check)
{
  const auto failToRead = [&] {
    fail(path, fmt::format("cannot be read ({}): check its permissions",
                           std::error_code(errno, std::generic_category()).message()));
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) failToRead();
  std::string bytes;
  std::error_code unknown;  // a pipe has no size
  const std::uintmax_t size = fs::file_size(path, unknown);
  std::array<char, 65536> buffer{};
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    const std::string_view block(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (check) check(block);
    if (bytes.empty() && !unknown) bytes.reserve(std::min(size, most));
    bytes.append(block);
    if (bytes.size() > most)
      fail(path, fmt::format("larger than {} MiB; split it, or check that this is the right file", most >> 20U));
  }
  if (stream.bad()) failToRead();
  return bytes;
}

}  // namespace

std::string readFileBytes(const fs::path& path, const BlockCheck& check)
{
  // Pipes and devices may never end.
  if (!fs::is_regular_file(checkedStatus(path))) fail(path, "is not a regular file: copy its contents to one");
  std::string bytes = contents(path, std::string::npos, check);
  if (bytes.empty()) fail(path, "the file is empty: export the mesh again");
  return bytes;
}

std::string readTextFile(const fs::path& path)
{
  // A device that never ends must not fill the memory. A point takes about 100 bytes: room for two million.
  constexpr std::size_t kMaximumBytes = std::size_t{1} << 28U;
  static_cast<void>(checkedStatus(path));
  return contents(path, kMaximumBytes, {});
}

}  // namespace holdfast
