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

}  // namespace

PlyTextScanner::PlyTextScanner(std::string_view bytes, const std::string& file, PlyPlace place) : cursor_(bytes, file)
{
  cursor_.seek(place.offset, place.line);
}

void PlyTextScanner::beginRow(const PlyElement& element, Index row)
{
  if (!cursor_.findToken())
    cursor_.fail(
        fmt::format("the file ends after {} of {} rows of element {}: it is truncated, or the count in the "
                    "header is wrong",
                    row, element.count, quotedToken(element.name)));
}

void PlyTextScanner::endRow()
{
  cursor_.expectLineEnd("the properties in the header call for fewer values a line");
}

PlyValue PlyTextScanner::value(const PlyProperty& property)
{
  const std::string_view token = cursor_.token();
  return {numberOf(token, property.name, cursor_), token};
}

Index PlyTextScanner::integer(PlyType /*type*/, std::string_view what)
{
  return cursor_.integer(what);
}

void PlyTextScanner::skip(PlyType /*type*/, Index count)
{
  for (Index i = 0; i < count; ++i) static_cast<void>(cursor_.number("a value of the line"));
}

void PlyTextScanner::expectEnd()
{
  if (cursor_.findToken())
    cursor_.fail(
        "there is more text behind the last element: correct the counts in the header, or remove what follows");
}

PlyBinaryScanner::PlyBinaryScanner(std::string_view bytes, const std::string& file, PlyPlace place, ByteOrder order)
    : bytes_(bytes), file_(file), at_(place.offset), valueAt_(place.offset), order_(order)
{
}

void PlyBinaryScanner::beginRow(const PlyElement& element, Index row)
{
  valueAt_ = at_;
  if (remaining() == 0)
    fail(
        fmt::format("the file ends after {} of {} rows of element {}: it is truncated, or the count in the header is "
                    "wrong",
                    row, element.count, quotedToken(element.name)));
}

PlyValue PlyBinaryScanner::value(const PlyProperty& property)
{
  const std::string_view bytes = take(sizeOf(property.type));
  return {numberFromBytes(bytes, property.type, order_), bytes};
}

Index PlyBinaryScanner::integer(PlyType type, std::string_view /*what*/)
{
  return integerFromBytes(take(sizeOf(type)), type, order_);
}

void PlyBinaryScanner::skip(PlyType type, Index count)
{
  // Compared by division: the product may overflow.
  if (static_cast<std::size_t>(count) > remaining() / sizeOf(type))
    fail(fmt::format("{} values are to follow, but only {} bytes do: the file is truncated, or a count is wrong", count,
                     remaining()));
  take(sizeOf(type) * count);
}

void PlyBinaryScanner::expectEnd() const
{
  if (remaining() == 0) return;
  throw InputError(
      {file_, 0, fmt::format("byte {}", at_)},
      fmt::format("{} bytes follow the last element: correct the counts in the header, or remove them", remaining()));
}

void PlyBinaryScanner::fail(const std::string& reason) const
{
  throw InputError({file_, 0, fmt::format("byte {}", valueAt_)}, reason);
}

std::string_view PlyBinaryScanner::take(std::size_t size)
{
  valueAt_ = at_;
  if (size > remaining()) fail("the file ends inside this value: it is truncated; export it again");
  at_ += size;
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

ByteOrder byteOrder(PlyEncoding encoding)
{
  return encoding == PlyEncoding::kBigEndian ? ByteOrder::kBig : ByteOrder::kLittle;
}

}  // namespace holdfast
