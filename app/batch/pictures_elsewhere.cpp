#include <filesystem>

#include <unistd.h>

#include "batch/batch.h"

namespace holdfast::batch {

void requirePicture(const PictureRequest& picture)
{
  throw UsageError("--snapshot: there is no VTK to draw \"" + picture.path + "\" with; leave the option out");
}

std::string knownColorings()
{
  return {};
}

// Options that ask for these are refused.
void requireDisplay(const PictureRequest& /*picture*/) {}
std::string snapshot(const PictureRequest& /*picture*/, const Model& /*model*/, const DeformResult& /*deformation*/,
                     const std::string& /*units*/)
{
  return {};
}

void goOnWithVtk(char** argv)
{
  std::error_code none;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", none);
  ::execv((own.parent_path() / "holdfast-batch-vtk").c_str(), argv);
}

}  // namespace holdfast::batch
