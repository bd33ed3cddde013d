#include "holdfast/io/formats/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <holdfast/io/text/text_cursor.h>

namespace holdfast {
namespace {

struct TypeWord {
  std::string_view word;
  PlyType type;
};

constexpr std::array kTypeWords{
    TypeWord{"char", PlyType::kInt8},      TypeWord{"int8", PlyType::kInt8},     TypeWord{"uchar", PlyType::kUint8},
    TypeWord{"uint8", PlyType::kUint8},    TypeWord{"short", PlyType::kInt16},   TypeWord{"int16", PlyType::kInt16},
    TypeWord{"ushort", PlyType::kUint16},  TypeWord{"uint16", PlyType::kUint16}, TypeWord{"int", PlyType::kInt32},
    TypeWord{"int32", PlyType::kInt32},    TypeWord{"uint", PlyType::kUint32},   TypeWord{"uint32", PlyType::kUint32},
    TypeWord{"float", PlyType::kFloat},    TypeWord{"float32", PlyType::kFloat}, TypeWord{"double", PlyType::kDouble},
    TypeWord{"float64", PlyType::kDouble},
};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& file) : cursor_(bytes, file) {}

  PlyHeader parse();

 private:
  void parseFormat();
  void parseElement();
  void parseProperty();
  PlyType typeOf(std::string_view word) const;
  std::string name(std::string_view what);

  TextCursor cursor_;
  PlyHeader header_;
  bool hasFormat_ = false;
};

PlyHeader HeaderParser::parse()
{
  const std::string_view magic = cursor_.token();
  if (magic != "ply")
    cursor_.fail(fmt::format("the file begins with {}, not with 'ply': is it another format?", quotedToken(magic)));
  cursor_.expectLineEnd("'ply' stands on a line of its own");
  for (;;) {
    if (!cursor_.findToken()) cursor_.fail("the header has no end_header: the file is truncated; export it again");
    const std::string_view keyword = cursor_.token();
    if (keyword == "end_header") break;
    if (keyword == "format")
      parseFormat();
    else if (keyword == "element")
      parseElement();
    else if (keyword == "property")
      parseProperty();
    else if (keyword == "comment" || keyword == "obj_info")
      cursor_.skipLine();
    else
      cursor_.fail(fmt::format("{} is not a word of a PLY header: correct it, or make the line a comment",
                               quotedToken(keyword)));
  }
  if (!hasFormat_) cursor_.fail("the header has no format line: write 'format ascii 1.0' where the body is text");
  cursor_.expectLineEnd("'end_header' stands on a line of its own");
  cursor_.skipLine();
  header_.bodyOffset = cursor_.offset();
  header_.bodyLine = cursor_.line();
  return std::move(header_);
}

void HeaderParser::parseFormat()
{
  const std::string_view word = cursor_.token();
  if (word == "ascii")
    header_.encoding = PlyEncoding::kText;
  else if (word == "binary_little_endian")
    header_.encoding = PlyEncoding::kLittleEndian;
  else if (word == "binary_big_endian")
    header_.encoding = PlyEncoding::kBigEndian;
  else
    cursor_.fail(
        fmt::format("{} is not a PLY format: ascii, binary_little_endian or binary_big_endian", quotedToken(word)));
  const std::string_view version = cursor_.token();
  if (version != "1.0") cursor_.fail(fmt::format("version {} of PLY is not known: only 1.0 is", quotedToken(version)));
  if (std::exchange(hasFormat_, true)) cursor_.fail("the header names a format twice: keep the one that holds");
  cursor_.expectLineEnd("the line has a format and a version");
}

void HeaderParser::parseElement()
{
  PlyElement element;
  element.name = name("the name of the element");
  element.line = cursor_.line();
  element.count = cursor_.integer("the count of the element");
  if (element.count < 0) cursor_.fail(fmt::format("the count {} is negative: correct it", element.count));
  if (header_.find(element.name) != nullptr)
    cursor_.fail(fmt::format("element {} is there twice: rename one of them", quotedToken(element.name)));
  cursor_.expectLineEnd("an element has a name and a count");
  header_.elements.push_back(std::move(element));
}

void HeaderParser::parseProperty()
{
  if (header_.elements.empty()) cursor_.fail("a property stands before the first element: put the element above it");
  PlyProperty property;
  property.typeWord = cursor_.token();
  if (property.typeWord == "list") {
    property.countType = typeOf(cursor_.token());
    if (!isInteger(*property.countType)) cursor_.fail("the count of a list must have a whole type: uchar or int, say");
    property.typeWord = cursor_.token();
  }
  property.type = typeOf(property.typeWord);
  property.name = name("the name of the property");
  PlyElement& element = header_.elements.back();
  if (element.find(property.name) >= 0)
    cursor_.fail(fmt::format("property {} is there twice: rename one of them", quotedToken(property.name)));
  cursor_.expectLineEnd("a property has a type and a name");
  element.properties.push_back(std::move(property));
}

PlyType HeaderParser::typeOf(std::string_view word) const
{
  const auto entry =
      std::find_if(kTypeWords.begin(), kTypeWords.end(), [&](const TypeWord& known) { return known.word == word; });
  if (entry == kTypeWords.end())
    cursor_.fail(
        fmt::format("{} is not a PLY type: char, uchar, short, ushort, int, uint, float or double", quotedToken(word)));
  return entry->type;
}

std::string HeaderParser::name(std::string_view what)
{
  const std::string_view word = cursor_.token();
  if (word.empty()) cursor_.fail(fmt::format("{} is missing: complete the line", what));
  return std::string(word);
}

}  // namespace

std::size_t sizeOf(PlyType type)
{
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kDouble:
      return 8;
    default:
      return 4;
  }
}

bool isInteger(PlyType type)
{
  return type != PlyType::kFloat && type != PlyType::kDouble;
}

Index PlyElement::find(std::string_view wanted) const
{
  const auto found =
      std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == wanted; });
  return found == properties.end() ? -1 : found - properties.begin();
}

const PlyElement* PlyHeader::find(std::string_view wanted) const
{
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const PlyElement& e) { return e.name == wanted; });
  return found == elements.end() ? nullptr : &*found;
}

const PlyElement* PlyHeader::surface() const
{
  const PlyElement* const face = find("face");
  const PlyElement* const strips = find("tristrips");
  return strips != nullptr && (face == nullptr || face->count == 0) ? strips : face;
}

PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file)
{
  return HeaderParser(bytes, file).parse();
}

}  // namespace holdfast
