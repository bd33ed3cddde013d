#pragma once
/// A VTP file stores the numbers of an array in a block. The block says how many bytes follow, and has these bytes.
/// They may be compressed in parts (VTK File Formats, "XML File Formats").

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/io/formats/block_compressor.h>

namespace holdfast {

/// An encoding says how a file stores its blocks.
struct VtpEncoding {
  std::endian order = std::endian::little;
  bool hasLongHeaders = false;                  ///< sizes take eight bytes each, not four
  const BlockCompressor* compressor = nullptr;  ///< null where nothing is compressed
};

/// This is thrown for a fault of an array. The caller knows its element and adds the place.
class VtpFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Encoded bytes are bytes of a file, plain or as base64 text.
class EncodedBytes {
 public:
  EncodedBytes(std::string_view text, bool isBase64) : text_(text), isBase64_(isBase64) {}

  /// Returns the first `count` bytes. Throws `VtpFault` where they are not there.
  [[nodiscard]] std::string first(std::uint64_t count) const;
  /// Returns all after the first `count` bytes, which were encoded on their own.
  [[nodiscard]] EncodedBytes after(std::uint64_t count) const { return {text_.substr(sizeOf(count)), isBase64_}; }
  /// Throws `VtpFault` where `count` things of a byte or more cannot be here. Sums of what passes do not overflow.
  void requireHeld(std::uint64_t count) const;
  /// Returns how much of the text `count` bytes take.
  [[nodiscard]] std::uint64_t sizeOf(std::uint64_t count) const;

 private:
  std::string_view text_;
  bool isBase64_;
};

/// A block is a part of a file, whose sizes have been read.
class VtpBlock {
 public:
  /// Reads the sizes at the beginning of `text`, which outlives this. Throws `VtpFault` where they claim more than the
  /// text has.
  VtpBlock(std::string_view text, bool isBase64, const VtpEncoding& encoding);

  /// Returns how much of the text the block takes.
  [[nodiscard]] std::uint64_t size() const;
  /// Returns how many bytes of the file its data take.
  [[nodiscard]] std::uint64_t dataSize() const { return dataSize_; }
  /// Returns the data, uncompressed. Throws `VtpFault` where they are not there, damaged, or claim a size that no
  /// compression explains.
  [[nodiscard]] std::string data() const;
  /// Returns how many bytes are compressed at a time. It is 0 where the block does not say.
  [[nodiscard]] std::uint64_t partSize() const { return sizes_.size() > 1 ? sizes_[1] : 0; }

 private:
  [[nodiscard]] std::vector<std::uint64_t> words(std::uint64_t count) const;
  [[nodiscard]] std::uint64_t wordSize() const { return encoding_.hasLongHeaders ? 8 : 4; }
  [[nodiscard]] std::string compressedData() const;

  EncodedBytes bytes_;
  VtpEncoding encoding_;
  /// The size of the data. With compression: how many parts, the size of a part, that of the last one (0: the same),
  /// then the size of each when compressed.
  std::vector<std::uint64_t> sizes_;
  std::uint64_t dataSize_ = 0;
};

/// Returns `data` as a block. Where the file compresses, the parts have `partSize` bytes, or the usual number where
/// this is 0. They have whole numbers of eight bytes. Throws `VtpFault` where the sizes of the file are too short for
/// so many data.
[[nodiscard]] std::string toVtpBlock(std::string_view data, bool isBase64, const VtpEncoding& encoding,
                                     std::uint64_t partSize);

}  // namespace holdfast
