#include "holdfast/io/formats/block_compressor.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

namespace holdfast {
namespace {

const std::uint8_t* unsignedBytes(std::string_view text)
{
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

std::uint8_t* unsignedBytes(char* bytes)
{
  return reinterpret_cast<std::uint8_t*>(bytes);
}

/// `isDone` is false where the memory is too small.
std::string compressedText(std::string text, std::size_t size, bool isDone)
{
  if (!isDone) throw std::bad_alloc();
  text.resize(size);
  return text;
}

std::string compressByZlib(std::string_view block)
{
  uLongf size = ::compressBound(block.size());
  std::string text(size, '\0');
  const int status = ::compress(unsignedBytes(text.data()), &size, unsignedBytes(block), block.size());
  return compressedText(std::move(text), size, status == Z_OK);
}

bool uncompressByZlib(std::string_view stored, char* block, std::uint64_t size)
{
  uLongf got = size;
  return ::uncompress(unsignedBytes(block), &got, unsignedBytes(stored), stored.size()) == Z_OK && got == size;
}

std::string compressByLz4(std::string_view block)
{
  const int size = static_cast<int>(block.size());
  std::string text(static_cast<std::size_t>(LZ4_compressBound(size)), '\0');
  const int got = LZ4_compress_default(block.data(), text.data(), size, static_cast<int>(text.size()));
  return compressedText(std::move(text), static_cast<std::size_t>(got), got > 0);
}

bool uncompressByLz4(std::string_view stored, char* block, std::uint64_t size)
{
  if (std::max<std::uint64_t>(stored.size(), size) > LZ4_MAX_INPUT_SIZE) return false;
  const int got = LZ4_decompress_safe(stored.data(), block, static_cast<int>(stored.size()), static_cast<int>(size));
  return got >= 0 && static_cast<std::uint64_t>(got) == size;
}

std::string compressByLzma(std::string_view block)
{
  std::string text(lzma_stream_buffer_bound(block.size()), '\0');
  std::size_t size = 0;
  const lzma_ret status = lzma_easy_buffer_encode(LZMA_PRESET_DEFAULT, LZMA_CHECK_CRC32, nullptr, unsignedBytes(block),
                                                  block.size(), unsignedBytes(text.data()), &size, text.size());
  return compressedText(std::move(text), size, status == LZMA_OK);
}

bool uncompressByLzma(std::string_view stored, char* block, std::uint64_t size)
{
  std::uint64_t mostMemory = std::uint64_t{128} << 20U;  // the strongest preset needs 65 MiB
  std::size_t read = 0;
  std::size_t written = 0;
  return lzma_stream_buffer_decode(&mostMemory, 0, nullptr, unsignedBytes(stored), &read, stored.size(),
                                   unsignedBytes(block), &written, size) == LZMA_OK &&
         written == size;
}

constexpr std::array kCompressors{BlockCompressor{"vtkZLibDataCompressor", compressByZlib, uncompressByZlib},
                                  BlockCompressor{"vtkLZ4DataCompressor", compressByLz4, uncompressByLz4},
                                  BlockCompressor{"vtkLZMADataCompressor", compressByLzma, uncompressByLzma}};

}  // namespace

const BlockCompressor* findCompressor(std::string_view name)
{
  const auto* const found = std::ranges::find(kCompressors, name, &BlockCompressor::name);
  return found == kCompressors.end() ? nullptr : &*found;
}

std::optional<std::string> uncompressed(const BlockCompressor& compressor, std::string_view stored, std::uint64_t size)
{
  // Not a text, which would be filled at once.
  const auto block = std::make_unique_for_overwrite<char[]>(size);
  if (!compressor.uncompress(stored, block.get(), size)) return std::nullopt;
  return std::string(block.get(), size);
}

}  // namespace holdfast
