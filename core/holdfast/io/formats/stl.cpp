#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/counted.h>
#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/narrowed.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/formats/text_source.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/io/text/text_cursor.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

// Binary STL: a header, the count of facets (32 bits unsigned), the facets; numbers are little-endian.
constexpr std::size_t kStlHeaderBytes = 80;                        ///< then the count of facets, 32 bits unsigned
constexpr std::size_t kStlFacetsOffset = 84;                       ///< first facet
constexpr std::size_t kStlFacetBytes = 50;                         ///< normal, three corners, 16 bits of attributes
constexpr std::size_t kStlVectorBytes = 12;                        ///< three floats
constexpr std::size_t kStlAttributesOffset = 4 * kStlVectorBytes;  ///< in a facet

Vector3 stlVector(std::string_view bytes, std::size_t offset)
{
  Vector3 vector;
  for (Index k = 0; k < 3; ++k)
    vector[k] = static_cast<double>(fromBytes<float>(bytes.substr(offset + 4 * k, 4), ByteOrder::kLittle));
  return vector;
}

std::string stlBytes(const Vector3& vector)
{
  std::string bytes;
  for (const double value : vector) bytes += toBytes(static_cast<float>(value), ByteOrder::kLittle).view();
  return bytes;
}

/// How much single precision loses.
struct StlRounding {
  Index count = 0;     // coordinates that a float cannot hold
  double largest = 0;  // largest |x - float(x)|, in model units
};

/// What rounding all of `positions` loses. Throws `OutputError` where a coordinate is too large for a float.
StlRounding stlRounding(const Positions& positions)
{
  constexpr double kLargestFloat = std::numeric_limits<float>::max();
  StlRounding rounding;
  for (const double x : positions.reshaped()) {
    if (!std::isfinite(x)) continue;
    if (std::abs(x) > kLargestFloat)
      throw OutputError(".stl", fmt::format("the coordinate {} is too large for single precision, which is all that "
                                            "binary STL holds: write PLY, OBJ or OFF instead",
                                            x));
    const double error = std::abs(x - static_cast<double>(static_cast<float>(x)));
    if (error > 0) ++rounding.count;
    rounding.largest = std::max(rounding.largest, error);
  }
  return rounding;
}

void noteRounding(const Positions& positions, std::vector<std::string>& notes)
{
  const StlRounding rounding = stlRounding(positions);
  if (rounding.count == 0) return;
  notes.push_back(fmt::format(
      "STL stores single precision: {} rounded, off by at most {:.3g}; write PLY, OBJ or OFF to keep every digit",
      counted(rounding.count, "coordinate"), rounding.largest));
}

/// `count` facets, of which facet f has the vertices 3f, 3f + 1 and 3f + 2.
Polygons facets(Index count)
{
  Polygons faces;
  faces.reserve(count, 3 * count);
  for (Index f = 0; f < count; ++f) faces.add({3 * f, 3 * f + 1, 3 * f + 2});
  return faces;
}

/// Each facet has a normal of its own.
std::vector<Index> facetOfCorner(const Polygons& facets)
{
  std::vector<Index> facetOf(static_cast<std::size_t>(facets.cornerCount()));
  for (std::size_t corner = 0; corner < facetOf.size(); ++corner) facetOf[corner] = static_cast<Index>(corner / 3);
  return facetOf;
}

bool isWord(std::string_view token, std::string_view lower)
{
  return std::equal(token.begin(), token.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return lowerCase(a) == b; });
}

class TextStlReader {
 public:
  TextStlReader(std::string_view text, std::string file) : cursor_(text, std::move(file)) {}

  void read();
  [[nodiscard]] Positions positions() const
  {
    return Eigen::Map<const Positions>(coordinates_.data(), static_cast<Index>(layout_.vertexOffsets.size()), 3);
  }
  [[nodiscard]] TextLayout takeLayout() && { return std::move(layout_); }

 private:
  void readSolid();
  void readFacet();
  void readVertex();
  std::string_view word();
  void expect(std::string_view lower);
  double number(std::string_view what);

  TextCursor cursor_;
  std::vector<double> coordinates_;
  TextLayout layout_{".stl", {}, {}, {}, {}, {"facet normals", "names of solids"}};
};

