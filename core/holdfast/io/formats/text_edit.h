#pragma once
/// These edits replace parts of a file and copy the rest of it byte for byte.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace holdfast {

/// `replacement` takes the place of `size` bytes from `offset` on.
struct TextEdit {
  std::size_t offset = 0;
  std::size_t size = 0;
  std::string replacement;
};

/// Copies a file with other texts in some places, which come in ascending order.
class Splicer {
 public:
  explicit Splicer(std::string_view bytes) : bytes_(bytes) { result_.reserve(bytes.size()); }

  void replace(std::size_t offset, std::size_t size, std::string_view replacement)
  {
    result_.append(bytes_.substr(copied_, offset - copied_)).append(replacement);
    copied_ = offset + size;
  }

  [[nodiscard]] std::string finish() { return std::move(result_.append(bytes_.substr(copied_))); }

 private:
  std::string_view bytes_;
  std::string result_;
  std::size_t copied_ = 0;
};

}  // namespace holdfast
