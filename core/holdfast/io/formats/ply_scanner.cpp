#include "holdfast/io/formats/ply_scanner.h"

#include <array>
#include <cstdint>

#include <holdfast/io/text/loose_number.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

template <class Number>
double numberFromBytes(std::string_view bytes, std::endian order)
{
  return static_cast<double>(fromBytes<Number>(bytes, order));
}

/// In the order of `NumberType`. A double holds each of them exactly.
constexpr std::array kNumberFromBytes{numberFromBytes<std::int8_t>,  numberFromBytes<std::uint8_t>,
                                      numberFromBytes<std::int16_t>, numberFromBytes<std::uint16_t>,
                                      numberFromBytes<std::int32_t>, numberFromBytes<std::uint32_t>,
                                      numberFromBytes<float>,        numberFromBytes<double>};

}  // namespace

PlyScanner::PlyScanner(std::string_view bytes, const std::string& file, const PlyHeader& header)
    : cursor_(header.byteOrder ? bytes : withoutPadding(bytes), file),
      bytes_(bytes),
      file_(file),
      isText_(!header.byteOrder),
      order_(header.byteOrder.value_or(std::endian::little)),
      valueAt_(header.bodyOffset)
{
  cursor_.seek(header.bodyOffset, header.bodyLine);
}

void PlyScanner::beginRow(const PlyElement& element, Index row)
{
  firstBreak_.reset();
  valueAt_ = cursor_.offset();
  if (isText_ ? cursor_.findToken() : cursor_.remaining() > 0) return;
  fail("the file ends after {} of {} rows of element {}: it is truncated, or the count in the header is wrong", row,
       element.count, quotedToken(element.name));
}

void PlyScanner::endRow()
{
  if (!isText_) return;
  const std::string_view extra = cursor_.token();
  if (extra.empty()) return;
  // A row that goes on in the next line and ends within it is one that lacks a value.
  if (firstBreak_) failAtBreak();
  cursor_.fail("{} is too much here: the properties in the header call for fewer values a line", quotedToken(extra));
}

double PlyScanner::number(const PlyProperty& property)
{
  return isText_ ? cursor_.numberOf(nextToken(property.name), property.name) : taken(property.type);
}

Index PlyScanner::integer(NumberType type, std::string_view what)
{
  return isText_ ? cursor_.integerOf(nextToken(what), what) : static_cast<Index>(taken(type));
}

void PlyScanner::skip(NumberType type, Index count)
{
  if (isText_) {
    constexpr std::string_view kWhat = "a value of the line";
    for (Index i = 0; i < count; ++i) cursor_.expectNumber(nextToken(kWhat), kWhat);
    return;
  }
  // Compared by division: the product may overflow.
  if (static_cast<std::size_t>(count) > cursor_.remaining() / sizeOf(type))
    fail("{} values are to follow, but only {} bytes do: the file is truncated, or a count is wrong", count,
         cursor_.remaining());
  valueAt_ = cursor_.offset();
  cursor_.seek(valueAt_ + sizeOf(type) * count, 1);
}

void PlyScanner::expectRoom(const PlyElement& element, std::size_t rowBytes) const
{
  // The last value of a text may lack what separates it from a next one.
  const std::size_t room = cursor_.remaining() + (isText_ ? 1 : 0);
  if (rowBytes == 0 || static_cast<std::size_t>(element.count) <= room / rowBytes) return;
  fail(
      "the header promises {} rows of element {}, of {} bytes at least, but only {} bytes follow: the file is "
      "truncated, or the count is wrong",
      element.count, quotedToken(element.name), rowBytes, cursor_.remaining());
}

std::optional<std::string> PlyScanner::endRemark()
{
  if (isText_ ? !cursor_.findToken() : cursor_.remaining() == 0) return std::nullopt;
  if (!isText_)
    return fmt::format(
        "{} behind the last element that the header counts; the file keeps that, and nothing of it is read: is a count "
        "too small?",
        counted(static_cast<Index>(cursor_.remaining()), "byte"));
  if (parseLooseNumber(cursor_.token()).fault != NumberFault::NotANumber)
    fail("there is more text behind the last element: correct the counts in the header, or remove what follows");
  return fmt::format("text follows the last element, from line {} on; the file keeps it, and nothing of it is read",
                     cursor_.line());
}

void PlyScanner::failWith(const std::string& reason) const
{
  if (isText_) cursor_.fail("{}", reason);
  throw InputError({file_, 0, fmt::format("byte {}", valueAt_)}, reason);
}

void PlyScanner::failAtBreak()
{
  cursor_.seek(firstBreak_->offset, firstBreak_->line);
  cursor_.fail("{} is missing: complete the line", firstBreak_->what);
}

std::string_view PlyScanner::nextToken(std::string_view what)
{
  const std::string_view token = cursor_.token();
  if (!token.empty()) return token;
  if (!firstBreak_) firstBreak_ = LineBreak{cursor_.offset(), cursor_.line(), std::string(what)};
  if (!cursor_.findToken()) failAtBreak();
  return cursor_.token();
}

double PlyScanner::taken(NumberType type)
{
  valueAt_ = cursor_.offset();
  if (sizeOf(type) > cursor_.remaining()) fail("the file ends inside this value: it is truncated; export it again");
  cursor_.seek(valueAt_ + sizeOf(type), 1);
  return kNumberFromBytes[static_cast<std::size_t>(type)](bytes_.substr(valueAt_, sizeOf(type)), order_);
}

}  // namespace holdfast
