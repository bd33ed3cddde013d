#include "holdfast/io/text/csv_text.h"

#include <algorithm>

#include <holdfast/words/error.h>

namespace holdfast {
namespace {

class Splitter {
 public:
  Splitter(std::string_view text, std::string_view file, char separator, Index firstLine)
      : rest_(text), file_(file), ends_{separator, '\r', '\n'}, line_(firstLine)
  {
    if (isByBlanks()) ends_ += '\t';
  }

  std::vector<CsvRecord> records()
  {
    std::vector<CsvRecord> all;
    while (!rest_.empty()) {
      const std::size_t content = rest_.find_first_not_of(ends_[0] == '\t' ? " " : " \t");
      const bool isBlank = content == std::string_view::npos || rest_[content] == '\n' || rest_[content] == '\r';
      if (isBlank)
        rest_.remove_prefix(std::min(content, rest_.size()));
      else
        all.push_back(record());
      skipLineEnd();
    }
    return all;
  }

 private:
  [[nodiscard]] bool isByBlanks() const { return ends_[0] == ' '; }

  CsvRecord record()
  {
    if (isByBlanks()) static_cast<void>(skipBlanks());
    CsvRecord record{line_, {field()}};
    while (skipSeparator()) record.fields.push_back(field());
    return record;
  }

  bool skipBlanks()
  {
    const std::size_t count = std::min(rest_.find_first_not_of(" \t"), rest_.size());
    rest_.remove_prefix(count);
    return count > 0;
  }

  /// Tells whether another field follows. Blanks at the end of a line separate nothing.
  bool skipSeparator()
  {
    if (isByBlanks()) return skipBlanks() && !rest_.empty() && rest_[0] != '\n' && rest_[0] != '\r';
    if (!rest_.starts_with(ends_[0])) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string field()
  {
    if (rest_.starts_with('"')) return quotedField();
    std::string field(rest_.substr(0, rest_.find_first_of(ends_)));
    if (ends_[0] == ',' && field.find('"') != std::string::npos)
      fail(line_, "a double quote inside a field; put the whole field in quotes and write quotes inside it twice");
    rest_.remove_prefix(field.size());
    return field;
  }

  std::string quotedField()
  {
    const Index start = line_;
    std::string field;
    do {
      rest_.remove_prefix(1);
      const std::size_t quote = rest_.find('"');
      if (quote == std::string_view::npos) fail(start, "the quoted field that starts here does not end; close it");
      field += rest_.substr(0, quote + 1);
      rest_.remove_prefix(quote + 1);
    } while (rest_.starts_with('"'));
    field.pop_back();  // the closing quote
    for (std::size_t k = 0; k < field.size(); ++k)
      if (field[k] == '\n' || (field[k] == '\r' && field.compare(k, 2, "\r\n") != 0)) ++line_;
    if (!rest_.empty() && rest_.find_first_of(ends_) != 0)
      fail(line_, "text after the closing quote of a field; write quotes inside a field twice");
    return field;
  }

  void skipLineEnd()
  {
    if (rest_.empty()) return;
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
    ++line_;
  }

  [[noreturn]] void fail(Index line, const char* reason) const
  {
    throw InputError({std::string(file_), line, ""}, reason);
  }

  std::string_view rest_;
  std::string_view file_;
  std::string ends_;  // of a field: the separator and line ends
  Index line_;
};

}  // namespace

std::string csvField(std::string_view text)
{
  const bool hasBlankEnd = text.find_first_of(" \t") == 0 || text.find_last_of(" \t") + 1 == text.size();
  if (text.empty() || (!hasBlankEnd && text.find_first_of(",\"\r\n") == std::string_view::npos))
    return std::string(text);
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

std::vector<CsvRecord> splitCsv(std::string_view text, std::string_view file, char separator, Index firstLine)
{
  return Splitter(text, file, separator, firstLine).records();
}

}  // namespace holdfast
