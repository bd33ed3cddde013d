#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

// Binary STL: a header, the count of facets (32 bits unsigned), the facets; numbers are little-endian.
constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetsOffset = 84;
constexpr std::size_t kFacetBytes = 50;   // normal, three corners, 16 bits of attributes
constexpr std::size_t kVectorBytes = 12;  // three floats
constexpr std::size_t kAttributesOffset = 4 * kVectorBytes;

/// Facet f has the vertices 3f, 3f + 1 and 3f + 2, and a normal of its own.
MeshDocument makeFacets(std::string bytes, FileLayout layout, Positions positions)
{
  const Index count = positions.rows() / 3;
  Polygons faces;
  faces.reserve(count, 3 * count);
  for (Index f = 0; f < count; ++f) {
    faces.add({3 * f, 3 * f + 1, 3 * f + 2});
    layout.normalOfCorner.insert(layout.normalOfCorner.end(), 3, static_cast<int>(f));
  }
  layout.normalCount = count;
  return makeDocument(std::move(bytes), std::move(layout), {std::move(positions), std::move(faces)});
}

bool isWord(std::string_view token, std::string_view lower)
{
  return std::ranges::equal(token, lower, {}, [](char c) { return lowerCase(c); });
}

class TextStlReader {
 public:
  TextStlReader(std::string bytes, const std::string& file) : bytes_(std::move(bytes)), cursor_(bytes_, file) {}

  MeshDocument read()
  {
    while (cursor_.findToken()) {
      expect("solid");
      cursor_.skipLine();
      readSolid();
    }
    if (coordinates_.empty()) cursor_.fail("the mesh has no faces: no facet stands in this file; export it again");
    const auto vertexCount = static_cast<Index>(coordinates_.size() / 3);
    return makeFacets(std::move(bytes_), std::move(layout_),
                      Eigen::Map<const Positions>(coordinates_.data(), vertexCount, 3));
  }

 private:
  void readSolid()
  {
    for (std::string_view token = word(); !isWord(token, "endsolid"); token = word()) {
      if (!isWord(token, "facet"))
        cursor_.fail("{} stands where 'facet' or 'endsolid' must: correct it", quotedToken(token));
      readFacet();
    }
    cursor_.skipLine();
  }

  void readFacet()
  {
    expect("normal");
    layout_.numbers.push_back({cursor_.offset(), normalNumber(facetCount_++)});
    for (int k = 0; k < 3; ++k) static_cast<void>(cursor_.numberOf(word(), "a component of the normal"));
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) readVertex();
    expect("endloop");
    expect("endfacet");
  }

  void readVertex()
  {
    expect("vertex");
    layout_.numbers.push_back({cursor_.offset(), static_cast<Index>(coordinates_.size())});
    for (const std::string_view name : kCoordinateNames) coordinates_.push_back(cursor_.numberOf(word(), name));
  }

  std::string_view word()
  {
    if (!cursor_.findToken())
      cursor_.fail("the file ends inside a solid, without 'endsolid': it is truncated; export it again");
    return cursor_.token();
  }

  void expect(std::string_view lower)
  {
    const std::string_view token = word();
    if (!isWord(token, lower))
      cursor_.fail("{} stands where '{}' must: correct it (a facet has a normal and exactly three vertices)",
                   quotedToken(token), lower);
  }

  std::string bytes_;
  TextCursor cursor_;
  std::vector<double> coordinates_;
  FileLayout layout_{".stl", {}, {"facet normals", "names of solids"}};
  Index facetCount_ = 0;
};

[[noreturn]] void failAt(std::size_t offset, const std::string& file, const std::string& reason)
{
  throw InputError({file, 0, fmt::format("byte {}", offset)}, reason);
}

std::uint32_t binaryCount(std::string_view bytes)
{
  return fromBytes<std::uint32_t>(bytes.substr(kHeaderBytes, sizeof(std::uint32_t)), std::endian::little);
}

std::size_t binarySize(std::size_t count)
{
  return kFacetsOffset + kFacetBytes * count;
}

bool isBinary(std::string_view bytes)
{
  return bytes.size() >= kFacetsOffset && bytes.size() == binarySize(binaryCount(bytes));
}

/// Whether the file is text by its first two lines: "solid", whatever name, then a facet or the end. A binary header
/// that begins with "solid" is followed by neither.
bool isText(std::string_view bytes)
{
  TextCursor cursor(bytes, {});
  if (!cursor.findToken() || !isWord(cursor.token(), "solid")) return false;
  cursor.skipLine();
  const std::string_view second = cursor.findToken() ? cursor.token() : std::string_view();
  return isWord(second, "facet") || isWord(second, "endsolid") || bytes.find('\0') == std::string_view::npos;
}

void checkBinarySize(std::string_view bytes, const std::string& file)
{
  if (bytes.size() < kFacetsOffset)
    failAt(bytes.size(), file, "the file ends inside the header: it is not STL, or truncated; export it again");
  const std::size_t count = binaryCount(bytes);
  if (bytes.size() < binarySize(count))
    failAt(bytes.size(), file,
           fmt::format("the file ends here, but the {} facets that its header counts need {} bytes: it is truncated, "
                       "or not STL; export it again",
                       count, binarySize(count)));
  if (bytes.size() > binarySize(count))
    failAt(binarySize(count), file,
           fmt::format("{} bytes follow the last of the {} facets that the header counts: the count is wrong, or the "
                       "rest must be removed",
                       bytes.size() - binarySize(count), count));
  if (count == 0) failAt(kHeaderBytes, file, "the mesh has no faces: the header counts 0 facets; export it again");
}

MeshDocument readBinaryStl(std::string bytes, const std::string& file)
{
  checkBinarySize(bytes, file);
  const auto count = static_cast<Index>(binaryCount(bytes));
  FileLayout layout{".stl", {}, {"facet normals"}, std::endian::little};
  layout.coordinateTypes.fill(NumberType::kFloat);
  layout.normalTypes.fill(NumberType::kFloat);
  layout.noteRounding = noteStlRounding;
  Positions positions(3 * count, 3);
  bool hasAttributes = false;
  for (Index f = 0; f < count; ++f) {
    const std::size_t facet = kFacetsOffset + kFacetBytes * f;
    layout.numbers.push_back({facet, normalNumber(f)});
    for (Index k = 0; k < 9; ++k) {
      const std::size_t at = facet + kVectorBytes + sizeof(float) * k;
      if (k % 3 == 0) layout.numbers.push_back({at, 9 * f + k});
      const auto number = fromBytes<float>(std::string_view(bytes).substr(at, sizeof(float)), std::endian::little);
      positions.data()[9 * f + k] = static_cast<double>(number);
    }
    const std::size_t attributes = facet + kAttributesOffset;
    hasAttributes = hasAttributes || bytes[attributes] != 0 || bytes[attributes + 1] != 0;
  }
  if (hasAttributes) layout.extras.emplace_back("facet attributes");
  return makeFacets(std::move(bytes), std::move(layout), std::move(positions));
}

}  // namespace

MeshDocument readStl(std::string bytes, const std::string& file)
{
  if (!isBinary(bytes) && isText(bytes)) return TextStlReader(std::move(bytes), file).read();
  return readBinaryStl(std::move(bytes), file);
}

}  // namespace holdfast
