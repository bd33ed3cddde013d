#pragma once
/// A cursor is a place in a text that is read token by token. It always knows its line.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <holdfast/words/error.h>

namespace holdfast {

struct TextDialect {
  std::optional<char> comment;       ///< begins a comment, which ends with the line
  std::optional<char> continuation;  ///< at the end of a line joins the next one to it
};

/// Says what a backslash means that ends a line and has no blank before it.
enum class GluedBackslash {
  Continues,  ///< the statement goes on in the next line
  EndsAName,  ///< it is the end of a name, as of a folder on Windows
};

/// A cursor walks over a text, which must outlive it. Blanks, line ends, comments and continuations separate tokens.
/// Lines end in LF, CR LF or CR alone. Byte order marks at the beginning of lines are passed over, because joined files
/// have several.
class TextCursor {
 public:
  /// `file` names the text in errors.
  TextCursor(std::string_view text, std::string file, TextDialect dialect = {});

  /// Returns the next token of this line. It is empty where the line has no more.
  [[nodiscard]] std::string_view token();

  /// Goes to the next token, on this line or a later one. Returns false where the text has no more.
  [[nodiscard]] bool findToken();

  /// Goes to the next line that does not continue this one, or to the end.
  void skipLine(GluedBackslash glued = GluedBackslash::Continues);

  /// Returns the next token of this line as a number, see `parseLooseNumber`. Throws `InputError` where there is no
  /// token ("`what` is missing"), or where the token is no number.
  [[nodiscard]] double number(std::string_view what) { return numberOf(token(), what); }
  [[nodiscard]] Index integer(std::string_view what) { return integerOf(token(), what); }

  /// These two do the same for the token that was read last.
  [[nodiscard]] double numberOf(std::string_view token, std::string_view what) const;
  [[nodiscard]] Index integerOf(std::string_view token, std::string_view what) const;

  /// Throws as `numberOf` does, save for a number that is merely too large. Such a number is kept as text and never
  /// computed with.
  void expectNumber(std::string_view token, std::string_view what) const;

  /// Passes over the other numbers of this line and returns how many they are. Throws as `expectNumber` does.
  Index skipNumbers(std::string_view what);

  /// Throws `InputError` where the line has another token. `remedy` completes "'...' is too much here: ".
  void expectLineEnd(std::string_view remedy);

  /// Throws an `InputError` with the file and the current line.
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> reason, Args&&... args) const
  {
    throw InputError({file_, line(), {}}, fmt::format(reason, std::forward<Args>(args)...));
  }

  /// Returns the line of the token that was read last, from 1.
  [[nodiscard]] Index line() const;
  [[nodiscard]] std::size_t offset() const noexcept { return at_; }
  [[nodiscard]] std::size_t remaining() const noexcept { return text_.size() - at_; }

  /// Goes to a place that `offset()` and `line()` gave.
  void seek(std::size_t offset, Index line) noexcept
  {
    at_ = offset;
    line_ = line;
  }

 private:
  void skipBlanks();
  [[nodiscard]] bool mayEndAt(std::size_t at) const { return mayEnd_[static_cast<unsigned char>(text_[at])]; }
  /// Tells whether a token ends before `at`, where it may end.
  [[nodiscard]] bool endsAt(std::size_t at) const;
  /// Returns where the line that ends in a continuation at `at` goes on. Blanks may stand behind the continuation.
  [[nodiscard]] std::optional<std::size_t> continued(std::size_t at) const;
  /// Returns where the next line begins if one ends at `at`.
  [[nodiscard]] std::optional<std::size_t> behindLineEnd(std::size_t at) const;
  void skipComment();

  std::string_view text_;
  std::string file_;
  TextDialect dialect_;
  bool hasLoneReturns_ = false;     // the first line ends in CR alone: LF behind CR begins a binary body
  std::array<bool, 256> mayEnd_{};  // for each byte: whether tokens end before it, or may (continuations)
  std::size_t at_ = 0;
  Index line_ = 1;
};

/// Returns `bytes` without the zeros and end-of-file marks (Ctrl-Z) that some programs leave behind a text.
[[nodiscard]] std::string_view withoutPadding(std::string_view bytes);

/// Returns `token` in quotes for a message. A long token is cut, see `printable`.
[[nodiscard]] std::string quotedToken(std::string_view token);

}  // namespace holdfast
