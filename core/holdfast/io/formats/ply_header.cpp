#include "holdfast/io/formats/ply_header.h"

namespace holdfast {
namespace {

/// In the order of `NumberType`.
constexpr std::array<std::array<std::string_view, 2>, 8> kTypeWords{{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& file) : cursor_(bytes, file) {}

  PlyHeader parse()
  {
    requirePlyMagic(cursor_);
    static_cast<void>(cursor_.token());
    cursor_.expectLineEnd("'ply' stands on a line of its own");
    while (parseLine()) {
    }
    if (!hasFormat_) cursor_.fail("the header has no format line: write 'format ascii 1.0' where the body is text");
    cursor_.expectLineEnd("'end_header' stands on a line of its own");
    cursor_.skipLine();
    header_.bodyOffset = cursor_.offset();
    header_.bodyLine = cursor_.line();
    return std::move(header_);
  }

 private:
  /// False at the end of the header.
  bool parseLine()
  {
    if (!cursor_.findToken()) cursor_.fail("the header has no end_header: the file is truncated; export it again");
    const std::string_view keyword = cursor_.token();
    if (keyword == "format")
      parseFormat();
    else if (keyword == "element")
      parseElement();
    else if (keyword == "property")
      parseProperty();
    else if (keyword == "comment" || keyword == "obj_info")
      cursor_.skipLine();
    else if (keyword != "end_header")
      cursor_.fail("{} is not a word of a PLY header: correct it, or make the line a comment", quotedToken(keyword));
    return keyword != "end_header";
  }

  void parseFormat()
  {
    const std::string_view word = cursor_.token();
    if (word == "binary_little_endian")
      header_.byteOrder = std::endian::little;
    else if (word == "binary_big_endian")
      header_.byteOrder = std::endian::big;
    else if (word != "ascii")
      cursor_.fail("{} is not a PLY format: ascii, binary_little_endian or binary_big_endian", quotedToken(word));
    const std::string_view version = cursor_.token();
    if (version != "1.0") cursor_.fail("version {} of PLY is not known: only 1.0 is", quotedToken(version));
    if (std::exchange(hasFormat_, true)) cursor_.fail("the header names a format twice: keep the one that holds");
    cursor_.expectLineEnd("the line has a format and a version");
  }

  void parseElement()
  {
    PlyElement element;
    element.name = name("the name of the element");
    element.line = cursor_.line();
    element.count = cursor_.integer("the count of the element");
    if (element.count < 0) cursor_.fail("the count {} is negative: correct it", element.count);
    if (header_.find(element.name) != nullptr)
      cursor_.fail("element {} is there twice: rename one of them", quotedToken(element.name));
    cursor_.expectLineEnd("an element has a name and a count");
    header_.elements.push_back(std::move(element));
  }

  void parseProperty()
  {
    if (header_.elements.empty()) cursor_.fail("a property stands before the first element: put the element above it");
    PlyProperty property;
    property.typeOffset = cursor_.offset();
    std::string_view type = cursor_.token();
    if (type == "list") {
      property.countType = typeOf(cursor_.token());
      if (!isInteger(*property.countType))
        cursor_.fail("the count of a list must have a whole type: uchar or int, say");
      type = cursor_.token();
    }
    property.type = typeOf(type);
    property.name = name("the name of the property");
    PlyElement& element = header_.elements.back();
    if (element.find(property.name) >= 0)
      cursor_.fail("property {} is there twice: rename one of them", quotedToken(property.name));
    cursor_.expectLineEnd("a property has a type and a name");
    element.properties.push_back(std::move(property));
  }

  [[nodiscard]] NumberType typeOf(std::string_view word) const
  {
    for (std::size_t type = 0; type < kTypeWords.size(); ++type)
      if (word == kTypeWords[type][0] || word == kTypeWords[type][1]) return static_cast<NumberType>(type);
    cursor_.fail("{} is not a PLY type: char, uchar, short, ushort, int, uint, float or double", quotedToken(word));
  }

  std::string name(std::string_view what)
  {
    const std::string_view word = cursor_.token();
    if (word.empty()) cursor_.fail("{} is missing: complete the line", what);
    return std::string(word);
  }

  TextCursor cursor_;
  PlyHeader header_;
  bool hasFormat_ = false;
};

}  // namespace

Index PlyElement::find(std::string_view wanted) const
{
  const auto found = std::ranges::find(properties, wanted, &PlyProperty::name);
  return found == properties.end() ? -1 : found - properties.begin();
}

const PlyElement* PlyHeader::find(std::string_view wanted) const
{
  const auto found = std::ranges::find(elements, wanted, &PlyElement::name);
  return found == elements.end() ? nullptr : &*found;
}

const PlyElement* PlyHeader::surface() const
{
  const PlyElement* const face = find("face");
  const PlyElement* const strips = find("tristrips");
  return strips != nullptr && (face == nullptr || face->count == 0) ? strips : face;
}

void requirePlyMagic(TextCursor cursor)
{
  const std::string_view magic = cursor.token();
  if (magic != "ply") cursor.fail("the file begins with {}, not with 'ply': is it another format?", quotedToken(magic));
}

PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file)
{
  return HeaderParser(bytes, file).parse();
}

}  // namespace holdfast
