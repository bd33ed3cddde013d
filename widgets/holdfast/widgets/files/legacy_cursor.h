#pragma once
/// \file
/// A place in the bytes of a legacy file of VTK's, moved on by words, lines and blocks of data.

#include <string>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// Text between numbers is the same in both encodings; the numbers of data blocks are text or big-endian binary.
class LegacyCursor {
 public:
  LegacyCursor(std::string_view bytes, std::string file);

  void setBinary() { isBinary_ = true; }
  [[nodiscard]] bool isBinary() const { return isBinary_; }
  /// Only blanks are left.
  [[nodiscard]] bool isAtEnd();

  /// The rest of this line, without its end.
  [[nodiscard]] std::string_view line();
  /// The next word in lower case, as VTK compares them.
  [[nodiscard]] std::string word();
  /// The next word without going there; empty at the end.
  [[nodiscard]] std::string peekWord();
  void requireWord(std::string_view expected);
  /// The next word as a whole number from 0, no more than there are bits in the file: every item takes one at least.
  [[nodiscard]] Index count();

  /// The product of two counts, under the same limit.
  [[nodiscard]] Index product(Index a, Index b) const;

  /// Skips a block of `count` numbers of `type` ("float", "vtktypeint64").
  void skipNumbers(Index count, const std::string& type);
  /// Skips a block of cells: `cellCount` times a number of corners and their ids, `size` numbers in all.
  void skipCells(Index cellCount, Index size);
  /// Skips lines up to an empty one.
  void skipParagraph();

  /// Throws `InputError` about the last word or line.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void skipBlanks();
  void skipBinary(Index size);
  void skipStrings(Index count);
  [[nodiscard]] Index binaryStringLength();
  void requireBlankRestOfLine();
  [[nodiscard]] std::string_view rawWord();
  [[nodiscard]] Index nextInt();
  void skipTextNumber();
  [[nodiscard]] Index limit() const { return 8 * static_cast<Index>(bytes_.size()); }
  [[nodiscard]] Index remaining() const { return static_cast<Index>(bytes_.size() - at_); }

  std::string_view bytes_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t place_ = 0;  // where the last word or line began, for messages
  bool isBinary_ = false;
};

}  // namespace holdfast
