#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <holdfast/base/spelling.h>
#include <holdfast/constraint_files/constraint_file_internal.h>

namespace holdfast {
TextPlace placeInText(std::string_view text, std::size_t offset)
{
  const std::string_view before = text.substr(0, offset);
  const std::size_t lineBreak = before.rfind('\n');
  const std::size_t lineStart = lineBreak == std::string_view::npos ? 0 : lineBreak + 1;
  return {static_cast<Index>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<Index>(before.size() - lineStart) + 1};
}

std::string_view requireUtf8(std::string_view text, std::string_view file)
{
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (std::size_t offset = 0; offset < text.size();) {
    const std::size_t length = utf8Length(text.substr(offset));
    if (length == 0)
      throw InputError({std::string(file), placeInText(text, offset).line, ""},
                       fmt::format("not UTF-8 text (byte 0x{:02X}); save the file in the encoding UTF-8",
                                   static_cast<unsigned char>(text[offset])));
    offset += length;
  }
  return text;
}

std::string listInQuotes(std::span<const std::string_view> words)
{
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + inQuotes(word);
  return list;
}

std::string spellingHint(std::string_view word, std::span<const std::string_view> known)
{
  const std::optional<std::string_view> closest = closestSpelling(word, known);
  const std::string guess = closest ? fmt::format("; did you mean {}? ", inQuotes(*closest)) : "; ";
  return fmt::format("{}Known here: {}", guess, listInQuotes(known));
}

}  // namespace holdfast
