#include "holdfast/io/formats/vtp_array.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include <fmt/format.h>

#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr std::string_view kArrayBlanks = " \t\r\n";

/// An array of no tuples may say how many numbers each would have: as many as a tensor.
constexpr Index kMostComponentsOfNothing = 9;

std::string_view withoutLeadingBlanks(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(kArrayBlanks), text.size()));
  return text;
}

template <class Number>
Number numberOfWord(std::string_view word)
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
    const std::string_view word = text.substr(0, text.find_first_of(kArrayBlanks));
    data += toBytes(numberOfWord<Number>(word), std::endian::native);
    text.remove_prefix(word.size());
  }
  return data;
}

template <class Number, class Target>
std::vector<Target> converted(std::string_view data)
{
  std::vector<Target> values;
  values.reserve(data.size() / sizeof(Number));
  for (; !data.empty(); data.remove_prefix(sizeof(Number)))
    values.push_back(static_cast<Target>(fromBytes<Number>(data.substr(0, sizeof(Number)), std::endian::native)));
  return values;
}

template <class Number>
constexpr VtpType numbersCalled(std::string_view name)
{
  return {name,
          sizeof(Number),
          std::is_integral_v<Number>,
          dataOfText<Number>,
          converted<Number, double>,
          converted<Number, Index>};
}

/// Bits are written as numbers in text, else eight to a byte, the first one highest. Texts are their bytes, each text
/// with a byte 0 at its end.
constexpr std::array<VtpType, 12> kVtpTypes{VtpType{"Bit", 1, false, dataOfText<std::uint8_t>},
                                            VtpType{"String", 1, false, dataOfText<std::int8_t>},
                                            numbersCalled<std::int8_t>("Int8"),
                                            numbersCalled<std::uint8_t>("UInt8"),
                                            numbersCalled<std::int16_t>("Int16"),
                                            numbersCalled<std::uint16_t>("UInt16"),
                                            numbersCalled<std::int32_t>("Int32"),
                                            numbersCalled<std::uint32_t>("UInt32"),
                                            numbersCalled<std::int64_t>("Int64"),
                                            numbersCalled<std::uint64_t>("UInt64"),
                                            numbersCalled<float>("Float32"),
                                            numbersCalled<double>("Float64")};

const VtpType& typeOfArray(const XmlElement& element)
{
  const std::string_view name = element.attribute("type").value_or("");
  const auto* const found = std::ranges::find(kVtpTypes, name, &VtpType::name);
  if (found == kVtpTypes.end())
    throw VtpFault(fmt::format("its type is '{}' and must be Float64, Float32, Int64, String or the like", name));
  return *found;
}

Index textsIn(std::string_view data)
{
  if (!data.empty() && data.back() != '\0') throw VtpFault("its last text has no end");
  return std::ranges::count(data, '\0');
}

/// In text each bit is a number. Otherwise the place of the array or the file says how many bits of the bytes count.
/// No more than the bytes hold are believed.
Index bitsIn(const XmlElement& element, const VtpArray& array, std::optional<Index> tuples)
{
  const auto bytes = static_cast<Index>(array.data.size());
  if (formatOf(element) == "ascii") return bytes;
  const Index stated = tuples ? *tuples : wholeAttribute(element, "NumberOfTuples", -1);
  if (stated < 0) return 8 * bytes;
  const bool isPossible = stated == 0 || array.components <= 8 * bytes / stated;
  const Index bits = isPossible ? stated * array.components : 8 * bytes + 1;
  if ((bits + 7) / 8 != bytes) throw VtpFault(fmt::format("its {} bytes do not hold {} bits", bytes, bits));
  return bits;
}

Index valuesIn(const XmlElement& element, const VtpArray& array, std::optional<Index> tuples)
{
  if (array.isNumbers()) return static_cast<Index>(array.data.size() / array.type->size);
  return array.type->name == "String" ? textsIn(array.data) : bitsIn(element, array, tuples);
}

void requireTuples(const VtpArray& array, Index needed)
{
  if (array.tuples() != needed)
    throw VtpFault(fmt::format("it has {} tuples where {} must be", array.tuples(), needed));
}

void requireWholeTuples(const VtpArray& array)
{
  const bool isSound = array.components >= 1 &&
                       array.components <= std::max<Index>(kMostComponentsOfNothing, array.values) &&
                       array.values % array.components == 0;
  if (!isSound)
    throw VtpFault(fmt::format("its {} numbers are not whole tuples of {}", array.values, array.components));
}

void reverseNumbers(std::string& data, std::size_t size)
{
  for (auto number = data.begin(); number != data.end(); number += static_cast<std::ptrdiff_t>(size))
    std::reverse(number, number + static_cast<std::ptrdiff_t>(size));
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

std::string_view formatOf(const XmlElement& element)
{
  return element.attribute("format").value_or("ascii");
}

VtpBlock appendedBlock(const XmlElement& element, const VtpFile& file)
{
  const Index offset = wholeAttribute(element, "offset", -1);
  if (offset < 0 || offset >= std::ssize(file.appended()))
    throw VtpFault("its data would begin where the file has none");
  return {file.appended().substr(offset), file.isAppendedBase64, file.encoding};
}

VtpArray VtpArrayReader::read(const XmlElement& element, std::optional<Index> tuples)
{
  VtpArray array{&typeOfArray(element), wholeAttribute(element, "NumberOfComponents", 1), 0, ""};
  array.data = dataOf(element, *array.type);
  array.values = valuesIn(element, array, tuples);
  requireWholeTuples(array);
  requireTuples(array, tuples ? *tuples : wholeAttribute(element, "NumberOfTuples", array.tuples()));
  return array;
}

std::string VtpArrayReader::dataOf(const XmlElement& element, const VtpType& type)
{
  const std::string_view format = formatOf(element);
  if (format == "ascii") return type.dataOfText(element.text(file_.bytes));
  if (format != "binary" && format != "appended")
    throw VtpFault(fmt::format("its format is '{}' and must be ascii, binary or appended", format));
  std::string data = storedData(element, format);
  if (data.size() % type.size != 0) throw VtpFault("its data are no whole number of numbers");
  if (file_.encoding.order != std::endian::native) reverseNumbers(data, type.size);
  return data;
}

std::string VtpArrayReader::storedData(const XmlElement& element, std::string_view format)
{
  if (format == "appended") return taken(appendedBlock(element, file_));
  const std::string text = element.text(file_.bytes);
  const std::string_view block = withoutLeadingBlanks(text);
  if (block.empty()) return {};  // some programs write nothing for nothing
  return taken(VtpBlock(block, true, file_.encoding));
}

/// Counts what is taken of the file.
std::string VtpArrayReader::taken(const VtpBlock& block)
{
  if (block.dataSize() > bytesLeft_)
    throw VtpFault("the arrays share their data, and come to more than the file holds together");
  bytesLeft_ -= block.dataSize();
  return block.data();
}

std::string toVtpData(std::span<const double> values, VtpReal type, std::endian order)
{
  std::string data;
  data.reserve(values.size() * (type == VtpReal::Float64 ? sizeof(double) : sizeof(float)));
  for (const double value : values)
    data += type == VtpReal::Float64 ? toBytes(value, order) : toBytes(static_cast<float>(value), order);
  return data;
}

}  // namespace holdfast
