#include "holdfast/io/files/file_bytes.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include <holdfast/base/error.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
  throw InputError({path.string(), 0, {}}, reason);
}

// Pipes and devices are refused: they may never end, and the name would have to be opened twice.
std::uintmax_t checkedSize(const fs::path& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) fail(path, "there is no such file: check the name and the folder");
  if (error) fail(path, fmt::format("cannot be looked up ({}): check the name and the folder", error.message()));
  if (fs::is_directory(status)) fail(path, "is a directory: name a file in it");
  if (!fs::is_regular_file(status)) fail(path, "is not a regular file: copy its contents to one");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) fail(path, fmt::format("its size cannot be found out ({})", error.message()));
  return size;
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string readFileBytes(const fs::path& path)
{
  const std::uintmax_t size = checkedSize(path);
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, fmt::format("cannot be opened ({}): check its permissions", std::strerror(errno)));
  std::string bytes(size, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0) fail(path, fmt::format("cannot be read ({})", std::strerror(errno)));
  if (bytes.empty()) fail(path, "the file is empty: export the mesh again");
  return bytes;
}

}  // namespace holdfast
