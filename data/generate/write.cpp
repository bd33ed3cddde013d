#include "write.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <stdexcept>

#include <Eigen/Geometry>

namespace holdfast::generate {
namespace {

std::string coordinates(const Vector3& point)
{
  return numberText(point.x()) + " " + numberText(point.y()) + " " + numberText(point.z());
}

template <typename Number>
void appendLittleEndian(std::string& bytes, Number number)
{
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.begin(), raw.end());
}

}  // namespace

std::string numberText(double number)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

std::string objText(const GroupedMesh& mesh, const std::string& title)
{
  std::string text = "# " + title + "\n";
  for (const Vector3& point : mesh.points) text += "v " + coordinates(point) + "\n";
  std::size_t group = 0;
  for (Index face = 0; face < static_cast<Index>(mesh.triangles.size()); ++face) {
    while (group < mesh.groups.size() && mesh.groups[group].firstFace == face) {
      text += "g " + mesh.groups[group++].name + "\n";
    }
    const auto [a, b, c] = mesh.triangles[face];
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  }
  return text;
}

std::string offText(const GroupedMesh& mesh, const std::string& title)
{
  std::string text = "OFF\n# " + title + "\n";
  text += std::to_string(mesh.points.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vector3& point : mesh.points) text += coordinates(point) + "\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

std::string stlText(const GroupedMesh& mesh, const std::string& title)
{
  std::string text = "solid " + title + "\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    text += "  facet normal " + coordinates((q - p).cross(r - p).normalized()) + "\n";
    text += "    outer loop\n";
    for (const Vector3& corner : {p, q, r}) text += "      vertex " + coordinates(corner) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid " + title + "\n";
}

std::string plyBytes(const GroupedMesh& mesh, const std::string& title)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + title + "\n";
  bytes += "element vertex " + std::to_string(mesh.points.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) bytes += std::string("property double ") + axis + "\n";
  bytes += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  bytes += "property list uchar int vertex_indices\nend_header\n";
  for (const Vector3& point : mesh.points) {
    for (const double coordinate : point) appendLittleEndian(bytes, coordinate);
  }
  for (const Triangle& triangle : mesh.triangles) {
    appendLittleEndian(bytes, std::uint8_t{3});
    for (const Index corner : triangle) appendLittleEndian(bytes, static_cast<std::int32_t>(corner));
  }
  return bytes;
}

void writeFile(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace holdfast::generate
