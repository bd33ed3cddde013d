#include "holdfast/io/formats/vtp_editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <holdfast/io/text/number_text.h>
#include <holdfast/numbers/same_bits.h>

namespace holdfast {
namespace {

constexpr std::string_view kVtpBlanks = " \t\r\n";

std::string wordOf(double value, VtpReal type)
{
  return std::string((type == VtpReal::Float64 ? NumberText(value) : NumberText(static_cast<float>(value))).view());
}

/// Whether `word` is read as `value`.
bool says(std::string_view word, double value, VtpReal type)
{
  const double read = parseNumber<double>(word).value;
  return type == VtpReal::Float64 ? hasSameBits(read, value)
                                  : hasSameBits(static_cast<float>(read), static_cast<float>(value));
}

/// The text with other numbers in the places of its own. Words that say the same stay as they are.
std::string withNumbers(std::string_view text, std::span<const double> values, VtpReal type)
{
  Splicer splicer(text);
  std::size_t end = 0;
  for (const double value : values) {
    const std::size_t begin = text.find_first_not_of(kVtpBlanks, end);
    end = std::min(text.find_first_of(kVtpBlanks, begin), text.size());
    if (!says(text.substr(begin, end - begin), value, type)) splicer.replace(begin, end - begin, wordOf(value, type));
  }
  return splicer.finish();
}

std::string numbersAsText(std::span<const double> values, VtpReal type)
{
  std::string text;
  for (const double value : values) text.append(text.empty() ? "" : " ").append(wordOf(value, type));
  return text;
}

bool isBlank(std::string_view text)
{
  return text.find_first_not_of(kVtpBlanks) == std::string_view::npos;
}

/// The least and the largest length of the vectors.
std::array<double, 2> rangeOf(std::span<const double> values)
{
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t k = 0; k + 2 < values.size(); k += 3) {
    const double length = std::hypot(values[k], values[k + 1], values[k + 2]);
    least = std::min(least, length);
    largest = std::max(largest, length);
  }
  return {std::min(least, largest), largest};
}

}  // namespace

void VtpEditor::replace(const XmlElement& array, std::span<const double> values, VtpReal type)
{
  if (type == VtpReal::Float64 && array.attribute("type") != "Float64") set(array, "type", "Float64");
  setRanges(array, values);
  const std::string_view format = formatOf(array);
  if (format == "ascii") {
    replaceNumbers(array, values, type);
  } else if (format == "binary") {
    const std::string text = array.text(file_.bytes);
    const VtpBlock old(std::string_view(text).substr(text.find_first_not_of(kVtpBlanks)), true, file_.encoding);
    replaceText(array, newBlock(old, true, values, type));
  } else {
    newBlocks_.emplace(&array, newBlock(appendedBlock(array, file_), file_.isAppendedBase64, values, type));
  }
}

std::string VtpEditor::finish()
{
  if (!newBlocks_.empty()) moveBlocks();
  std::ranges::stable_sort(edits_, {}, &TextEdit::offset);
  Splicer splicer(file_.bytes);
  for (const TextEdit& edit : edits_) splicer.replace(edit.offset, edit.size, edit.replacement);
  return splicer.finish();
}

void VtpEditor::set(const XmlElement& element, std::string_view name, std::string value)
{
  edits_.push_back(attributeEdit(element, file_.bytes, name, std::move(value)));
}

/// Programs state these beside the numbers, as attributes or as keys.
void VtpEditor::setRanges(const XmlElement& array, std::span<const double> values)
{
  const auto [least, largest] = rangeOf(values);
  const std::array range{wordOf(least, VtpReal::Float64), wordOf(largest, VtpReal::Float64)};
  if (array.attribute("RangeMin")) set(array, "RangeMin", range[0]);
  if (array.attribute("RangeMax")) set(array, "RangeMax", range[1]);
  for (const XmlElement& key : array.children)
    if (const auto name = key.attribute("name"); name == "L2_NORM_RANGE" || name == "L2_NORM_FINITE_RANGE")
      for (std::size_t k = 0; k < std::min(range.size(), key.children.size()); ++k)
        replaceText(key.children[k], range[k]);
}

