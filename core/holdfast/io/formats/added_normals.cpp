#include "holdfast/io/formats/added_normals.h"

#include <algorithm>
#include <numeric>

#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

/// Where normals stand among those of the file and the added ones.
class NormalNumbers {
 public:
  NormalNumbers(const FileLayout& layout, const NormalUpdate& update, std::span<const NormalReference> references)
      : behind_(update.added.size(), -1), numberOf_(update.added.size()), addedUpTo_(layout.normalCount + 1, 0)
  {
    for (std::size_t c = 0; c < references.size(); ++c)
      if (const int added = update.addedOfCorner[c]; added >= 0 && behind_[added] < 0)
        behind_[added] = std::max<Index>(references[c].above, update.added[added].of + 1);
    order_.resize(behind_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {}, [&](std::size_t k) { return behind_[k]; });
    for (std::size_t k = 0; k < order_.size(); ++k) {
      numberOf_[order_[k]] = behind_[order_[k]] + static_cast<Index>(k);
      ++addedUpTo_[behind_[order_[k]]];
    }
    std::partial_sum(addedUpTo_.begin(), addedUpTo_.end(), addedUpTo_.begin());
  }

  /// The added ones by their place in the file.
  [[nodiscard]] std::span<const std::size_t> order() const { return order_; }
  /// How many of the file's own normals an added one stands behind.
  [[nodiscard]] Index behind(std::size_t added) const { return behind_[added]; }
  [[nodiscard]] Index ofAdded(std::size_t added) const { return numberOf_[added]; }
  [[nodiscard]] Index ofStored(Index normal) const { return normal + addedUpTo_[normal]; }
  /// How many stand above a line that had `above` above it.
  [[nodiscard]] Index above(Index above) const { return above + addedUpTo_[above]; }

 private:
  std::vector<Index> behind_;
  std::vector<Index> numberOf_;
  std::vector<Index> addedUpTo_;  // how many stand behind at most that many of the file's own
  std::vector<std::size_t> order_;
};

std::string normalLine(const Vector3& normal)
{
  std::string line = "vn";
  for (const double x : normal) line.append(" ").append(NumberText(x).view());
  return line;
}

/// The end of the line before `next`: LF, CR LF or CR.
std::string_view lineEndBefore(std::string_view bytes, std::size_t next)
{
  const std::string_view before = bytes.substr(0, next);
  if (before.ends_with("\r\n")) return "\r\n";
  return before.ends_with('\r') ? "\r" : "\n";
}

class EditMaker {
 public:
  EditMaker(std::string_view bytes, const FileLayout& layout, const NormalUpdate& update)
      : bytes_(bytes),
        layout_(layout),
        update_(update),
        references_(layout.referencesIn(bytes)),
        numbers_(layout, update, references_)
  {
  }

  std::vector<TextEdit> make()
  {
    addLines();
    for (std::size_t c = 0; c < references_.size(); ++c) addReference(c);
    std::ranges::stable_sort(edits_, {}, &TextEdit::offset);
    return std::move(edits_);
  }

 private:
  void addLines()
  {
    std::vector<std::size_t> placeOf(static_cast<std::size_t>(layout_.normalCount));
    for (const auto& [offset, number] : layout_.numbers)
      if (number < 0) placeOf[(-1 - number) / 3] = offset;
    for (const std::size_t added : numbers_.order()) {
      TextCursor cursor(bytes_, {}, layout_.dialect);
      cursor.seek(placeOf[numbers_.behind(added) - 1], 1);
      cursor.skipLine();
      addLine(cursor.offset(), normalLine(update_.added[added].value));
    }
  }

  void addLine(std::size_t next, std::string line)
  {
    const std::string_view end = lineEndBefore(bytes_, next);
    if (bytes_.substr(0, next).ends_with(end))
      line += end;
    else
      line.insert(0, end);  // behind a last line without an end
    edits_.push_back({next, 0, std::move(line)});
  }

  void addReference(std::size_t corner)
  {
    const NormalReference& reference = references_[corner];
    const int normal = layout_.normalOfCorner[corner];
    if (reference.size == 0 || normal < 0) return;
    const int added = update_.addedOfCorner[corner];
    const Index number = added >= 0 ? numbers_.ofAdded(added) : numbers_.ofStored(normal);
    const Index before = reference.isRelative ? normal - reference.above : normal + 1;
    const Index after = reference.isRelative ? number - numbers_.above(reference.above) : number + 1;
    if (after != before) edits_.push_back({reference.offset, reference.size, std::string(NumberText(after).view())});
  }

  std::string_view bytes_;
  const FileLayout& layout_;
  const NormalUpdate& update_;
  std::vector<NormalReference> references_;
  NormalNumbers numbers_;
  std::vector<TextEdit> edits_;
};

}  // namespace

std::vector<TextEdit> editsOfReferences(std::string_view bytes, const FileLayout& layout, const NormalUpdate& update)
{
  if (update.added.empty()) return {};
  return EditMaker(bytes, layout, update).make();
}

}  // namespace holdfast
