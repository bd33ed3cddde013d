#include <algorithm>
#include <limits>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/words/error.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>

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

/// Names may be glued to these words.
bool beginsWith(std::string_view token, std::string_view lower)
{
  return isWord(token.substr(0, lower.size()), lower);
}

constexpr std::array<std::string_view, 6> kWordsOfFacets{"facet", "outer", "vertex", "endloop", "endfacet", "end"};

class TextStlReader {
 public:
  TextStlReader(std::string bytes, const std::string& file)
      : bytes_(std::move(bytes)), cursor_(withoutPadding(bytes_), file)
  {
  }

  MeshDocument read()
  {
    while (cursor_.findToken()) {
      const std::string_view token = cursor_.token();
      if (beginsWith(token, "solid")) {
        cursor_.skipLine();
        readSolid();
      } else if (!isEndOf("solid", token)) {
        if (isOfFacets(token)) failFor(token, "'solid' must");
        keepLine(token);
      } else {
        cursor_.skipLine();
      }
    }
    if (others_ > 0)
      layout_.remarks.push_back(
          fmt::format("{} that STL does not have (the first begins with {}, line {}); the file "
                      "keeps them, and nothing of them is read",
                      counted(others_, "line"), firstOther_, firstOtherLine_));
    if (coordinates_.empty()) cursor_.fail("the mesh has no faces: no facet stands in this file; export it again");
    const auto vertexCount = static_cast<Index>(coordinates_.size() / 3);
    return makeFacets(std::move(bytes_), std::move(layout_),
                      Eigen::Map<const Positions>(coordinates_.data(), vertexCount, 3));
  }

 private:
  void readSolid()
  {
    for (std::string_view token = word(); !isEndOf("solid", token); token = word()) {
      if (isWord(token, "facet"))
        readFacet();
      else if (isOfFacets(token))
        cursor_.fail("{} stands where 'facet' or 'endsolid' must: correct it", quotedToken(token));
      else if (beginsWith(token, "solid"))
        cursor_.skipLine();  // some programs say it twice
      else
        keepLine(token);
    }
    cursor_.skipLine();
  }