void TextStlReader::read()
{
  while (cursor_.findToken()) {
    expect("solid");
    cursor_.skipLine();
    readSolid();
  }
  if (layout_.vertexOffsets.empty())
    cursor_.fail("the mesh has no faces: no facet stands in this file; export it again");
}

void TextStlReader::readSolid()
{
  for (std::string_view token = word(); !isWord(token, "endsolid"); token = word()) {
    if (!isWord(token, "facet"))
      cursor_.fail(fmt::format("{} stands where 'facet' or 'endsolid' must: correct it", quotedToken(token)));
    readFacet();
  }
  cursor_.skipLine();
}

void TextStlReader::readFacet()
{
  expect("normal");
  layout_.normalOffsets.push_back(cursor_.offset());
  for (int k = 0; k < 3; ++k) static_cast<void>(number("a component of the normal"));
  expect("outer");
  expect("loop");
  for (int k = 0; k < 3; ++k) readVertex();
  expect("endloop");
  expect("endfacet");
}

void TextStlReader::readVertex()
{
  expect("vertex");
  layout_.vertexOffsets.push_back(cursor_.offset());
  for (const std::string_view name : kCoordinateNames) coordinates_.push_back(number(name));
}

std::string_view TextStlReader::word()
{
  if (!cursor_.findToken())
    cursor_.fail("the file ends inside a solid, without 'endsolid': it is truncated; export it again");
  return cursor_.token();
}

void TextStlReader::expect(std::string_view lower)
{
  const std::string_view token = word();
  if (!isWord(token, lower))
    cursor_.fail(fmt::format("{} stands where '{}' must: correct it (a facet has a normal and exactly three vertices)",
                             quotedToken(token), lower));
}

double TextStlReader::number(std::string_view what)
{
  return numberOf(word(), what, cursor_);
}

MeshDocument readTextStl(std::string bytes, const std::string& file)
{
  TextStlReader reader(bytes, file);
  reader.read();
  const Positions positions = reader.positions();
  Mesh mesh{positions, facets(positions.rows() / 3)};
  TextLayout layout = std::move(reader).takeLayout();
  layout.normalOfCorner = facetOfCorner(mesh.faces);
  return {mesh, makeTextSource(std::move(bytes), std::move(layout), mesh)};
}

class BinaryStlSource final : public MeshSource {
 public:
  BinaryStlSource(std::string bytes, Mesh rest) : bytes_(std::move(bytes)), rest_(std::move(rest)) {}

  [[nodiscard]] std::string extension() const override { return ".stl"; }
  [[nodiscard]] std::vector<std::string> extras() const override;
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  std::string bytes_;
  Mesh rest_;
};

std::vector<std::string> BinaryStlSource::extras() const
{
  for (std::size_t at = kStlFacetsOffset; at < bytes_.size(); at += kStlFacetBytes)
    if (bytes_[at + kStlAttributesOffset] != 0 || bytes_[at + kStlAttributesOffset + 1] != 0)
      return {"facet normals", "facet attributes"};
  return {"facet normals"};
}

Serialized BinaryStlSource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.vertexCount());
  const std::vector<bool> moved = movedVertices(rest_.positions, positions);
  NormalUpdate update =
      updateNormals(rest_.faces, facetOfCorner(rest_.faces), rest_.faces.size(), rest_.positions, positions);
  noteRounding(positions, update.notes);
  std::string bytes = bytes_;
  for (Index f = 0; 3 * f < positions.rows(); ++f) {
    const std::size_t facet = kStlFacetsOffset + kStlFacetBytes * f;
    if (update.isNew[f]) bytes.replace(facet, kStlVectorBytes, stlBytes(update.normals.row(f)));
    for (Index k = 0; k < 3; ++k)
      if (moved[3 * f + k])
        bytes.replace(facet + kStlVectorBytes * (k + 1), kStlVectorBytes, stlBytes(positions.row(3 * f + k)));
  }
  return {std::move(bytes), std::move(update.notes), true};
}

[[noreturn]] void failAt(std::size_t offset, const std::string& file, const std::string& reason)
{
  throw InputError({file, 0, fmt::format("byte {}", offset)}, reason);
}

