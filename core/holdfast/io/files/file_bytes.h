#pragma once
/// \file
/// Whole files in memory.

#include <filesystem>
#include <string>

namespace holdfast {

/// The bytes of a regular file. Throws `InputError` where there is no such file, where it is a directory, a device or
/// a pipe, where it cannot be read, and where it is empty.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path);

}  // namespace holdfast
