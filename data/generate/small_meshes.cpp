#include "small_meshes.h"

#include <cmath>
#include <numbers>

#include "box_surface.h"
#include "write.h"

namespace holdfast::generate {
namespace {

constexpr Index kAround = 32, kAcross = 16;

void append(GroupedMesh& mesh, const GroupedMesh& part, const std::string& name)
{
  const Index first = static_cast<Index>(mesh.points.size());
  mesh.groups.push_back({name, static_cast<Index>(mesh.triangles.size())});
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
}

double share(Index i, Index count)
{
  return static_cast<double>(i) / static_cast<double>(count);
}

GroupedMesh torusPoints()
{
  constexpr double kRadius = 20, kTube = 8;
  GroupedMesh result;
  for (Index i = 0; i < kAround; ++i) {
    for (Index j = 0; j < kAcross; ++j) {
      const double u = 2 * std::numbers::pi * share(i, kAround), v = 2 * std::numbers::pi * share(j, kAcross);
      const double radius = kRadius + kTube * std::cos(v);
      result.points.emplace_back(radius * std::cos(u), radius * std::sin(u), kTube * std::sin(v));
    }
  }
  return rounded(result);
}

std::string quadCorner(Index i, Index j)
{
  const Index vertex = (i % kAround) * kAcross + j % kAcross;
  const Index texture = i * (kAcross + 1) + j;
  return " " + std::to_string(vertex + 1) + "/" + std::to_string(texture + 1);
}

std::string quadsOf(Index firstI, Index lastI)
{
  std::string text;
  for (Index i = firstI; i < lastI; ++i) {
    for (Index j = 0; j < kAcross; ++j) {
      text += "f" + quadCorner(i, j) + quadCorner(i + 1, j) + quadCorner(i + 1, j + 1) + quadCorner(i, j + 1) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string unweldedCubeStl()
{
  return stlText(boxSurface(Vector3::Zero(), 5, {2, 2, 2}), "cube_unwelded");
}

std::string twoPartsObj()
{
  constexpr Index kCells = 4;
  GroupedMesh mesh;
  append(mesh, boxSurface(Vector3::Zero(), 2.5, {kCells, kCells, kCells}), "left");
  append(mesh, boxSurface(Vector3(10, 0, 0), 2.5, {kCells, kCells, kCells}), "right");
  return objText(mesh, "two cubes that touch without sharing a vertex, mm");
}

std::string quadsObj(const std::string& materialFile)
{
  std::string text = "# a torus of quadrilaterals with texture coordinates, mm\nmtllib " + materialFile + "\n";
  for (const Vector3& p : torusPoints().points) {
    text += "v " + numberText(p.x()) + " " + numberText(p.y()) + " " + numberText(p.z()) + "\n";
  }
  for (Index i = 0; i <= kAround; ++i) {
    for (Index j = 0; j <= kAcross; ++j) {
      text += "vt " + numberText(share(i, kAround)) + " " + numberText(share(j, kAcross)) + "\n";
    }
  }
  text += "g first_half\nusemtl blue\n" + quadsOf(0, kAround / 2);
  return text + "g second_half\nusemtl grey\n" + quadsOf(kAround / 2, kAround);
}

std::string quadsMaterials()
{
  return "newmtl blue\nKd 0.25 0.45 0.75\n\nnewmtl grey\nKd 0.7 0.7 0.7\n";
}

}  // namespace holdfast::generate
