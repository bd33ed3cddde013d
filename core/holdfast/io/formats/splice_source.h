#pragma once
/// Mesh files out again: the bytes that were read, with other numbers in the places of coordinates and normals.

#include <array>
#include <span>
#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

enum class Encoding { kText, kLittleEndian, kBigEndian };

/// Of a binary encoding.
[[nodiscard]] ByteOrder byteOrder(Encoding encoding);

enum class NumberType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// Bytes that a number takes in a binary file.
[[nodiscard]] std::size_t sizeOf(NumberType type);
[[nodiscard]] bool isInteger(NumberType type);

/// Where a file says the three numbers of a vertex or of a stored normal, or one of them.
struct NumberPlace {
  std::size_t offset = 0;  ///< in a text: before the blanks in front of the first number
  Index number = 0;        ///< 3 v + k for coordinate k of vertex v, -1 - (3 n + k) for that of normal n
};

/// What `FileLayout` and `NumberPlace` call component `k` of normal `n`.
[[nodiscard]] constexpr Index normalNumber(Index n, Index k = 0)
{
  return -1 - (3 * n + k);
}

/// Where a file says what may change.
struct FileLayout {
  std::string extension;
  TextDialect dialect;
  std::vector<std::string> extras;  ///< see `MeshSource::extras`
  Encoding encoding = Encoding::kText;
  std::array<NumberType, 3> coordinateTypes{NumberType::kDouble, NumberType::kDouble, NumberType::kDouble};
  std::array<NumberType, 3> normalTypes = coordinateTypes;
  bool areTogether = true;                 ///< each place has three numbers; else one
  std::vector<NumberPlace> numbers = {};   ///< ascending
  std::vector<Index> normalOfCorner = {};  ///< of each corner of the faces: its stored normal, or -1
  Index normalCount = 0;
  std::vector<std::size_t> typeWords = {};      ///< where a header names types of coordinates that become double
  std::vector<std::string> notesOfMotion = {};  ///< what is to be said where a vertex moves
  /// Coordinates are written as floats: notes what that loses.
  void (*noteRounding)(const Positions& positions, std::vector<std::string>& notes) = nullptr;
};

/// The document of a file that says `mesh`.
[[nodiscard]] MeshDocument makeDocument(std::string bytes, FileLayout layout, Mesh mesh);

/// New values for stored normals.
struct NormalUpdate {
  Positions normals;               ///< one row a stored normal; meaningful where `isNew`
  std::vector<bool> isNew;         ///< the others keep the value in the file
  std::vector<std::string> notes;  ///< how many were recomputed, and how many could not be
};

/// New values for the `count` stored normals of which corner c of `faces` uses `normalOfCorner[c]` (-1 for none):
/// area-weighted, for those with a moved vertex in one of the faces that use them. Where the area around a normal
/// vanishes, it keeps its old value.
[[nodiscard]] NormalUpdate updateNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                                         const Positions& before, const Positions& after);

}  // namespace holdfast
