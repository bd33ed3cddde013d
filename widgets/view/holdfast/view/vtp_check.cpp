#include "holdfast/view/vtp_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/base/types.h>
#include <holdfast/view/xml_tags.h>

namespace holdfast {
namespace {

/// No compressor of VTK's makes more bytes of one than this (LZMA, on zeros).
constexpr Index kBestCompression = 8192;

/// An array whose numbers are not text.
struct Block {
  std::size_t begin = 0;  ///< of its header in the file
  bool isBase64 = false;
  bool mayBeEmpty = false;
};

/// An array whose numbers follow all the XML.
struct Appended {
  std::size_t tagEnd = 0;
  Index offset = 0;
  bool mayBeEmpty = false;
};

class VtpCheck {
 public:
  VtpCheck(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  void run()
  {
    std::size_t at = 0;
    while (const auto tag = nextTag(bytes_, at)) {
      at = tag->end;
      readTag(*tag);
      if (tag->name == "AppendedData") break;
    }
    for (const Block& block : blocks_) checkBlock(block);
  }

 private:
  void readTag(const XmlTag& tag);
  void readFile(const XmlTag& tag);
  void readPiece(const XmlTag& tag);
  void readArray(const XmlTag& tag);
  void readAppended(const XmlTag& tag);
  void checkBlock(const Block& block) const;
  [[nodiscard]] Index whole(const XmlTag& tag, std::string_view name, Index low, Index high) const;
  [[nodiscard]] std::vector<std::uint64_t> words(const Block& block, std::size_t count) const;
  [[nodiscard]] Index valueLimit() const
  {
    // A bit is the least that a value takes.
    return 8 * static_cast<Index>(bytes_.size()) * (isCompressed_ ? kBestCompression : 1);
  }
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const;

  std::string_view bytes_;
  const std::string& file_;
  bool isCompressed_ = false;
  bool isBigEndian_ = false;
  std::size_t wordSize_ = 4;
  std::vector<Block> blocks_;
  std::map<std::string_view, Index> tuplesIn_;  // of the arrays in each part of the current piece
  Index tuples_ = 0;                            // of the arrays in the current part
  std::vector<Appended> appended_;
};

void VtpCheck::fail(std::size_t at, const std::string& reason) const
{
  const std::string_view before = bytes_.substr(0, at);
  throw InputError({file_, std::count(before.begin(), before.end(), '\n') + 1, ""},
                   reason + "; the file is damaged, write it anew");
}

Index VtpCheck::whole(const XmlTag& tag, std::string_view name, Index low, Index high) const
{
  const auto text = tag.attribute(name);
  if (!text) return low;
  Index value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc() || end != text->data() + text->size() || value < low || value > high)
    fail(tag.end, std::string(name) + " is '" + std::string(*text) + "' and must be a whole number from " +
                      std::to_string(low) + " to " + std::to_string(high) + " in a file of this size");
  return value;
}

void VtpCheck::readTag(const XmlTag& tag)
{
  if (tag.name == "VTKFile") readFile(tag);
  if (tag.name == "Piece") readPiece(tag);
  if (const auto part = tuplesIn_.find(tag.name); part != tuplesIn_.end()) tuples_ = part->second;
  if (tag.name == "DataArray" || tag.name == "Array") readArray(tag);
  if (tag.name == "AppendedData") readAppended(tag);
}

void VtpCheck::readFile(const XmlTag& tag)
{
  isCompressed_ = tag.attribute("compressor").value_or("") != "";
  isBigEndian_ = tag.attribute("byte_order") == "BigEndian";
  wordSize_ = tag.attribute("header_type") == "UInt64" ? 8 : 4;
}

void VtpCheck::readPiece(const XmlTag& tag)
{
  const Index points = whole(tag, "NumberOfPoints", 0, valueLimit());
  const Index verts = whole(tag, "NumberOfVerts", 0, valueLimit());
  const Index lines = whole(tag, "NumberOfLines", 0, valueLimit());
  const Index strips = whole(tag, "NumberOfStrips", 0, valueLimit());
  const Index polys = whole(tag, "NumberOfPolys", 0, valueLimit());
  tuplesIn_ = {{"PointData", points}, {"Points", points}, {"CellData", verts + lines + strips + polys},
               {"Verts", verts},      {"Lines", lines},   {"Strips", strips},
               {"Polys", polys}};
}

void VtpCheck::readArray(const XmlTag& tag)
{
  const Index tuples = std::max(tuples_, whole(tag, "NumberOfTuples", 0, valueLimit()));
  (void)whole(tag, "NumberOfComponents", 1, std::max<Index>(1, valueLimit() / std::max<Index>(1, tuples)));
  const auto format = tag.attribute("format").value_or("ascii");
  if (format == "appended")
    appended_.push_back({tag.end, whole(tag, "offset", 0, static_cast<Index>(bytes_.size())), tuples == 0});
  else if (format == "binary")
    blocks_.push_back({bytes_.find_first_not_of(" \t\r\n", tag.end), true, tuples == 0});
}

void VtpCheck::readAppended(const XmlTag& tag)
{
  const bool isBase64 = tag.attribute("encoding") == "base64";
  const std::size_t begin = bytes_.find('_', tag.end);
  if (begin == std::string_view::npos) fail(tag.end, "the appended data do not begin with an underscore");
  for (const Appended& array : appended_) {
    const std::size_t place = begin + 1 + array.offset;
    if (place >= bytes_.size()) fail(array.tagEnd, "the data of this array would begin past the end of the file");
    blocks_.push_back({place, isBase64, array.mayBeEmpty});
  }
}

/// The first `count` words at a block's begin, which are the header of its data.
std::vector<std::uint64_t> VtpCheck::words(const Block& block, std::size_t count) const
{
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t size = count * wordSize_;
  const std::size_t stored = block.isBase64 ? (size * 8 + 5) / 6 : size;
  if (block.begin > bytes_.size() || stored > bytes_.size() - block.begin)
    fail(std::min(block.begin, bytes_.size()), "the file ends in the header of an array");

  std::string header(bytes_.substr(block.begin, stored));
  if (block.isBase64) {
    std::string decoded;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < stored; ++i) {
      const std::size_t digit = kDigits.find(header[i]);
      if (digit == std::string_view::npos) fail(block.begin + i, "there is no base64 text where data should be");
      bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFU;
      if (i % 4 != 0) decoded.push_back(static_cast<char>(bits >> (6 - 2 * (i % 4)) & 0xFFU));
    }
    header = decoded;
  }
  std::vector<std::uint64_t> result(count, 0);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = i % wordSize_;
    const std::size_t shift = 8 * (isBigEndian_ ? wordSize_ - 1 - place : place);
    result[i / wordSize_] |= std::uint64_t{static_cast<unsigned char>(header[i])} << shift;
  }
  return result;
}

