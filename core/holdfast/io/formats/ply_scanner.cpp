#include "holdfast/io/formats/ply_scanner.h"

#include <cassert>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

Index integerFromBytes(std::string_view bytes, PlyType type, ByteOrder order)
{
  switch (type) {
    case PlyType::kInt8:
      return fromBytes<std::int8_t>(bytes, order);
    case PlyType::kUint8:
      return fromBytes<std::uint8_t>(bytes, order);
    case PlyType::kInt16:
      return fromBytes<std::int16_t>(bytes, order);
    case PlyType::kUint16:
      return fromBytes<std::uint16_t>(bytes, order);
    case PlyType::kInt32:
      return fromBytes<std::int32_t>(bytes, order);
    default:
      assert(type == PlyType::kUint32);
      return fromBytes<std::uint32_t>(bytes, order);
  }
}

double numberFromBytes(std::string_view bytes, PlyType type, ByteOrder order)
{
  if (type == PlyType::kDouble) return fromBytes<double>(bytes, order);
  if (type == PlyType::kFloat) return static_cast<double>(fromBytes<float>(bytes, order));
  return static_cast<double>(integerFromBytes(bytes, type, order));
}

/// The byte order of a binary encoding.
ByteOrder byteOrder(PlyEncoding encoding)
{
  return encoding == PlyEncoding::kBigEndian ? ByteOrder::kBig : ByteOrder::kLittle;
}

}  // namespace

PlyScanner::PlyScanner(std::string_view bytes, const std::string& file, PlyEncoding encoding, PlyPlace place)
    : cursor_(bytes, file),
      bytes_(bytes),
      file_(file),
      isText_(encoding == PlyEncoding::kText),
      order_(byteOrder(encoding)),
      valueAt_(place.offset)
{
  cursor_.seek(place.offset, place.line);
}

void PlyScanner::beginRow(const PlyElement& element, Index row)
{
  valueAt_ = cursor_.offset();
  if (isText_ ? cursor_.findToken() : remaining() > 0) return;
  fail(
      fmt::format("the file ends after {} of {} rows of element {}: it is truncated, or the count in the header is "
                  "wrong",
                  row, element.count, quotedToken(element.name)));
}

void PlyScanner::endRow()
{
  if (isText_) cursor_.expectLineEnd("the properties in the header call for fewer values a line");
}

PlyValue PlyScanner::value(const PlyProperty& property)
{
  const std::string_view place = isText_ ? cursor_.token() : take(sizeOf(property.type));
  return {isText_ ? numberOf(place, property.name, cursor_) : numberFromBytes(place, property.type, order_), place};
}

Index PlyScanner::integer(PlyType type, std::string_view what)
{
  return isText_ ? cursor_.integer(what) : integerFromBytes(take(sizeOf(type)), type, order_);
}

void PlyScanner::skip(PlyType type, Index count)
{
  if (isText_) {
    for (Index i = 0; i < count; ++i) static_cast<void>(cursor_.number("a value of the line"));
    return;
  }
  // Compared by division: the product may overflow.
  if (static_cast<std::size_t>(count) > remaining() / sizeOf(type))
    fail(fmt::format("{} values are to follow, but only {} bytes do: the file is truncated, or a count is wrong", count,
                     remaining()));
  take(sizeOf(type) * count);
}

void PlyScanner::expectEnd()
{
  valueAt_ = cursor_.offset();
  if (isText_ ? !cursor_.findToken() : remaining() == 0) return;
  fail((isText_ ? "there is more text behind the last element"
                : fmt::format("{} bytes follow the last element", remaining())) +
       ": correct the counts in the header, or remove what follows");
}

void PlyScanner::fail(const std::string& reason) const
{
  if (isText_) cursor_.fail(reason);
  throw InputError({file_, 0, fmt::format("byte {}", valueAt_)}, reason);
}

std::string_view PlyScanner::take(std::size_t size)
{
  valueAt_ = cursor_.offset();
  if (size > remaining()) fail("the file ends inside this value: it is truncated; export it again");
  cursor_.seek(valueAt_ + size, 1);
  return bytes_.substr(valueAt_, size);
}

std::string plyBytes(double value, PlyType type, PlyEncoding encoding)
{
  if (encoding == PlyEncoding::kText) {
    const NumberText text = type == PlyType::kFloat ? NumberText(static_cast<float>(value)) : NumberText(value);
    return std::string(text.view());
  }
  if (type == PlyType::kFloat) return std::string(toBytes(static_cast<float>(value), byteOrder(encoding)).view());
  return std::string(toBytes(value, byteOrder(encoding)).view());
}

}  // namespace holdfast
