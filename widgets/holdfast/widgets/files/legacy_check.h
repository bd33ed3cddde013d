#pragma once
/// \file
/// A look at legacy PolyData before VTK reads it. VTK's reader believes every count that a file states, and with a
/// damaged one it reads and writes past its buffers; what passes here it reads safely.

#include <string>
#include <string_view>

namespace holdfast {

/// Throws `InputError` about `file`, with the line in text files and the byte in binary ones, where `bytes` are not a
/// whole legacy PolyData file: a keyword or number is not what it must be, a count does not fit what follows, data
/// are missing. Takes no memory that grows with the counts. O(bytes).
void requireSoundLegacyFile(std::string_view bytes, const std::string& file);

}  // namespace holdfast