/// Uncompressed: the size of the data. Compressed: how many blocks, size of a block and of the last one before
/// compression, then the size of each after it.
void VtpCheck::checkBlock(const Block& block) const
{
  const std::uint64_t left = bytes_.size() - std::min(block.begin, bytes_.size());
  if (!isCompressed_) {
    if (words(block, 1)[0] > left) fail(block.begin, "an array claims more bytes than the file has left");
    return;
  }
  const auto start = words(block, 3);
  if (start[0] > left / wordSize_) fail(block.begin, "an array claims more compressed blocks than the file has left");
  if (start[0] == 0 && !block.mayBeEmpty) fail(block.begin, "an array that cannot be empty has no data");
  const auto limit = static_cast<std::uint64_t>(valueLimit());
  if (start[0] > 0 && (start[1] == 0 || start[1] > limit || start[2] > start[1]))
    fail(block.begin, "the blocks of a compressed array have impossible sizes");
  const auto header = words(block, 3 + start[0]);
  std::uint64_t total = 0;
  for (std::size_t i = 3; i < header.size(); ++i) {
    if (header[i] > left) fail(block.begin, "a compressed block is larger than what is left of the file");
    total += header[i];
  }
  if (total > left) fail(block.begin, "an array claims more compressed bytes than the file has left");
}

}  // namespace

void requireSoundVtp(std::string_view bytes, const std::string& file)
{
  VtpCheck(bytes, file).run();
}

}  // namespace holdfast
