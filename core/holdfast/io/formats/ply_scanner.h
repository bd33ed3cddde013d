#pragma once
/// \file
/// The values in the body of a PLY file, one after the other, the same way for text and for binary.

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

/// Values written as text, one row of an element a line. Every call throws `InputError` with the line.
class PlyTextScanner {
 public:
  PlyTextScanner(std::string_view bytes, const std::string& file, PlyPlace place);

  void beginRow(const PlyElement& element, Index row);
  void endRow();
  [[nodiscard]] PlyValue value(const PlyProperty& property);
  [[nodiscard]] Index integer(PlyType type, std::string_view what);
  void skip(PlyType type, Index count);
  /// Throws unless nothing but blanks is left.
  void expectEnd();

  [[noreturn]] void fail(const std::string& reason) const { cursor_.fail(reason); }
  [[nodiscard]] PlyPlace place() const { return {cursor_.offset(), cursor_.line()}; }
  [[nodiscard]] std::size_t remaining() const noexcept { return cursor_.remaining(); }
  /// Bytes that rows may take: the last value may lack what separates it from a next one.
  [[nodiscard]] std::size_t room() const noexcept { return remaining() + 1; }
  /// Bytes that a value takes at least, with what separates it from the next.
  [[nodiscard]] static std::size_t leastBytes(PlyType /*type*/) { return 2; }

 private:
  TextCursor cursor_;
};

/// Values as bytes of one order. Every call throws `InputError` with the offset of the byte in the file.
class PlyBinaryScanner {
 public:
  PlyBinaryScanner(std::string_view bytes, const std::string& file, PlyPlace place, ByteOrder order);

  void beginRow(const PlyElement& element, Index row);
  void endRow() {}
  [[nodiscard]] PlyValue value(const PlyProperty& property);
  [[nodiscard]] Index integer(PlyType type, std::string_view what);
  void skip(PlyType type, Index count);
  void expectEnd() const;

  [[noreturn]] void fail(const std::string& reason) const;
  [[nodiscard]] PlyPlace place() const { return {at_, 1}; }
  [[nodiscard]] std::size_t remaining() const noexcept { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t room() const noexcept { return remaining(); }
  [[nodiscard]] static std::size_t leastBytes(PlyType type) { return sizeOf(type); }

 private:
  /// The next `size` bytes.
  std::string_view take(std::size_t size);

  std::string_view bytes_;
  std::string file_;
  std::size_t at_;
  std::size_t valueAt_;  // where the value read last begins, for errors
  ByteOrder order_;
};

/// `value` in the form that the file's encoding and the property's type call for; `type` is kFloat or kDouble.
[[nodiscard]] std::string plyBytes(double value, PlyType type, PlyEncoding encoding);

/// Byte order of a binary encoding.
[[nodiscard]] ByteOrder byteOrder(PlyEncoding encoding);

}  // namespace holdfast
