#include "holdfast/io/formats/stl_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/io/formats/stl_format.h>
#include <holdfast/io/formats/stl_source.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {
namespace {

/// `count` facets, of which facet f has the vertices 3f, 3f + 1 and 3f + 2.
Polygons facets(Index count)
{
  Polygons faces;
  faces.reserve(count, 3 * count);
  for (Index f = 0; f < count; ++f) faces.add({3 * f, 3 * f + 1, 3 * f + 2});
  return faces;
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
    return Eigen::Map<const Positions>(coordinates_.data(), static_cast<Index>(vertexOffsets_.size()), 3);
  }
  [[nodiscard]] std::vector<std::size_t> takeVertexOffsets() && { return std::move(vertexOffsets_); }
  [[nodiscard]] std::vector<std::size_t> takeNormalOffsets() && { return std::move(normalOffsets_); }

 private:
  void readSolid();
  void readFacet();
  void readVertex();
  std::string_view word();
  void expect(std::string_view lower);
  double number(std::string_view what);

  TextCursor cursor_;
  std::vector<double> coordinates_;
  std::vector<std::size_t> vertexOffsets_;
  std::vector<std::size_t> normalOffsets_;
};

void TextStlReader::read()
{
  while (cursor_.findToken()) {
    expect("solid");
    cursor_.skipLine();
    readSolid();
  }
  if (vertexOffsets_.empty()) cursor_.fail("the mesh has no faces: no facet stands in this file; export it again");
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
  normalOffsets_.push_back(cursor_.offset());
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
  vertexOffsets_.push_back(cursor_.offset());
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
  std::vector<std::size_t> vertexOffsets = std::move(reader).takeVertexOffsets();
  std::vector<std::size_t> normalOffsets = std::move(reader).takeNormalOffsets();
  return {{positions, facets(positions.rows() / 3)},
          makeTextStlSource(std::move(bytes), std::move(vertexOffsets), std::move(normalOffsets), positions)};
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
  return {{positions, facets(count)}, makeBinaryStlSource(std::move(bytes), positions)};
}

}  // namespace

MeshDocument readStl(std::string bytes, const std::string& file)
{
  if (!isBinary(bytes) && isText(bytes)) return readTextStl(std::move(bytes), file);
  return readBinaryStl(std::move(bytes), file);
}

}  // namespace holdfast
