#pragma once
/// What this build reads, writes and draws: the mesh formats of the core, and what VTK can do where it is built.

#include <filesystem>
#include <span>
#include <string>

#include <holdfast/deform/deform.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/field.h>

namespace holdfast::batch {

/// The extensions that are read as one text for people: ".obj, .ply, ...".
[[nodiscard]] std::string knownFormats();
/// The values of `--color-by` in the same way; empty in a build without VTK.
[[nodiscard]] std::string knownColorings();

/// What `--snapshot`, `--color-by` and `--size` say. `path` is empty for no picture.
struct PictureRequest {
  std::string path;
  std::string colorBy = "displacement";
  std::string size = "1280x960";
};

/// Each throws `UsageError` unless this build can write a mesh, fields, a picture under this name and with these
/// options.
void requireMeshExtension(const std::filesystem::path& path);
void requireFieldsExtension(const std::filesystem::path& path);
void requirePictureOptions(const PictureRequest& request);

/// Throws `OutputError` if no picture can be drawn here. Costs about a tenth of a second.
void requireDisplay(const PictureRequest& request);

[[nodiscard]] MeshDocument readMeshFile(const std::filesystem::path& path);

/// The contents of files: a mesh in the format that `path` names, fields over the vertices of `mesh` at `positions`
/// (VTP), a picture (PNG). They throw `OutputError`.
[[nodiscard]] Serialized serializeMeshFile(const MeshDocument& document, const Positions& positions,
                                           const std::filesystem::path& path);
[[nodiscard]] Serialized serializeFields(const Mesh& mesh, const Positions& positions, std::span<const Field> fields);
[[nodiscard]] std::string snapshot(const PictureRequest& request, const Model& model, const DeformResult& deformation,
                                   const std::string& units);

}  // namespace holdfast::batch
