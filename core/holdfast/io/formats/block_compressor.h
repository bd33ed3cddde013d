#pragma once
/// These compressors are those that VTK's files name: zlib, LZ4 and LZMA.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace holdfast {

/// A compressor compresses blocks of data, each on its own.
struct BlockCompressor {
  std::string_view name;  ///< that of VTK's class
  std::string (*compress)(std::string_view block);
  /// Writes what `stored` says to `block`, which has room for `size` bytes. Tells whether they are exactly so many.
  bool (*uncompress)(std::string_view stored, char* block, std::uint64_t size);
};

/// Returns the compressor of that name, or null. It lives as long as the program.
[[nodiscard]] const BlockCompressor* findCompressor(std::string_view name);

/// Returns the block of `size` bytes that `stored` says. There is none where `stored` is damaged or says a block of
/// another size. Memory that `size` only claims is not touched. O(size).
[[nodiscard]] std::optional<std::string> uncompressed(const BlockCompressor& compressor, std::string_view stored,
                                                      std::uint64_t size);

}  // namespace holdfast
