#pragma once
/// The values in the body of a PLY file, one after the other.

#include <string>
#include <string_view>

#include <holdfast/io/formats/ply_header.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

/// A value and the part of the file that says it.
struct PlyValue {
  double number = 0;
  std::string_view place;
};

/// Where a scanner is, to come back to.
struct PlyPlace {
  std::size_t offset = 0;
  Index line = 1;
};

/// Values written as text, one row of an element a line, or as bytes of one order. Every call throws `InputError` with
/// the line, or with the offset of the byte in the file.
class PlyScanner {
 public:
  PlyScanner(std::string_view bytes, const std::string& file, PlyEncoding encoding, PlyPlace place);

  void beginRow(const PlyElement& element, Index row);
  void endRow();
  [[nodiscard]] PlyValue value(const PlyProperty& property);
  [[nodiscard]] Index integer(PlyType type, std::string_view what);
  void skip(PlyType type, Index count);
  /// Throws unless nothing, or in a text nothing but blanks, is left.
  void expectEnd();

  [[noreturn]] void fail(const std::string& reason) const;
  [[nodiscard]] PlyPlace place() const { return {cursor_.offset(), cursor_.line()}; }
  [[nodiscard]] std::size_t remaining() const noexcept { return cursor_.remaining(); }
  /// Bytes that rows may take: the last value of a text may lack what separates it from a next one.
  [[nodiscard]] std::size_t room() const noexcept { return remaining() + (isText_ ? 1 : 0); }
  /// Bytes that a value takes at least, with what separates it from the next.
  [[nodiscard]] std::size_t leastBytes(PlyType type) const { return isText_ ? 2 : sizeOf(type); }

 private:
  /// The next `size` bytes.
  std::string_view take(std::size_t size);

  TextCursor cursor_;
  std::string_view bytes_;
  std::string file_;
  bool isText_;
  ByteOrder order_;
  std::size_t valueAt_;  // where the binary value read last begins, for errors
};

/// `value` in the form that the file's encoding and the property's type call for; `type` is kFloat or kDouble.
[[nodiscard]] std::string plyBytes(double value, PlyType type, PlyEncoding encoding);

}  // namespace holdfast
