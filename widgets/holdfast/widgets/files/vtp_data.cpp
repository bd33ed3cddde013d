#include <algorithm>
#include <cstring>
#include <memory>
#include <type_traits>

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkBitArray.h>
#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkStringArray.h>

#include <holdfast/io/text/number_text.h>
#include <holdfast/widgets/files/vtp_reader.h>

namespace holdfast {
namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// No compressor of VTK's makes more bytes of one than this (LZMA, on zeros).
constexpr std::uint64_t kBestCompression = 8192;

/// An array of no tuples may say how many numbers each would have: as many as a tensor.
constexpr Index kMostComponentsOfNothing = 9;

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

/// `count` is no more than the file has bytes: no size wraps.
std::vector<std::uint64_t> words(const EncodedBytes& block, std::uint64_t count, const VtpEncoding& encoding)
{
  const std::uint64_t size = wordSize(encoding);
  const std::string bytes = block.first(count * size);
  std::vector<std::uint64_t> result;
  for (std::string_view left = bytes; !left.empty(); left.remove_prefix(size))
    result.push_back(size == 8 ? fromBytes<std::uint64_t>(left.substr(0, 8), encoding.order)
                               : fromBytes<std::uint32_t>(left.substr(0, 4), encoding.order));
  return result;
}

/// Counts what is taken of the file.
void take(const VtpEncoding& encoding, std::uint64_t count)
{
  if (count > *encoding.bytesLeft)
    throw VtpFault("the arrays share their data, and come to more than the file holds together");
  *encoding.bytesLeft -= count;
}

/// The size, then the data.
std::string plainData(const EncodedBytes& block, const VtpEncoding& encoding)
{
  const std::uint64_t size = words(block, 1, encoding)[0];
  block.requireHeld(size);
  take(encoding, size);
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
  take(encoding, total);
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

/// Bits are written as numbers in text, else eight to a byte, the first one highest.
constexpr std::array<NumberType, 12> kNumberTypes{numberType<std::uint8_t>("Bit", VTK_BIT),
                                                  numberType<std::int8_t>("Int8", VTK_TYPE_INT8),
                                                  numberType<std::uint8_t>("UInt8", VTK_TYPE_UINT8),
                                                  numberType<std::int16_t>("Int16", VTK_TYPE_INT16),
                                                  numberType<std::uint16_t>("UInt16", VTK_TYPE_UINT16),
                                                  numberType<std::int32_t>("Int32", VTK_TYPE_INT32),
                                                  numberType<std::uint32_t>("UInt32", VTK_TYPE_UINT32),
                                                  numberType<std::int64_t>("Int64", VTK_TYPE_INT64),
                                                  numberType<std::uint64_t>("UInt64", VTK_TYPE_UINT64),
                                                  numberType<float>("Float32", VTK_TYPE_FLOAT32),
                                                  numberType<double>("Float64", VTK_TYPE_FLOAT64),
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

bool isText(const XmlElement& element)
{
  return element.attribute("format").value_or("ascii") == "ascii";
}

/// How many bits an array has, where its place or the file says so. No more than `data` can hold are believed.
std::optional<Index> bitCount(const XmlElement& element, std::optional<Index> tuples, Index components,
                              std::string_view data)
{
  const Index stated = tuples ? *tuples : wholeAttribute(element, "NumberOfTuples", -1);
  if (stated < 0) return std::nullopt;
  const auto most = static_cast<Index>(8 * data.size());
  if (components > most + 1 || stated > most) return most + 1;
  return stated * components;
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

/// `data`: a byte for each bit in text, else eight bits in each. `count` are wanted where that is known.
vtkSmartPointer<vtkAbstractArray> bitsOf(std::string_view data, bool isText, std::optional<Index> count)
{
  const auto held = static_cast<Index>(isText ? data.size() : 8 * data.size());
  if (!isText && count && (*count + 7) / 8 != static_cast<Index>(data.size()))
    throw VtpFault(fmt::format("its {} bytes do not hold {} bits", data.size(), *count));
  auto bits = vtkSmartPointer<vtkBitArray>::New();
  bits->SetNumberOfValues(isText ? held : count.value_or(held));
  for (Index k = 0; k < bits->GetNumberOfValues(); ++k) {
    const auto byte = static_cast<unsigned char>(data[isText ? k : k / 8]);
    bits->SetValue(k, isText ? byte != 0 : (byte >> (7 - k % 8)) & 1);
  }
  return bits;
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

Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent)
{
  const auto text = element.attribute(name);
  if (!text) return absent;
  const ParsedNumber<Index> number = parseNumber<Index>(*text);
  if (number.fault != NumberFault::None || number.value < 0)
    throw VtpFault(fmt::format("{} is '{}' and must be a whole number from 0", name, *text));
  return number.value;
}

vtkSmartPointer<vtkAbstractArray> readVtpArray(const XmlElement& element, const VtpEncoding& encoding,
                                               std::optional<Index> tuples)
{
  const NumberType& type = typeOf(element);
  const std::string data = dataOf(element, type, encoding);
  const bool areIds = type.vtkType == VTK_TYPE_INT64 && wholeAttribute(element, "IdType", 0) == 1;
  const Index components = wholeAttribute(element, "NumberOfComponents", 1);
  auto array = type.vtkType == VTK_STRING ? textsOf(data)
               : type.vtkType == VTK_BIT  ? bitsOf(data, isText(element), bitCount(element, tuples, components, data))
                                          : numbersOf(data, type, areIds);
  const Index values = array->GetNumberOfValues();
  if (components < 1 || components > std::max<Index>(kMostComponentsOfNothing, values) || values % components != 0)
    throw VtpFault(fmt::format("its {} numbers are not whole tuples of {}", values, components));
  array->SetNumberOfComponents(static_cast<int>(components));
  if (const auto name = element.attribute("Name")) array->SetName(std::string(*name).c_str());
  for (int c = 0; c < components; ++c)
    if (const auto name = element.attribute(fmt::format("ComponentName{}", c)))
      array->SetComponentName(c, std::string(*name).c_str());
  return array;
}

}  // namespace holdfast
