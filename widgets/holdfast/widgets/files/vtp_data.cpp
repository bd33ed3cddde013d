#include <algorithm>
#include <cstring>
#include <memory>
#include <sstream>
#include <type_traits>

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>
#include <vtkXMLParser.h>

#include <holdfast/base/error.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/files/vtp_reader.h>

namespace holdfast {
namespace {

/// VTK's parser, by expat. It throws nothing, for what it would throw would pass through functions of C.
class XmlTreeBuilder final : public vtkXMLParser {
 public:
  static XmlTreeBuilder* New();

  [[nodiscard]] bool isTooDeep() const { return isTooDeep_; }
  [[nodiscard]] XmlElement takeRoot() { return std::move(top_.children.at(0)); }

 private:
  XmlTreeBuilder() { open_.push_back(&top_); }

  void StartElement(const char* name, const char** attributes) override
  {
    constexpr std::size_t kMostLevels = 32;
    isTooDeep_ = isTooDeep_ || open_.size() > kMostLevels;
    if (isTooDeep_) return;
    XmlElement& element = open_.back()->children.emplace_back();
    element.name = name;
    element.place = static_cast<std::size_t>(GetXMLByteIndex());
    for (; *attributes != nullptr; attributes += 2) element.attributes.emplace(attributes[0], attributes[1]);
    // An element has no new siblings while it is open, so that it stays where it is.
    open_.push_back(&element);
  }

  void EndElement(const char* /*name*/) override
  {
    if (!isTooDeep_) open_.pop_back();
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    open_.back()->text.append(data, static_cast<std::size_t>(length));
  }

  int ParsingComplete() override { return isTooDeep_ ? 1 : vtkXMLParser::ParsingComplete(); }

  XmlElement top_;  // its child is the root
  std::vector<XmlElement*> open_;
  bool isTooDeep_ = false;
};

vtkStandardNewMacro(XmlTreeBuilder);

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// No compressor of VTK's makes more bytes of one than this (LZMA, on zeros).
constexpr std::uint64_t kBestCompression = 8192;

[[noreturn]] void failCutShort()
{
  throw VtpFault("its data are cut short");
}

/// Bytes of a file, plain or as base64 text.
class EncodedBytes {
 public:
  EncodedBytes(std::string_view text, bool isBase64) : text_(text), isBase64_(isBase64) {}

  [[nodiscard]] std::string first(std::uint64_t count) const
  {
    requireHeld(count);
    if (encodedSize(count) > text_.size()) failCutShort();
    if (!isBase64_) return std::string(text_.substr(0, count));
    std::string decoded((count + 2) / 3 * 3, '\0');
    const std::size_t got = vtkBase64Utilities::DecodeSafely(unsignedBytes(text_), encodedSize(count),
                                                             unsignedBytes(decoded), decoded.size());
    if (got < count) throw VtpFault("its data are no base64 text");
    decoded.resize(count);
    return decoded;
  }

  /// All after the first `count` bytes, which were encoded on their own.
  [[nodiscard]] EncodedBytes after(std::uint64_t count) const { return {text_.substr(encodedSize(count)), isBase64_}; }

  /// Throws where `count` things of a byte or more cannot be here. Sums of what passes do not overflow.
  void requireHeld(std::uint64_t count) const
  {
    if (count > text_.size()) failCutShort();
  }

  static const unsigned char* unsignedBytes(std::string_view text)
  {
    return reinterpret_cast<const unsigned char*>(text.data());
  }
  static unsigned char* unsignedBytes(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }

 private:
  [[nodiscard]] std::size_t encodedSize(std::uint64_t count) const { return isBase64_ ? (count + 2) / 3 * 4 : count; }

