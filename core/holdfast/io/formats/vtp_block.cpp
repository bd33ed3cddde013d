#include "holdfast/io/formats/vtp_block.h"

#include <algorithm>
#include <limits>

#include <holdfast/io/text/base64.h>
#include <holdfast/io/text/byte_order.h>

namespace holdfast {
namespace {

/// No compressor of VTK's makes more bytes of one than this (LZMA, on zeros).
constexpr std::uint64_t kBestCompression = 8192;

/// Of the sizes of a compressed block: those before the size of each part.
constexpr std::uint64_t kPartsBegin = 3;

constexpr std::uint64_t kUsualPart = 32768;
constexpr std::uint64_t kLargestPart = std::uint64_t{1} << 30U;  // LZ4 counts in 31 bits

[[noreturn]] void failCutShort()
{
  throw VtpFault("its data are cut short");
}

std::string encodedBytes(std::string&& bytes, bool isBase64)
{
  return isBase64 ? toBase64(bytes) : std::move(bytes);
}

std::string headerOf(const std::vector<std::uint64_t>& sizes, const VtpEncoding& encoding)
{
  std::string header;
  for (const std::uint64_t size : sizes) {
    if (!encoding.hasLongHeaders && size > std::numeric_limits<std::uint32_t>::max())
      throw VtpFault("its data are more than the 32-bit sizes of this file can count: write PLY, OBJ or OFF");
    header += encoding.hasLongHeaders ? toBytes(size, encoding.order)
                                      : toBytes(static_cast<std::uint32_t>(size), encoding.order);
  }
  return header;
}

std::string compressedBlock(std::string_view data, bool isBase64, const VtpEncoding& encoding, std::uint64_t partSize)
{
  const std::uint64_t part = partSize == 0 ? kUsualPart : (std::min(partSize, kLargestPart) + 7) / 8 * 8;
  std::vector<std::uint64_t> sizes{(data.size() + part - 1) / part, part, data.size() % part};
  std::string parts;
  for (std::size_t at = 0; at < data.size(); at += part) {
    const std::string compressed = encoding.compressor->compress(data.substr(at, part));
    sizes.push_back(compressed.size());
    parts += compressed;
  }
  return encodedBytes(headerOf(sizes, encoding), isBase64) + encodedBytes(std::move(parts), isBase64);
}

}  // namespace

std::string EncodedBytes::first(std::uint64_t count) const
{
  requireHeld(count);
  if (sizeOf(count) > text_.size()) failCutShort();
  if (!isBase64_) return std::string(text_.substr(0, count));
  std::optional<std::string> bytes = fromBase64(text_, count);
  if (!bytes) throw VtpFault("its data are no base64 text");
  return *std::move(bytes);
}

void EncodedBytes::requireHeld(std::uint64_t count) const
{
  if (count > text_.size()) failCutShort();
}

std::uint64_t EncodedBytes::sizeOf(std::uint64_t count) const
{
  return isBase64_ ? base64Size(count) : count;
}

VtpBlock::VtpBlock(std::string_view text, bool isBase64, const VtpEncoding& encoding)
    : bytes_(text, isBase64), encoding_(encoding)
{
  if (encoding_.compressor == nullptr) {
    sizes_ = words(1);
    dataSize_ = sizes_[0];
    bytes_.requireHeld(dataSize_);
    return;
  }
  const std::uint64_t parts = words(kPartsBegin)[0];
  bytes_.requireHeld(parts);
  sizes_ = words(kPartsBegin + parts);
  for (std::uint64_t k = 0; k < parts; ++k) {
    bytes_.requireHeld(sizes_[kPartsBegin + k]);
    dataSize_ += sizes_[kPartsBegin + k];
  }
}

/// Sizes that wrap are none: `count` is no more than the file has bytes.
std::vector<std::uint64_t> VtpBlock::words(std::uint64_t count) const
{
  const std::string bytes = bytes_.first(count * wordSize());
  std::vector<std::uint64_t> result;
  for (std::string_view left = bytes; !left.empty(); left.remove_prefix(wordSize()))
    result.push_back(encoding_.hasLongHeaders ? fromBytes<std::uint64_t>(left.substr(0, 8), encoding_.order)
                                              : fromBytes<std::uint32_t>(left.substr(0, 4), encoding_.order));
  return result;
}

std::uint64_t VtpBlock::size() const
{
  const std::uint64_t header = sizes_.size() * wordSize();
  if (encoding_.compressor == nullptr) return bytes_.sizeOf(header + dataSize_);
  return bytes_.sizeOf(header) + bytes_.sizeOf(dataSize_);
}

std::string VtpBlock::data() const
{
  if (encoding_.compressor != nullptr) return compressedData();
  return bytes_.first(wordSize() + dataSize_).erase(0, wordSize());
}

std::string VtpBlock::compressedData() const
{
  const std::string stored = bytes_.after(sizes_.size() * wordSize()).first(dataSize_);
  std::string result;
  std::string_view left = stored;
  for (std::size_t k = kPartsBegin; k < sizes_.size(); ++k) {
    const std::uint64_t size = k + 1 == sizes_.size() && sizes_[2] > 0 ? sizes_[2] : sizes_[1];
    if (size / kBestCompression > sizes_[k]) throw VtpFault("a compressed block of its data claims too large a size");
    const std::optional<std::string> part = uncompressed(*encoding_.compressor, left.substr(0, sizes_[k]), size);
    if (!part) throw VtpFault("a compressed block of its data is damaged");
    result += *part;
    left.remove_prefix(sizes_[k]);
  }
  return result;
}

std::string toVtpBlock(std::string_view data, bool isBase64, const VtpEncoding& encoding, std::uint64_t partSize)
{
  if (encoding.compressor != nullptr) return compressedBlock(data, isBase64, encoding, partSize);
  return encodedBytes(headerOf({data.size()}, encoding) + std::string(data), isBase64);
}

}  // namespace holdfast
