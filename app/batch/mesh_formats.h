#pragma once
/// \file
/// Mesh files of every format that this build knows: those of the core, and VTK's where VTK is built.

#include <filesystem>
#include <span>
#include <string>

#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/field.h>
#ifdef HOLDFAST_WITH_VTK
#include <holdfast/widgets/files/any_mesh_file.h>
#endif

namespace holdfast::batch {

/// The extensions that are read as one text for people: ".obj, .ply, ...".
[[nodiscard]] std::string knownFormats();

/// The extension of a file name, lower case with the dot: ".obj".
[[nodiscard]] std::string extensionOf(const std::filesystem::path& path);

/// Throws `UsageError` unless a mesh can be written under this name.
void requireMeshExtension(const std::filesystem::path& path);

/// Throws `UsageError` unless fields can be written under this name.
void requireFieldsExtension(const std::filesystem::path& path);

#ifdef HOLDFAST_WITH_VTK
using holdfast::readAnyMesh;
using holdfast::serializeAnyMesh;
#else
/// Reads a mesh by its extension. Throws `InputError`.
[[nodiscard]] MeshDocument readAnyMesh(const std::filesystem::path& path);

/// The contents of a mesh file of the format that `path` names.
[[nodiscard]] Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions,
                                          const std::filesystem::path& path);
#endif

/// The contents of a VTP file with fields over the vertices of `mesh` at `positions`.
[[nodiscard]] Serialized serializeFields(const Mesh& mesh, const Positions& positions, std::span<const Field> fields);

}  // namespace holdfast::batch
