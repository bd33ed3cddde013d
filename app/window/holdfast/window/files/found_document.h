#pragma once
/// \file
/// What is to be opened, read on any thread.

#include <filesystem>
#include <optional>
#include <string>

#include <holdfast/base/progress.h>
#include <holdfast/document/session_file.h>
#include <holdfast/document/session_mesh.h>
#include <holdfast/window/model/loaded_mesh.h>

namespace holdfast {

/// A mesh or a session as the files say it.
struct FoundDocument {
  SessionFile session;
  ResolvedMesh resolved;           ///< where the mesh is, and whether it is the session's
  std::optional<LoadedMesh> mesh;  ///< read where it is the session's
  std::string meshChecksum;        ///< of what was read
};

/// By the extension, any case.
[[nodiscard]] bool isSessionFile(const std::filesystem::path& path);

/// Reads a session and its mesh, or a mesh as a document without constraints. Throws as `readSession` and `loadMesh`
/// do, and what `progress` throws.
[[nodiscard]] FoundDocument findDocument(const std::filesystem::path& path, Progress& progress);

/// The same of a session that was read before, and of whose mesh the user has said more since.
[[nodiscard]] FoundDocument findMesh(SessionFile session, const std::filesystem::path& sessionPath, Progress& progress);

}  // namespace holdfast
