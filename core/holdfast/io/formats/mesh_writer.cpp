#include <algorithm>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/narrowed.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

/// "x y z" of one row.
std::string rowText(const Positions& positions, Index v)
{
  std::string text;
  for (Index k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    text += NumberText(positions(v, k)).view();
  }
  return text;
}

/// " a b c", each id raised by `firstId`.
std::string cornersText(std::span<const Index> polygon, Index firstId)
{
  std::string text;
  for (const Index corner : polygon) {
    text += ' ';
    text += NumberText(corner + firstId).view();
  }
  return text;
}

Index largestFace(const Polygons& faces)
{
  std::size_t largest = 0;
  for (Index f = 0; f < faces.size(); ++f) largest = std::max(largest, faces[f].size());
  return static_cast<Index>(largest);
}

}  // namespace

Serialized writeObj(const Positions& positions, const Polygons& faces)
{
  std::string text;
  for (Index v = 0; v < positions.rows(); ++v) text += "v " + rowText(positions, v) + '\n';
  for (Index f = 0; f < faces.size(); ++f) text += "f" + cornersText(faces[f], 1) + '\n';
  return {std::move(text), {}};
}

Serialized writeOff(const Positions& positions, const Polygons& faces)
{
  std::string text = fmt::format("OFF\n{} {} 0\n", positions.rows(), faces.size());
  for (Index v = 0; v < positions.rows(); ++v) text += rowText(positions, v) + '\n';
  for (Index f = 0; f < faces.size(); ++f) {
    text += NumberText(static_cast<Index>(faces[f].size())).view();
    text += cornersText(faces[f], 0) + '\n';
  }
  return {std::move(text), {}};
}

Serialized writePly(const Positions& positions, const Polygons& faces)
{
  static_cast<void>(narrowed<std::int32_t>(positions.rows(), ".ply"));
  const bool isCountInt = largestFace(faces) > std::numeric_limits<std::uint8_t>::max();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list {} int vertex_indices\nend_header\n",
      positions.rows(), faces.size(), isCountInt ? "int" : "uchar");
  for (Index v = 0; v < positions.rows(); ++v)
    for (Index k = 0; k < 3; ++k) bytes += toBytes(positions(v, k), ByteOrder::kLittle).view();
  for (Index f = 0; f < faces.size(); ++f) {
    if (isCountInt)
      bytes += toBytes(static_cast<std::int32_t>(faces[f].size()), ByteOrder::kLittle).view();
    else
      bytes += static_cast<char>(faces[f].size());
    for (const Index corner : faces[f]) bytes += toBytes(static_cast<std::int32_t>(corner), ByteOrder::kLittle).view();
  }
  return {std::move(bytes), {}};
}

}  // namespace holdfast