  std::string_view text_;
  bool isBase64_;
};

std::uint64_t wordSize(const VtpEncoding& encoding)
{
  return encoding.hasLongHeaders ? 8 : 4;
}

std::vector<std::uint64_t> words(const EncodedBytes& block, std::uint64_t count, const VtpEncoding& encoding)
{
  block.requireHeld(count);
  const std::uint64_t size = wordSize(encoding);
  const std::string bytes = block.first(count * size);
  std::vector<std::uint64_t> result;
  for (std::string_view left = bytes; !left.empty(); left.remove_prefix(size))
    result.push_back(size == 8 ? fromBytes<std::uint64_t>(left.substr(0, 8), encoding.order)
                               : fromBytes<std::uint32_t>(left.substr(0, 4), encoding.order));
  return result;
}

/// The size, then the data.
std::string plainData(const EncodedBytes& block, const VtpEncoding& encoding)
{
  const std::uint64_t size = words(block, 1, encoding)[0];
  block.requireHeld(size);
  return block.first(wordSize(encoding) + size).substr(wordSize(encoding));
}

std::string uncompressed(std::string_view stored, std::uint64_t size, vtkDataCompressor& compressor)
{
  if (size / kBestCompression > stored.size()) throw VtpFault("a compressed block of its data claims too large a size");
  // Not a text, which would be filled at once: what is only claimed takes no memory.
  const auto block = std::make_unique_for_overwrite<unsigned char[]>(size);
  if (compressor.Uncompress(EncodedBytes::unsignedBytes(stored), stored.size(), block.get(), size) != size)
    throw VtpFault("a compressed block of its data is damaged");
  return {block.get(), block.get() + size};
}

/// How many blocks, the size of a block and of the last one (0: the same) before compression, then the size of each
/// after it; then the blocks.
std::string compressedData(const EncodedBytes& block, const VtpEncoding& encoding)
{
  constexpr std::uint64_t kStart = 3;
  const std::uint64_t count = words(block, kStart, encoding)[0];
  block.requireHeld(count);
  const std::vector<std::uint64_t> header = words(block, kStart + count, encoding);
  std::uint64_t total = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    block.requireHeld(header[kStart + k]);
    total += header[kStart + k];
  }
  const std::string stored = block.after(header.size() * wordSize(encoding)).first(total);
  std::string result;
  std::string_view left = stored;
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t size = k + 1 == count && header[2] > 0 ? header[2] : header[1];
    result += uncompressed(left.substr(0, header[kStart + k]), size, *encoding.compressor);
    left.remove_prefix(header[kStart + k]);
  }
  return result;
}

std::string_view withoutLeadingBlanks(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
  return text;
}

/// The data of an array whose numbers are not text, in the byte order of the file.
std::string storedData(const XmlElement& element, std::string_view format, const VtpEncoding& encoding)
{
  EncodedBytes block(withoutLeadingBlanks(element.text), true);
  if (format == "appended") {
    const Index offset = wholeAttribute(element, "offset", -1);
    if (offset < 0 || offset >= static_cast<Index>(encoding.appended.size()))
      throw VtpFault("its data would begin where the file has none");
    block = EncodedBytes(encoding.appended.substr(offset), encoding.isAppendedBase64);
  } else if (withoutLeadingBlanks(element.text).empty()) {
    return {};  // some programs write nothing for nothing
  }
  return encoding.compressor == nullptr ? plainData(block, encoding) : compressedData(block, encoding);
}

template <class Number>
Number numberOf(std::string_view word)
{
  using Parsed = std::conditional_t<std::is_floating_point_v<Number>, double, Number>;
  const auto [value, fault] = parseNumber<Parsed>(word);
  if (fault != NumberFault::None) throw VtpFault(fmt::format("'{}' is no number that it can hold", word));
  return static_cast<Number>(value);
}

template <class Number>
std::string dataOfText(std::string_view text)
{
  std::string data;
  while (!(text = withoutLeadingBlanks(text)).empty()) {
    const std::string_view word = text.substr(0, text.find_first_of(kXmlBlanks));
    const auto number = numberOf<Number>(word);
    data.append(reinterpret_cast<const char*>(&number), sizeof(number));
    text.remove_prefix(word.size());
  }
  return data;
}

struct NumberType {
  std::string_view name;
  int vtkType;
  std::size_t size;
  std::string (*dataOfText)(std::string_view text);
};

template <class Number>
constexpr NumberType numberType(std::string_view name, int vtkType)
{
  return {name, vtkType, sizeof(Number), dataOfText<Number>};
}

constexpr std::array<NumberType, 11> kNumberTypes{
    numberType<std::int8_t>("Int8", VTK_TYPE_INT8),    numberType<std::uint8_t>("UInt8", VTK_TYPE_UINT8),
    numberType<std::int16_t>("Int16", VTK_TYPE_INT16), numberType<std::uint16_t>("UInt16", VTK_TYPE_UINT16),
    numberType<std::int32_t>("Int32", VTK_TYPE_INT32), numberType<std::uint32_t>("UInt32", VTK_TYPE_UINT32),
    numberType<std::int64_t>("Int64", VTK_TYPE_INT64), numberType<std::uint64_t>("UInt64", VTK_TYPE_UINT64),
    numberType<float>("Float32", VTK_TYPE_FLOAT32),    numberType<double>("Float64", VTK_TYPE_FLOAT64),
    numberType<std::int8_t>("String", VTK_STRING)};

