#include "holdfast/window/files/found_document.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace holdfast {

bool isSessionFile(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".holdfast";
}

FoundDocument findDocument(const std::filesystem::path& path, Progress& progress)
{
  progress.step(fmt::format("reading {}", path.filename().string()));
  if (isSessionFile(path)) return findMesh(readSession(path), path, progress);
  FoundDocument found;
  found.mesh = loadMesh(path, progress);
  found.resolved = {path, MeshState::Same, ""};
  progress.step("remembering which mesh it is");
  found.meshChecksum = checksumOfFile(path);
  return found;
}

FoundDocument findMesh(SessionFile session, const std::filesystem::path& sessionPath, Progress& progress)
{
  FoundDocument found;
  found.session = std::move(session);
  progress.step("looking for the mesh");
  found.resolved = resolveMesh(found.session, sessionPath);
  if (found.resolved.state != MeshState::Same) return found;
  found.mesh = loadMesh(found.resolved.path, progress);
  progress.step("remembering which mesh it is");
  found.meshChecksum = checksumOfFile(found.resolved.path);
  return found;
}

}  // namespace holdfast