/// Words stay in their places where one run of text has all numbers.
void VtpEditor::replaceNumbers(const XmlElement& array, std::span<const double> values, VtpReal type)
{
  const auto hasWords = [&](const XmlText& text) { return !isBlank(text.in(file_.bytes)); };
  const auto text = std::ranges::find_if(array.texts, hasWords);
  if (text == array.texts.end()) return;
  if (text->resolved.empty() && std::none_of(text + 1, array.texts.end(), hasWords))
    edits_.push_back({text->place, text->size, withNumbers(text->in(file_.bytes), values, type)});
  else
    replaceText(array, numbersAsText(values, type));
}

/// Blanks around the text stay.
void VtpEditor::replaceText(const XmlElement& element, std::string replacement)
{
  for (const XmlText& text : element.texts) {
    const std::string_view words = text.in(file_.bytes);
    if (isBlank(words)) continue;
    const std::size_t begin = text.resolved.empty() ? words.find_first_not_of(kVtpBlanks) : 0;
    const std::size_t end = text.resolved.empty() ? words.find_last_not_of(kVtpBlanks) + 1 : text.size;
    edits_.push_back({text.place + begin, end - begin, std::exchange(replacement, {})});
  }
}

std::string VtpEditor::newBlock(const VtpBlock& old, bool isBase64, std::span<const double> values, VtpReal type) const
{
  return toVtpBlock(toVtpData(values, type, file_.encoding.order), isBase64, file_.encoding, old.partSize());
}

void VtpEditor::addBlocks(const XmlElement& element, std::vector<Block>& blocks) const
{
  if (formatOf(element) == "appended") addBlock(element, blocks);
  for (const XmlElement& child : element.children) addBlocks(child, blocks);
}

/// Arrays that the mesh does not need may state anything, and nothing is known of their size then.
void VtpEditor::addBlock(const XmlElement& array, std::vector<Block>& blocks) const
{
  try {
    const Index begin = wholeAttribute(array, "offset", -1);
    if (begin < 0) return;
    const auto replacement = newBlocks_.find(&array);
    blocks.push_back({&array, static_cast<std::size_t>(begin), static_cast<std::size_t>(begin),
                      replacement == newBlocks_.end() ? nullptr : &replacement->second});
    blocks.back().end += appendedBlock(array, file_).size();
  } catch (const VtpFault&) {
  }
}

std::vector<VtpEditor::Block> VtpEditor::blocksByPlace() const
{
  std::vector<Block> blocks;
  addBlocks(file_.root, blocks);
  std::ranges::stable_sort(blocks, {}, &Block::begin);
  std::size_t end = 0;  // of those before
  for (auto block = blocks.begin(); block != blocks.end(); ++block) {
    const bool isCut = block + 1 != blocks.end() && (block + 1)->begin < block->end;
    block->isShared = isCut || block->begin < end;
    end = std::max(end, block->end);
  }
  return blocks;
}

/// Puts new blocks in the places of old ones, and states where those behind them begin now. A block that another
/// array has too stays, and the new one goes behind all others.
void VtpEditor::moveBlocks()
{
  const std::vector<Block> blocks = blocksByPlace();
  std::size_t end = 0;
  for (const Block& block : blocks) {
    end = std::max(end, std::min(block.end, file_.appended().size()));
    if (block.replacement == nullptr || !block.isShared) put(block, block.begin, block.end - block.begin);
  }
  for (const Block& block : blocks)
    if (block.replacement != nullptr && block.isShared) put(block, end, 0);
}

/// Puts the new block, where there is one, in the place of `size` bytes of appended data.
void VtpEditor::put(const Block& block, std::size_t begin, std::size_t size)
{
  const std::size_t offset = begin + added_;
  if (offset != block.begin) set(*block.array, "offset", fmt::format("{}", offset));
  if (block.replacement == nullptr) return;
  edits_.push_back({file_.appendedPlace + begin, size, *block.replacement});
  added_ += block.replacement->size() - size;
}

}  // namespace holdfast
