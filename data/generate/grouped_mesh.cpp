#include "grouped_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace holdfast::generate {
namespace {

Index endOf(const GroupedMesh& mesh, std::size_t group)
{
  return group + 1 < mesh.groups.size() ? mesh.groups[group + 1].firstFace : static_cast<Index>(mesh.triangles.size());
}

}  // namespace

std::vector<Index> facesOf(const GroupedMesh& mesh, const std::string& name)
{
  std::vector<Index> result;
  for (std::size_t group = 0; group < mesh.groups.size(); ++group) {
    if (mesh.groups[group].name != name) continue;
    for (Index face = mesh.groups[group].firstFace; face < endOf(mesh, group); ++face) result.push_back(face);
  }
  if (result.empty()) throw std::logic_error("no faces in group " + name);
  return result;
}

GroupedMesh gathered(const GroupedMesh& mesh)
{
  GroupedMesh result;
  result.points = mesh.points;
  for (const Group& group : mesh.groups) {
    const auto isSame = [&](const Group& other) { return other.name == group.name; };
    if (std::ranges::any_of(result.groups, isSame)) continue;
    result.groups.push_back({group.name, static_cast<Index>(result.triangles.size())});
    for (const Index face : facesOf(mesh, group.name)) result.triangles.push_back(mesh.triangles[face]);
  }
  return result;
}

Vector3 rounded(const Vector3& place)
{
  constexpr double kPerUnit = 1e6;
  // Adding zero turns -0 into 0.
  return place.unaryExpr([](double coordinate) { return std::round(coordinate * kPerUnit) / kPerUnit + 0.0; });
}

GroupedMesh rounded(GroupedMesh mesh)
{
  for (Vector3& point : mesh.points) point = rounded(point);
  return mesh;
}

}  // namespace holdfast::generate
