#pragma once
/// \file
/// Positions and faces of mesh files by readers of a few lines each, which share nothing with the readers under test.
/// They believe what a file says: for judging outputs, not for strangers' files.

#include <array>
#include <filesystem>
#include <vector>

namespace holdfast::test {

using PlainPoint = std::array<double, 3>;

struct PlainMesh {
  std::vector<PlainPoint> positions;
  std::vector<std::vector<long>> faces;  ///< vertex ids from 0
};

/// Reads OBJ, OFF, STL (text and binary) and PLY (text and little endian binary) by the extension. Throws
/// `std::runtime_error` for what it does not understand.
[[nodiscard]] PlainMesh readPlainMesh(const std::filesystem::path& path);

/// The length of the diagonal of the bounding box.
[[nodiscard]] double diagonalOf(const PlainMesh& mesh);

}  // namespace holdfast::test
