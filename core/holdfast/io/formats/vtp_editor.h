#pragma once
/// An editor gives arrays of a VTP file other numbers, and keeps all other bytes of the file.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/io/formats/vtp_array.h>

namespace holdfast {

/// An editor collects edits of one file, and makes the new file of them at the end.
class VtpEditor {
 public:
  /// `file` outlives this.
  explicit VtpEditor(const VtpFile& file) : file_(file) {}

  /// Gives an array these vectors, of which it has as many. The array keeps its format and its compression. Ranges that
  /// it states follow. In text, words that say the same number stay as they are. Throws `VtpFault` where the sizes of
  /// the file are too short for the new data.
  void replace(const XmlElement& array, std::span<const double> values, VtpReal type);

  /// Returns the new file. Blocks of appended data behind longer ones move, and the XML says where they begin. A block
  /// that another array has too stays, and the new block goes behind all others.
  [[nodiscard]] std::string finish();

 private:
  /// The block of an array in appended data.
  struct Block {
    const XmlElement* array;
    std::size_t begin;
    std::size_t end;
    const std::string* replacement;  ///< null where it stays
    bool isShared = false;           ///< another array has a part of it
  };

  void set(const XmlElement& element, std::string_view name, std::string value);
  void setRanges(const XmlElement& array, std::span<const double> values);
  void replaceNumbers(const XmlElement& array, std::span<const double> values, VtpReal type);
  void replaceText(const XmlElement& element, std::string replacement);
  [[nodiscard]] std::string newBlock(const VtpBlock& old, bool isBase64, std::span<const double> values,
                                     VtpReal type) const;
  void addBlocks(const XmlElement& element, std::vector<Block>& blocks) const;
  void addBlock(const XmlElement& array, std::vector<Block>& blocks) const;
  [[nodiscard]] std::vector<Block> blocksByPlace() const;
  void moveBlocks();
  void put(const Block& block, std::size_t begin, std::size_t size);

  const VtpFile& file_;
  std::vector<TextEdit> edits_;
  std::map<const XmlElement*, std::string> newBlocks_;  ///< of arrays in appended data
  std::size_t added_ = 0;                               ///< bytes before the next block, less those that are gone
};

}  // namespace holdfast
