#pragma once
/// How a session finds its mesh again, and knows whether it is still the same.

#include <filesystem>
#include <string>
#include <string_view>

#include <holdfast/document/session_file.h>

namespace holdfast {

/// "fnv1a64:" and 16 digits: the 64-bit FNV-1a hash of the file's bytes. It tells a mesh that was exported anew, not
/// one that was forged. Throws `InputError` where the file cannot be read. O(size of the file).
[[nodiscard]] std::string checksumOfFile(const std::filesystem::path& path);

/// The same of a file with these bytes.
[[nodiscard]] std::string checksumOfBytes(std::string_view bytes);

/// Whether `text` is what `checksumOfFile` could return.
[[nodiscard]] bool isChecksum(std::string_view text);

/// The reference of a session at `session` to the mesh at `mesh`, neither of which need exist. The path is relative:
/// both may move together.
[[nodiscard]] MeshReference referenceTo(const std::filesystem::path& mesh, const std::filesystem::path& session,
                                        std::string checksum);

enum class MeshState {
  Same,     ///< as it was, or the session does not say how it was
  Changed,  ///< the bytes of the file are others
  Missing   ///< neither where the session says nor where it was when that was written, or not to be read
};

struct ResolvedMesh {
  std::filesystem::path path;
  MeshState state = MeshState::Missing;
  std::string message;  ///< for the user, of a mesh that is not the same: what is wrong, where, and what to do
};

/// Finds the mesh of the session at `sessionPath`: the path from the session's folder first, the absolute one then. A
/// mesh that is the same goes before one that has changed. Reads the meshes that it finds.
[[nodiscard]] ResolvedMesh resolveMesh(const SessionFile& session, const std::filesystem::path& sessionPath);

}  // namespace holdfast
