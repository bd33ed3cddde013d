#include "holdfast/constraint_files/guide_files.h"

#include <map>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/guide_surface.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

fs::path absoluteFrom(const fs::path& folder, const std::string& path)
{
  std::error_code ignored;
  return fs::absolute(folder / path, ignored).lexically_normal();
}

}  // namespace

void readGuideFiles(ConstraintList& list, const fs::path& folder, const std::string& source)
{
  std::map<std::string, std::shared_ptr<const GuideSurface>> known;
  for (std::size_t c = 0; c < list.constraints.size(); ++c) {
    Constraint& constraint = list.constraints[c];
    OnMesh* const on = guideMeshOf(constraint);
    if (on == nullptr) continue;
    on->path = absoluteFrom(folder, on->path).generic_string();
    std::shared_ptr<const GuideSurface>& surface = known[on->path];
    try {
      if (surface == nullptr) surface = std::make_shared<const GuideSurface>(readMesh(on->path).mesh, on->path);
      on->surface = surface;
    } catch (const InputError& error) {
      if (!constraint.isEnabled) continue;
      throw InputError({source, 0, fmt::format("constraints[{}].on.mesh", c)},
                       fmt::format("{}: {}; put the mesh there, or disable the constraint", inQuotes(constraint.name),
                                   error.what()));
    }
  }
}

ConstraintList withGuidePathsFrom(ConstraintList list, const fs::path& folder)
{
  for (Constraint& constraint : list.constraints)
    if (OnMesh* const on = guideMeshOf(constraint))
      on->path = fs::path(on->path).lexically_proximate(absoluteFrom(folder, "")).generic_string();
  return list;
}

}  // namespace holdfast