/// Facets that the header of a binary file counts; `bytes` has a whole header.
std::uint32_t binaryCount(std::string_view bytes)
{
  return fromBytes<std::uint32_t>(bytes.substr(kStlHeaderBytes, sizeof(std::uint32_t)), ByteOrder::kLittle);
}

std::size_t binarySize(std::size_t count)
{
  return kStlFacetsOffset + kStlFacetBytes * count;
}

bool isBinary(std::string_view bytes)
{
  return bytes.size() >= kStlFacetsOffset && bytes.size() == binarySize(binaryCount(bytes));
}

/// Whether the file is text by its first two lines: "solid", whatever name, then a facet or the end. A binary header
/// that begins with "solid" is followed by neither.
bool isText(std::string_view bytes)
{
  TextCursor cursor(bytes, {});
  if (!cursor.findToken() || !isWord(cursor.token(), "solid")) return false;
  cursor.skipLine();
  if (!cursor.findToken()) return bytes.find('\0') == std::string_view::npos;
  const std::string_view second = cursor.token();
  return isWord(second, "facet") || isWord(second, "endsolid") || bytes.find('\0') == std::string_view::npos;
}

void checkBinarySize(std::string_view bytes, const std::string& file)
{
  if (bytes.size() < kStlFacetsOffset)
    failAt(bytes.size(), file, "the file ends inside the header: it is not STL, or truncated; export it again");
  const std::size_t count = binaryCount(bytes);
  if (bytes.size() < binarySize(count))
    failAt(
        bytes.size(), file,
        fmt::format("the file ends here, but the {} facets that its header counts need {} bytes: it is truncated, or "
                    "not STL; export it again",
                    count, binarySize(count)));
  if (bytes.size() > binarySize(count))
    failAt(binarySize(count), file,
           fmt::format("{} bytes follow the last of the {} facets that the header counts: the count is wrong, or the "
                       "rest must be removed",
                       bytes.size() - binarySize(count), count));
  if (count == 0) failAt(kStlHeaderBytes, file, "the mesh has no faces: the header counts 0 facets; export it again");
}

MeshDocument readBinaryStl(std::string bytes, const std::string& file)
{
  checkBinarySize(bytes, file);
  const auto count = static_cast<Index>(binaryCount(bytes));
  Positions positions(3 * count, 3);
  for (Index v = 0; v < positions.rows(); ++v)
    positions.row(v) = stlVector(bytes, kStlFacetsOffset + kStlFacetBytes * (v / 3) + kStlVectorBytes * (v % 3 + 1));
  const Mesh mesh{std::move(positions), facets(count)};
  return {mesh, std::make_shared<const BinaryStlSource>(std::move(bytes), mesh)};
}

std::string stlFacet(const Positions& positions, const std::array<Index, 3>& corners)
{
  std::string bytes = stlBytes(unitOrZero(areaVector(positions, corners)));
  for (const Index corner : corners) bytes += stlBytes(positions.row(corner));
  return bytes + std::string(kStlFacetBytes - kStlAttributesOffset, '\0');
}

}  // namespace

MeshDocument readStl(std::string bytes, const std::string& file)
{
  if (!isBinary(bytes) && isText(bytes)) return readTextStl(std::move(bytes), file);
  return readBinaryStl(std::move(bytes), file);
}

Serialized writeStl(const Positions& positions, const Polygons& faces)
{
  Serialized result;
  noteRounding(positions, result.notes);
  result.isSinglePrecision = true;
  result.bytes = "Holdfast";
  result.bytes.resize(kStlHeaderBytes, ' ');
  result.bytes +=
      toBytes(narrowed<std::uint32_t>(faces.cornerCount() - 2 * faces.size(), ".stl"), ByteOrder::kLittle).view();
  Index split = 0;
  for (Index f = 0; f < faces.size(); ++f) {
    const auto polygon = faces[f];
    if (polygon.size() > 3) ++split;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      result.bytes += stlFacet(positions, {polygon[0], polygon[k], polygon[k + 1]});
  }
  if (split > 0) result.notes.push_back(counted(split, "polygon") + " split into triangles");
  return result;
}

}  // namespace holdfast
