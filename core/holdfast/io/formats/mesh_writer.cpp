#include <algorithm>
#include <cmath>
#include <limits>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/triangulation.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

template <class Numbers>
std::string joined(const Numbers& numbers)
{
  std::string text;
  for (const auto number : numbers) text.append(text.empty() ? "" : " ").append(NumberText(number).view());
  return text;
}

Index largestFace(const Polygons& faces)
{
  std::size_t largest = 0;
  for (Index f = 0; f < faces.size(); ++f) largest = std::max(largest, faces[f].size());
  return static_cast<Index>(largest);
}

/// How many have more than three corners.
Index polygonsIn(const Polygons& faces)
{
  Index count = 0;
  for (Index f = 0; f < faces.size(); ++f) count += faces[f].size() > 3 ? 1 : 0;
  return count;
}

/// Throws `OutputError` where `count` is more than a file with 32-bit numbers can say.
template <class Number>
Number narrowed(Index count, const std::string& extension)
{
  if (count > static_cast<Index>(std::numeric_limits<Number>::max()))
    throw OutputError(
        extension, fmt::format("{} is more than the 32-bit numbers of this format can count: write OBJ or OFF", count));
  return static_cast<Number>(count);
}

std::string stlBytes(const Vector3& vector)
{
  std::string bytes;
  for (const double value : vector) bytes += toBytes(static_cast<float>(value), std::endian::little);
  return bytes;
}

std::string stlFacet(const Positions& positions, const Triangle& corners)
{
  std::string bytes = stlBytes(unitOrZero(areaVector(positions, corners)));
  for (const Index corner : corners) bytes += stlBytes(positions.row(corner));
  return bytes + std::string(2, '\0');  // no attributes
}

}  // namespace

Serialized writeObj(const Mesh& rest, const Positions& positions)
{
  const Polygons& faces = rest.faces;
  std::string text;
  for (Index v = 0; v < positions.rows(); ++v) text += "v " + joined(positions.row(v)) + '\n';
  std::vector<Index> numbers;  // of corners, from 1
  for (Index f = 0; f < faces.size(); ++f) {
    numbers.clear();
    for (const Index corner : faces[f]) numbers.push_back(corner + 1);
    text += "f " + joined(numbers) + '\n';
  }
  return {std::move(text), {}};
}

Serialized writeOff(const Mesh& rest, const Positions& positions)
{
  const Polygons& faces = rest.faces;
  std::string text = fmt::format("OFF\n{} {} 0\n", positions.rows(), faces.size());
  for (Index v = 0; v < positions.rows(); ++v) text += joined(positions.row(v)) + '\n';
  for (Index f = 0; f < faces.size(); ++f) text += fmt::format("{} {}\n", faces[f].size(), joined(faces[f]));
  return {std::move(text), {}};
}

Serialized writePly(const Mesh& rest, const Positions& positions)
{
  const Polygons& faces = rest.faces;
  static_cast<void>(narrowed<std::int32_t>(positions.rows(), ".ply"));
  const bool isCountInt = largestFace(faces) > std::numeric_limits<std::uint8_t>::max();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list {} int vertex_indices\nend_header\n",
      positions.rows(), faces.size(), isCountInt ? "int" : "uchar");
  for (Index v = 0; v < positions.rows(); ++v)
    for (Index k = 0; k < 3; ++k) bytes += toBytes(positions(v, k), std::endian::little);
  for (Index f = 0; f < faces.size(); ++f) {
    if (isCountInt)
      bytes += toBytes(static_cast<std::int32_t>(faces[f].size()), std::endian::little);
    else
      bytes += static_cast<char>(faces[f].size());
    for (const Index corner : faces[f]) bytes += toBytes(static_cast<std::int32_t>(corner), std::endian::little);
  }
  return {std::move(bytes), {}};
}

Serialized writeStl(const Mesh& rest, const Positions& positions)
{
  constexpr std::size_t kStlHeaderBytes = 80;
  Serialized result;
  result.stored = storedInStl(positions, result.notes);
  result.bytes = "Holdfast";
  result.bytes.resize(kStlHeaderBytes, ' ');
  const std::vector<Triangle> triangles = triangulate(rest).triangles;
  result.bytes += toBytes(narrowed<std::uint32_t>(std::ssize(triangles), ".stl"), std::endian::little);
  for (const Triangle& triangle : triangles) result.bytes += stlFacet(positions, triangle);
  const Index split = polygonsIn(rest.faces);
  if (split > 0) result.notes.push_back(counted(split, "polygon") + " split into triangles");
  return result;
}

Positions storedInStl(const Positions& positions, std::vector<std::string>& notes)
{
  constexpr double kLargestFloat = std::numeric_limits<float>::max();
  Index count = 0;     // coordinates that a float cannot hold
  double largest = 0;  // largest |x - float(x)|, in model units
  for (const double x : positions.reshaped()) {
    if (!std::isfinite(x)) continue;
    if (std::abs(x) > kLargestFloat)
      throw OutputError(".stl", fmt::format("the coordinate {} is too large for single precision, which is all that "
                                            "binary STL holds: write PLY, OBJ or OFF instead",
                                            x));
    const double error = std::abs(x - static_cast<double>(static_cast<float>(x)));
    if (error > 0) ++count;
    largest = std::max(largest, error);
  }
  if (count > 0)
    notes.push_back(fmt::format(
        "STL stores single precision: {} rounded, off by at most {:.3g}; write PLY, OBJ or OFF to keep every digit",
        counted(count, "coordinate"), largest));
  return positions.cast<float>().cast<double>();
}

}  // namespace holdfast
