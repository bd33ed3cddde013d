#include "holdfast/io/text/csv_text.h"

namespace holdfast {
namespace {

bool isSpaceOrTab(char c)
{
  return c == ' ' || c == '\t';
}

}  // namespace

std::string csvField(std::string_view text)
{
  const bool hasBlankEnd = !text.empty() && (isSpaceOrTab(text.front()) || isSpaceOrTab(text.back()));
  if (!hasBlankEnd && text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

}  // namespace holdfast