const NumberType& typeOf(const XmlElement& element)
{
  const std::string_view name = element.attribute("type").value_or("");
  const auto* const found = std::ranges::find(kNumberTypes, name, &NumberType::name);
  if (found == kNumberTypes.end())
    throw VtpFault(fmt::format("its type is '{}' and must be Float64, Float32, Int64, String or the like", name));
  return *found;
}

std::string dataOf(const XmlElement& element, const NumberType& type, const VtpEncoding& encoding)
{
  const std::string_view format = element.attribute("format").value_or("ascii");
  if (format == "ascii") return type.dataOfText(element.text);
  if (format != "binary" && format != "appended")
    throw VtpFault(fmt::format("its format is '{}' and must be ascii, binary or appended", format));
  std::string data = storedData(element, format, encoding);
  if (data.size() % type.size != 0) throw VtpFault("its data are no whole number of numbers");
  const bool isNative = encoding.order == std::endian::native;
  if (!isNative) vtkByteSwap::SwapVoidRange(data.data(), data.size() / type.size, type.size);
  return data;
}

/// Texts end with a byte 0 each.
vtkSmartPointer<vtkAbstractArray> textsOf(std::string_view data)
{
  auto texts = vtkSmartPointer<vtkStringArray>::New();
  while (!data.empty()) {
    const std::size_t end = data.find('\0');
    if (end == std::string_view::npos) throw VtpFault("its last text has no end");
    texts->InsertNextValue(std::string(data.substr(0, end)));
    data.remove_prefix(end + 1);
  }
  return texts;
}

vtkSmartPointer<vtkAbstractArray> numbersOf(std::string_view data, const NumberType& type, bool areIds)
{
  vtkSmartPointer<vtkDataArray> numbers;
  if (areIds)
    numbers = vtkSmartPointer<vtkIdTypeArray>::New();
  else
    numbers.TakeReference(vtkDataArray::CreateDataArray(type.vtkType));
  numbers->SetNumberOfValues(static_cast<vtkIdType>(data.size() / type.size));
  if (!data.empty()) std::memcpy(numbers->GetVoidPointer(0), data.data(), data.size());
  return numbers;
}

}  // namespace

std::optional<std::string_view> XmlElement::attribute(std::string_view wanted) const
{
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? std::nullopt : std::optional<std::string_view>(found->second);
}

const XmlElement* XmlElement::child(std::string_view wanted) const
{
  const auto found = std::ranges::find(children, wanted, &XmlElement::name);
  return found == children.end() ? nullptr : &*found;
}

XmlElement parseXml(const std::string& text, const std::string& file)
{
  VtkErrorLog log;
  vtkNew<XmlTreeBuilder> builder;
  log.watch(*builder);
  std::istringstream stream(text);
  builder->SetStream(&stream);
  const bool isParsed = builder->Parse() != 0;
  if (builder->isTooDeep()) throw InputError({file, 0, ""}, "its elements are nested too deep; the file is damaged");
  if (!isParsed || !log.isEmpty()) throw InputError({file, 0, ""}, "this is no whole XML file: " + log.first());
  return builder->takeRoot();
}

Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent)
{
  const auto text = element.attribute(name);
  if (!text) return absent;
  const ParsedNumber<Index> number = parseNumber<Index>(*text);
  if (number.fault != NumberFault::None || number.value < 0)
    throw VtpFault(fmt::format("{} is '{}' and must be a whole number from 0", name, *text));
  return number.value;
}

vtkSmartPointer<vtkAbstractArray> readVtpArray(const XmlElement& element, const VtpEncoding& encoding)
{
  const NumberType& type = typeOf(element);
  const std::string data = dataOf(element, type, encoding);
  const bool areIds = type.vtkType == VTK_TYPE_INT64 && wholeAttribute(element, "IdType", 0) == 1;
  auto array = type.vtkType == VTK_STRING ? textsOf(data) : numbersOf(data, type, areIds);
  const Index values = array->GetNumberOfValues();
  const Index components = wholeAttribute(element, "NumberOfComponents", 1);
  if (components < 1 || components > std::max<Index>(1, values) || values % components != 0)
    throw VtpFault(fmt::format("its {} numbers are not whole tuples of {}", values, components));
  array->SetNumberOfComponents(static_cast<int>(components));
  if (const auto name = element.attribute("Name")) array->SetName(std::string(*name).c_str());
  for (int c = 0; c < components; ++c)
    if (const auto name = element.attribute(fmt::format("ComponentName{}", c)))
      array->SetComponentName(c, std::string(*name).c_str());
  return array;
}

}  // namespace holdfast
