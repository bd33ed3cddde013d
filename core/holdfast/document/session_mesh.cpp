#include "holdfast/document/session_mesh.h"

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/files/file_bytes.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kAlgorithm = "fnv1a64:";
constexpr std::size_t kDigits = 16;

/// `path` with the symbolic links of its folders followed, but not that of the file itself: a link to a mesh moves with
/// the folder that it is in.
fs::path inRealFolder(const fs::path& path)
{
  std::error_code ignored;
  const fs::path absolute = fs::absolute(path, ignored).lexically_normal();
  const fs::path folder = fs::weakly_canonical(absolute.parent_path(), ignored);
  return (folder.empty() ? absolute.parent_path() : folder) / absolute.filename();
}

ResolvedMesh examined(const fs::path& path, const std::string& checksum)
{
  try {
    const std::string found = checksumOfFile(path);
    if (checksum.empty() || found == checksum) return {path, MeshState::Same, ""};
    return {
        path, MeshState::Changed,
        fmt::format("{}: the mesh is not the one that the session was saved with (checksum {} instead of {}). Vertex "
                    "and face ids may mean other places now: check the constraints, or bring the old file back",
                    path.string(), found, checksum)};
  } catch (const InputError& error) {
    return {path, MeshState::Missing, fmt::format("{}. Choose where the mesh of the session is", error.what())};
  }
}

}  // namespace

std::string checksumOfFile(const fs::path& path)
{
  return checksumOfBytes(readFileBytes(path));
}

std::string checksumOfBytes(std::string_view bytes)
{
  // The Fowler-Noll-Vo hash, variant 1a, with the published constants.
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3U;
  return fmt::format("{}{:016x}", kAlgorithm, hash);
}

bool isChecksum(std::string_view text)
{
  if (!text.starts_with(kAlgorithm) || text.size() != kAlgorithm.size() + kDigits) return false;
  return text.find_first_not_of("0123456789abcdef", kAlgorithm.size()) == std::string_view::npos;
}

MeshReference referenceTo(const fs::path& mesh, const fs::path& session, std::string checksum)
{
  const fs::path target = inRealFolder(mesh);
  return {target.lexically_proximate(inRealFolder(session).parent_path()).generic_string(), target.generic_string(),
          std::move(checksum)};
}

ResolvedMesh resolveMesh(const SessionFile& session, const fs::path& sessionPath)
{
  const MeshReference& mesh = session.mesh;
  std::vector<ResolvedMesh> found{examined(sessionPath.parent_path() / mesh.path, mesh.checksum)};
  if (!mesh.absolutePath.empty() && found.front().path != mesh.absolutePath)
    found.push_back(examined(mesh.absolutePath, mesh.checksum));
  // Same before Changed before Missing; of equals the likelier.
  return *std::ranges::min_element(found, {}, &ResolvedMesh::state);
}

}  // namespace holdfast
