#pragma once
/// These checks tell whether bytes are a text that can be read.

#include <string>
#include <string_view>

namespace holdfast {

/// Throws an `InputError` that names the encoding where `bytes` begin a text in UTF-16 or UTF-32. The text may have a
/// byte order mark or none. `file` names the file. O(1).
void refuseWideText(std::string_view bytes, const std::string& file);

/// Looks at a text while it is read block by block. So a disk image or a download that was never filled is refused
/// before it takes memory.
class TextBlocks {
 public:
  explicit TextBlocks(std::string file) : file_(std::move(file)) {}

  /// Takes the next block. Throws `InputError` for wide text, see above, and where a long run of zero bytes ends what
  /// was taken. A few zeros behind a text are padding, more are not. O(zeros at the end of the block).
  void take(std::string_view block);

 private:
  std::string file_;
  std::size_t taken_ = 0;  // bytes
  std::size_t zeros_ = 0;  // at their end
};

}  // namespace holdfast
