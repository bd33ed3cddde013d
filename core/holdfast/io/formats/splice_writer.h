#pragma once
/// A copy of some bytes with parts of it replaced.

#include <cassert>
#include <string>
#include <string_view>
#include <utility>

namespace holdfast {

/// Builds the copy from front to back: what is not replaced is copied as it is.
class SpliceWriter {
 public:
  /// `original` must outlive the writer.
  explicit SpliceWriter(std::string_view original) : original_(original) { result_.reserve(original.size()); }

  /// Puts `replacement` where `part` is. `part` is a view into the original, behind all parts replaced before.
  void replace(std::string_view part, std::string_view replacement)
  {
    const auto first = static_cast<std::size_t>(part.data() - original_.data());
    assert(first >= copied_ && first + part.size() <= original_.size());
    result_.append(original_, copied_, first - copied_);
    result_.append(replacement);
    copied_ = first + part.size();
  }

  /// The whole copy. The writer is spent then.
  [[nodiscard]] std::string finish() &&
  {
    result_.append(original_, copied_);
    return std::move(result_);
  }

 private:
  std::string_view original_;
  std::string result_;
  std::size_t copied_ = 0;
};

}  // namespace holdfast
