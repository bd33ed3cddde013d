#pragma once
/// Whole files in memory.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace holdfast {

/// Looks at the next block of a file that is being read, and throws where the rest is not worth its memory.
using BlockCheck = std::function<void(std::string_view block)>;

/// The bytes of a regular file that is not empty. Throws `InputError` for anything else, and where it cannot be read.
/// `check` sees the blocks of a file one after the other; memory for the whole file is taken after the first of them.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path, const BlockCheck& check = {});

/// The bytes of a file or a pipe. Throws `InputError` where it is missing, a directory, unreadable, or larger than
/// 256 MiB.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

}  // namespace holdfast
