#pragma once
/// A scanner reads the body of a PLY file as a sequence of values.

#include <string>
#include <string_view>

#include <holdfast/io/formats/ply_header.h>

namespace holdfast {

/// A scanner gives the values in the body one after the other. In a text each row of an element is on lines of its own.
/// In a binary file the values are bytes of one order. Every call throws `InputError` with the line, or with the offset
/// of the byte in the file.
class PlyScanner {
 public:
  PlyScanner(std::string_view bytes, const std::string& file, const PlyHeader& header);

  void beginRow(const PlyElement& element, Index row);
  void endRow();

  [[nodiscard]] double number(const PlyProperty& property);
  [[nodiscard]] Index integer(NumberType type, std::string_view what);
  void skip(NumberType type, Index count);

  /// Throws where the rest of the file is too short for the rows of `element`. Each row takes `rowBytes` at least.
  void expectRoom(const PlyElement& element, std::size_t rowBytes) const;

  /// Says what is odd about the bytes behind the last element. Returns nothing where there are none. Throws where
  /// numbers follow in a text: these are rows that the header does not count.
  [[nodiscard]] std::optional<std::string> endRemark();

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> reason, Args&&... args) const
  {
    failWith(fmt::format(reason, std::forward<Args>(args)...));
  }

  [[nodiscard]] std::size_t offset() const { return cursor_.offset(); }
  /// Returns how many values of `property` the rest of the file has room for.
  [[nodiscard]] Index mostValues(const PlyProperty& property) const
  {
    return static_cast<Index>((cursor_.remaining() + 1) / leastBytes(property.type));
  }
  /// Returns how many bytes a value takes at least, with what separates it from the next.
  [[nodiscard]] std::size_t leastBytes(NumberType type) const { return isText_ ? 2 : sizeOf(type); }

 private:
  /// A line break tells where a row went on in the next line, and what it lacked there.
  struct LineBreak {
    std::size_t offset;
    Index line;
    std::string what;
  };

  [[noreturn]] void failWith(const std::string& reason) const;
  [[noreturn]] void failAtBreak();
  /// Returns the next value of the row, on this line or the next ones.
  std::string_view nextToken(std::string_view what);
  double taken(NumberType type);

  TextCursor cursor_;
  std::string_view bytes_;
  std::string file_;
  bool isText_;
  std::endian order_;
  std::size_t valueAt_;                  // where the binary value read last begins, for errors
  std::optional<LineBreak> firstBreak_;  // of the row
};

}  // namespace holdfast
