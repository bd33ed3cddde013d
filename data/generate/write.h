#pragma once
/// \file
/// Mesh files as text and bytes, and the writing of files.

#include <filesystem>
#include <string>

#include "grouped_mesh.h"

namespace holdfast::generate {

/// The shortest text that reads back as `number`.
[[nodiscard]] std::string numberText(double number);

/// `title` becomes a comment; groups are written as they are.
[[nodiscard]] std::string objText(const GroupedMesh& mesh, const std::string& title);
[[nodiscard]] std::string offText(const GroupedMesh& mesh, const std::string& title);
/// Corners are written face by face, unshared.
[[nodiscard]] std::string stlText(const GroupedMesh& mesh, const std::string& title);
/// Little-endian, coordinates as double, corners as int.
[[nodiscard]] std::string plyBytes(const GroupedMesh& mesh, const std::string& title);

/// Throws std::runtime_error where the file cannot be written.
void writeFile(const std::filesystem::path& path, const std::string& bytes);

}  // namespace holdfast::generate