  void readFacet()
  {
    expect("normal");
    layout_.numbers.push_back({cursor_.offset(), normalNumber(facetCount_++)});
    for (int k = 0; k < 3; ++k) cursor_.expectNumber(word(), "a component of the normal");
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) readVertex();
    expectEndOf("loop");
    expectEndOf("facet");
  }

  /// Colours and the like.
  void keepLine(std::string_view token)
  {
    if (others_++ == 0) {
      firstOther_ = quotedToken(token);
      firstOtherLine_ = cursor_.line();
    }
    cursor_.skipLine();
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

  [[nodiscard]] static bool isOfFacets(std::string_view token)
  {
    return std::ranges::any_of(kWordsOfFacets, [&](std::string_view lower) { return isWord(token, lower); });
  }

  /// Whether `token` and what follows it say "endsolid", or "end solid", of which it then reads the second word.
  bool isEndOf(std::string_view lower, std::string_view token)
  {
    if (lower == "solid" ? beginsWith(token, "endsolid") : isWord(token, fmt::format("end{}", lower))) return true;
    if (!isWord(token, "end")) return false;
    TextCursor ahead = cursor_;
    if (!beginsWith(ahead.token(), lower)) return false;
    cursor_ = ahead;
    return true;
  }

  void expectEndOf(std::string_view lower)
  {
    const std::string_view token = word();
    if (!isEndOf(lower, token)) failFor(token, fmt::format("'end{}' must", lower));
  }

  void expect(std::string_view lower)
  {
    const std::string_view token = word();
    if (!isWord(token, lower)) failFor(token, fmt::format("'{}' must", lower));
  }

  [[noreturn]] void failFor(std::string_view token, const std::string& wanted) const
  {
    cursor_.fail("{} stands where {}: correct it (a facet has a normal and exactly three vertices)", quotedToken(token),
                 wanted);
  }

  std::string bytes_;
  TextCursor cursor_;
  std::vector<double> coordinates_;
  FileLayout layout_{".stl", {}, {"facet normals", "names of solids"}};
  Index facetCount_ = 0;
  Index others_ = 0;  // lines that are no part of facets
  std::string firstOther_;
  Index firstOtherLine_ = 0;
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

/// A count that a program leaves behind which never comes back to fill it in.
bool isUnfilled(std::uint32_t count)
{
  return count == 0 || count == std::numeric_limits<std::uint32_t>::max();
}

/// Whether the file is text by its first two lines: "solid", whatever name, then a facet or the end. A binary header
/// that begins with "solid" is followed by neither.
bool isText(std::string_view bytes)
{
  TextCursor cursor(bytes, {});
  if (!cursor.findToken() || !beginsWith(cursor.token(), "solid")) return false;
  cursor.skipLine();
  const std::string_view second = cursor.findToken() ? cursor.token() : std::string_view();
  return isWord(second, "facet") || isWord(second, "endsolid") || bytes.find('\0') == std::string_view::npos;
}

/// Where the facets of a binary file begin, and what is odd about their count.
struct FacetPlaces {
  std::vector<std::size_t> offsets;
  std::string remark;
};

std::vector<std::size_t> evenly(std::size_t count)
{
  std::vector<std::size_t> offsets(count);
  for (std::size_t f = 0; f < count; ++f) offsets[f] = kFacetsOffset + kFacetBytes * f;
  return offsets;
}

/// Those of facets that are followed by as many bytes as their attributes say; empty where the file does not end with
/// the last of them.
std::vector<std::size_t> withPayloads(std::string_view bytes)
{
  std::vector<std::size_t> offsets;
  std::size_t next = kFacetsOffset;
  for (std::uint32_t left = binaryCount(bytes); left > 0; --left) {
    if (next + kFacetBytes > bytes.size()) return {};
    offsets.push_back(next);
    next += kFacetBytes + fromBytes<std::uint16_t>(bytes.substr(next + kAttributesOffset, sizeof(std::uint16_t)),
                                                   std::endian::little);
  }
  return next == bytes.size() ? offsets : std::vector<std::size_t>();
}

// A line end behind the last facet.
constexpr std::size_t kMostLineEnd = 2;

/// Of a file whose size is not what its count calls for. Throws where neither can be right.
FacetPlaces oddPlaces(std::string_view bytes, const std::string& file)
{
  const std::uint32_t count = binaryCount(bytes);
  const std::size_t whole = (bytes.size() - kFacetsOffset) / kFacetBytes;
  const std::size_t rest = (bytes.size() - kFacetsOffset) % kFacetBytes;
  const bool isCountWrong = isUnfilled(count) ? rest <= kMostLineEnd : rest == 0 && whole > count;
  if (std::vector<std::size_t> offsets = withPayloads(bytes); !offsets.empty()) return {std::move(offsets), {}};
  if (isCountWrong && whole > 0)
    return {evenly(whole), fmt::format("the header counts {} facets, and the file has as many bytes as {} take, which "
                                       "were read: check that none is missing or too much",
                                       count, whole)};
  if (isUnfilled(count) || bytes.size() < binarySize(count))
    failAt(bytes.size(), file,
           fmt::format("the file ends here, but the {} facets that its header counts need {} bytes: it is truncated, "
                       "or not STL; export it again",
                       count, binarySize(count)));
  return {evenly(count), fmt::format("{} behind the last of the {} facets that the header counts; the file keeps that, "
                                     "and nothing of it is read",
                                     counted(static_cast<Index>(bytes.size() - binarySize(count)), "byte"), count)};
}

FacetPlaces placesOfFacets(std::string_view bytes, const std::string& file)
{
  if (bytes.size() < kFacetsOffset)
    failAt(bytes.size(), file, "the file ends inside the header: it is not STL, or truncated; export it again");
  if (bytes.size() == kFacetsOffset && binaryCount(bytes) == 0)
    failAt(kHeaderBytes, file, "the mesh has no faces: the header counts 0 facets; export it again");
  if (isBinary(bytes)) return {evenly(binaryCount(bytes)), {}};
  return oddPlaces(bytes, file);
}

MeshDocument readBinaryStl(std::string bytes, const std::string& file)
{
  const auto [offsets, remark] = placesOfFacets(bytes, file);
  const auto count = static_cast<Index>(offsets.size());
  FileLayout layout{".stl", {}, {"facet normals"}, std::endian::little};
  layout.coordinateTypes.fill(NumberType::Float);
  layout.normalTypes.fill(NumberType::Float);
  layout.stored = storedInStl;
  if (!remark.empty()) layout.remarks.push_back(remark);
  Positions positions(3 * count, 3);
  bool hasAttributes = false;
  for (Index f = 0; f < count; ++f) {
    const std::size_t facet = offsets[f];
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

void checkStlHead(std::string_view head, std::uintmax_t size, const std::string& file)
{
  if (head.size() < kFacetsOffset || binaryCount(head) != 0 || size == head.size()) return;
  if (head.find_first_not_of('\0', kFacetsOffset) == std::string_view::npos)
    failAt(kHeaderBytes, file,
           "zero bytes begin here, so there is no facet: the file is another one, or a download or a disk that was not "
           "written to the end; get it again");
}

MeshDocument readStl(std::string bytes, const std::string& file)
{
  if (isBinary(bytes)) return readBinaryStl(std::move(bytes), file);
  refuseWideText(bytes, file);
  if (isText(bytes)) return TextStlReader(std::move(bytes), file).read();
  return readBinaryStl(std::move(bytes), file);
}

}  // namespace holdfast
