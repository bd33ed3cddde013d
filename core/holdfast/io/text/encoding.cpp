#include "holdfast/io/text/encoding.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include <holdfast/words/error.h>

namespace holdfast {
namespace {

using namespace std::string_view_literals;

struct Mark {
  std::string_view bytes;
  std::string_view encoding;
};

// UTF-32 first: its mark of little-endian texts begins with that of UTF-16.
constexpr std::array<Mark, 4> kMarks{
    {{"\xFF\xFE\0\0"sv, "UTF-32"}, {"\0\0\xFE\xFF"sv, "UTF-32"}, {"\xFF\xFE"sv, "UTF-16"}, {"\xFE\xFF"sv, "UTF-16"}}};

/// Tells whether four letters follow, each in two bytes, of which one is zero.
bool hasTwoBytesALetter(std::string_view bytes)
{
  constexpr std::size_t kLetters = 4;
  const auto isLetter = [&](std::size_t at) {
    const auto c = static_cast<unsigned char>(bytes[at]);
    return c < 0x80 && (std::isprint(c) != 0 || std::isspace(c) != 0);
  };
  const auto areLetters = [&](std::size_t first) {
    for (std::size_t k = 0; k < kLetters; ++k)
      if (!isLetter(2 * k + first) || bytes[2 * k + 1 - first] != '\0') return false;
    return true;
  };
  return bytes.size() >= 2 * kLetters && (areLetters(0) || areLetters(1));
}

std::string_view wideEncoding(std::string_view bytes)
{
  const auto* const mark = std::ranges::find_if(kMarks, [&](const Mark& m) { return bytes.starts_with(m.bytes); });
  if (mark != kMarks.end()) return mark->encoding;
  return hasTwoBytesALetter(bytes) ? "UTF-16" : "";
}

}  // namespace

void refuseWideText(std::string_view bytes, const std::string& file)
{
  if (const std::string_view encoding = wideEncoding(bytes); !encoding.empty())
    throw InputError({file, 0, {}}, fmt::format("the text is in {}: save it as UTF-8 or ASCII", encoding));
}

void TextBlocks::take(std::string_view block)
{
  // More than any cluster of a disk that a text is padded to.
  constexpr std::size_t kMostPadding = 32768;
  if (taken_ == 0) refuseWideText(block, file_);
  const std::size_t last = block.find_last_not_of('\0');
  zeros_ = last == std::string_view::npos ? zeros_ + block.size() : block.size() - last - 1;
  taken_ += block.size();
  if (zeros_ >= kMostPadding)
    throw InputError({file_, 0, fmt::format("byte {}", taken_ - zeros_)},
                     "zero bytes begin here, so this is no text: it is another file, or a download or a disk that was "
                     "not written to the end; get it again");
}

}  // namespace holdfast
