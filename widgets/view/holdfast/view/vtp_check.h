#pragma once
/// \file
/// A look at XML PolyData before VTK reads it. VTK's reader finds most damage itself, but believes counts, offsets and
/// the sizes of compressed blocks, and reads past its buffers where they are wrong.

#include <string>
#include <string_view>

namespace holdfast {

/// Throws `InputError` about `file`, with the line, where a count, a number of components, the place of an array or the
/// header of a block of data in `bytes` cannot be right. Malformed XML is left to VTK. O(XML text + arrays).
void requireSoundVtp(std::string_view bytes, const std::string& file);

}  // namespace holdfast
