#pragma once
/// These functions read whole files into memory.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace holdfast {

/// A check looks at the next block of a file that is being read. It throws where the rest is not worth its memory.
using BlockCheck = std::function<void(std::string_view block)>;

/// Returns the bytes of a regular file that is not empty. Throws `InputError` for anything else, and where the file
/// cannot be read. `check` sees the blocks of the file one after the other. Memory for the whole file is taken after
/// the first of them.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path, const BlockCheck& check = {});

/// Returns the bytes of a file or a pipe. Throws `InputError` where it is missing, a directory, unreadable, or larger
/// than 256 MiB.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

}  // namespace holdfast
