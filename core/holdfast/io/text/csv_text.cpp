#include "holdfast/io/text/csv_text.h"

#include <algorithm>

#include <holdfast/base/error.h>

namespace holdfast {
namespace {

bool isSpaceOrTab(char c)
{
  return c == ' ' || c == '\t';
}

class Splitter {
 public:
  Splitter(std::string_view text, std::string_view file, char separator)
      : rest_(text), file_(file), ends_{separator, '\r', '\n'}
  {
  }

  std::vector<CsvRecord> records()
  {
    std::vector<CsvRecord> all;
    while (!rest_.empty()) {
      if (skipBlankLine()) continue;
      all.push_back(record());
    }
    return all;
  }

 private:
  bool skipBlankLine()
  {
    const std::size_t content = rest_.find_first_not_of(ends_[0] == '\t' ? " " : " \t");
    if (content != std::string_view::npos && rest_[content] != '\n' && rest_[content] != '\r') return false;
    rest_.remove_prefix(std::min(content, rest_.size()));
    skipLineEnd();
    return true;
  }

  CsvRecord record()
  {
    CsvRecord record{line_, {}};
    record.fields.push_back(field());
    while (rest_.starts_with(ends_[0])) {
      rest_.remove_prefix(1);
      record.fields.push_back(field());
    }
    skipLineEnd();
    return record;
  }

  std::string field() { return rest_.starts_with('"') ? quotedField() : plainField(); }

  std::string plainField()
  {
    const std::size_t length = std::min(rest_.find_first_of(ends_), rest_.size());
    std::string field(rest_.substr(0, length));
    if (ends_[0] == ',' && field.find('"') != std::string::npos)
      fail(line_, "a double quote inside a field; put the whole field in quotes and write quotes inside it twice");
    rest_.remove_prefix(length);
    return field;
  }

  std::string quotedField()
  {
    const Index start = line_;
    std::string field;
    rest_.remove_prefix(1);
    while (true) {
      const std::size_t quote = rest_.find('"');
      if (quote == std::string_view::npos) fail(start, "the quoted field that starts here does not end; close it");
      take(quote, field);
      rest_.remove_prefix(1);
      if (!rest_.starts_with('"')) break;
      take(1, field);
    }
    if (!rest_.empty() && rest_.find_first_of(ends_) != 0)
      fail(line_, "text after the closing quote of a field; write quotes inside a field twice");
    return field;
  }

  /// Moves characters of a quoted field, line ends among them.
  void take(std::size_t length, std::string& field)
  {
    for (std::size_t k = 0; k < length; ++k)
      if (rest_[k] == '\n' || (rest_[k] == '\r' && !rest_.substr(k).starts_with("\r\n"))) ++line_;
    field += rest_.substr(0, length);
    rest_.remove_prefix(length);
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
  Index line_ = 1;
};

}  // namespace

std::string csvField(std::string_view text)
{
  const bool hasBlankEnd = !text.empty() && (isSpaceOrTab(text.front()) || isSpaceOrTab(text.back()));
  if (!hasBlankEnd && text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

std::vector<CsvRecord> splitCsv(std::string_view text, std::string_view file, char separator)
{
  return Splitter(text, file, separator).records();
}

}  // namespace holdfast
