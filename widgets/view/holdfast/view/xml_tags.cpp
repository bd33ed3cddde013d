#include "holdfast/view/xml_tags.h"

#include <algorithm>

namespace holdfast {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// The place of the '>' that ends a tag; one inside quotes does not.
std::size_t endOfTag(std::string_view text, std::size_t open)
{
  char quote = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (quote == 0 && text[at] == '>') return at;
    if (quote == 0 && (text[at] == '"' || text[at] == '\''))
      quote = text[at];
    else if (text[at] == quote)
      quote = 0;
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<std::string_view> XmlTag::attribute(std::string_view wanted) const
{
  std::string_view left = attributes;
  while (true) {
    const std::size_t equals = left.find('=');
    const std::size_t open = left.find_first_of("\"'", std::min(equals, left.size()));
    if (open == std::string_view::npos) return std::nullopt;
    const std::size_t close = left.find(left[open], open + 1);
    if (close == std::string_view::npos) return std::nullopt;
    if (trimmed(left.substr(0, equals)) == wanted) return left.substr(open + 1, close - open - 1);
    left.remove_prefix(close + 1);
  }
}

std::optional<XmlTag> nextTag(std::string_view text, std::size_t from)
{
  for (std::size_t open = text.find('<', from); open != std::string_view::npos; open = text.find('<', open + 1)) {
    const std::string_view next = text.substr(open + 1, 1);
    if (next == "/" || next == "!" || next == "?") continue;
    const std::size_t end = endOfTag(text, open);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view tag = text.substr(open + 1, end - open - 1);
    const std::size_t nameEnd = std::min(tag.find_first_of(" \t\r\n/"), tag.size());
    return XmlTag{tag.substr(0, nameEnd), tag.substr(nameEnd), end + 1};
  }
  return std::nullopt;
}

}  // namespace holdfast
