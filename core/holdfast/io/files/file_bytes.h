#pragma once
/// Whole files in memory.

#include <filesystem>
#include <string>

namespace holdfast {

/// The bytes of a regular file that is not empty. Throws `InputError` for anything else, and where it cannot be read.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path);

/// The bytes of a file or a pipe. Throws `InputError` where it is missing, a directory, unreadable, or larger than
/// 256 MiB.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

}  // namespace holdfast
