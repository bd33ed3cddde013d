#pragma once
/// A place in a text that is read token by token and always knows its line.

#include <optional>
#include <string>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// What a text format means by some characters.
struct TextDialect {
  std::optional<char> comment;       ///< begins a comment, which ends with the line
  std::optional<char> continuation;  ///< at the end of a line joins the next one to it
};

/// Walks over a text. Tokens are what blanks (space, tab, carriage return, ...), line ends, comments and continuations
/// separate. Views returned point into the text, which must outlive the cursor. A byte order mark is passed over.
class TextCursor {
 public:
  /// `file` names the text in errors.
  TextCursor(std::string_view text, std::string file, TextDialect dialect = {});

  /// The next token of this line; empty where the line has no more.
  [[nodiscard]] std::string_view token();

  /// Goes to the next token, on this line or a later one; false where the text has no more.
  [[nodiscard]] bool findToken();

  /// Goes to the beginning of the next line that does not continue this one, or to the end.
  void skipLine();

  /// The next token of this line as a number. Throws `InputError` where there is none ("`what` is missing") and where
  /// it is no number.
  [[nodiscard]] double number(std::string_view what);
  [[nodiscard]] Index integer(std::string_view what);

  /// Throws `InputError` where the line has another token; `remedy` completes "'...' is too much here: ".
  void expectLineEnd(std::string_view remedy);

  /// Throws an `InputError` with the file, the current line and `reason`.
  [[noreturn]] void fail(const std::string& reason) const;

  /// Line of the token read last, from 1.
  [[nodiscard]] Index line() const;
  [[nodiscard]] std::size_t offset() const noexcept { return at_; }
  [[nodiscard]] std::size_t remaining() const noexcept { return text_.size() - at_; }

  /// Goes to a place that `offset()` and `line()` gave.
  void seek(std::size_t offset, Index line) noexcept;

 private:
  void skipBlanks();
  [[nodiscard]] bool endsToken(std::size_t at) const;
  /// Where the line that ends in a continuation at `at` goes on; nothing if there is no continuation.
  [[nodiscard]] std::optional<std::size_t> continued(std::size_t at) const;

  std::string_view text_;
  std::string file_;
  TextDialect dialect_;
  std::size_t at_ = 0;
  Index line_ = 1;
};

/// `token` in quotes for a message: cut where long, see `printable`.
[[nodiscard]] std::string quotedToken(std::string_view token);

/// `token` as a number. Throws an `InputError` at the place of `cursor`, naming `what`, where it is none.
[[nodiscard]] double numberOf(std::string_view token, std::string_view what, const TextCursor& cursor);
[[nodiscard]] Index integerOf(std::string_view token, std::string_view what, const TextCursor& cursor);

}  // namespace holdfast
