#pragma once
/// These functions read and write the mesh formats. `file` names the file in errors. Every reader throws `InputError`
/// with the line (text) or the byte (binary). It keeps all that the file says besides the mesh.

#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

/// Reads Wavefront OBJ.
[[nodiscard]] MeshDocument readObj(std::string bytes, const std::string& file);

/// Reads the Object File Format, with one vertex or face a line. Its keyword may be OFF, COFF, NOFF, CNOFF, STOFF and
/// so on, in any case. The keyword may also be missing.
[[nodiscard]] MeshDocument readOff(std::string bytes, const std::string& file);

/// Reads PLY, as text or binary of either byte order. Where there are no faces, the triangles of the strips in
/// `tristrips` are the faces. Strips are separated by -1. A triangle has the corners k, k + 1, k + 2 of its strip, and
/// every second one is turned round. Triangles with two equal corners are left out.
[[nodiscard]] MeshDocument readPly(std::string bytes, const std::string& file);

/// Reads STL, which has three vertices for each facet. The file is binary if its size is what the count of facets calls
/// for, whatever the first bytes say. Where the count was never filled in (0 or 2^32 - 1), the size gives it. Facets
/// may have payloads of as many bytes as their attributes say.
[[nodiscard]] MeshDocument readStl(std::string bytes, const std::string& file);

/// Reads XML PolyData of VTK (VTP) in each of its encodings. Its polygons are the faces, those of all pieces one after
/// the other, and behind them the triangles of its strips. Throws also where the file has steps of time, and where an
/// array is not whole. All arrays together take no more bytes than the file has, so that memory is bounded by what
/// compression explains. O(bytes, uncompressed).
[[nodiscard]] MeshDocument readVtp(std::string bytes, const std::string& file);

/// Throws the `InputError` of `readStl` where `head` shows already that the file cannot be STL. `head` is the beginning
/// of a file of `size` bytes. O(size of `head`).
void checkStlHead(std::string_view head, std::uintmax_t size, const std::string& file);

/// Throws the `InputError` of `readPly` where `head`, the beginning of a file, shows already that the file cannot be
/// PLY. O(size of `head`).
void checkPlyHead(std::string_view head, const std::string& file);

/// Throws an `InputError` where `head`, the beginning of a file, shows already that the file cannot be VTP. O(size of
/// `head`).
void checkVtpHead(std::string_view head, const std::string& file);

/// These functions make files of the faces of `rest` and of other positions alone. PLY is binary little-endian with
/// doubles. STL is binary. It has the triangles that `triangulate` makes of `rest`, which are those that the solver
/// sees. VTP is appended raw binary with doubles, legacy VTK (.vtk) is binary with doubles. Notes say what was rounded
/// and split. Every face of `rest` has three corners or more.
[[nodiscard]] Serialized writeObj(const Mesh& rest, const Positions& positions);
[[nodiscard]] Serialized writeOff(const Mesh& rest, const Positions& positions);
[[nodiscard]] Serialized writePly(const Mesh& rest, const Positions& positions);
[[nodiscard]] Serialized writeStl(const Mesh& rest, const Positions& positions);
[[nodiscard]] Serialized writeVtp(const Mesh& rest, const Positions& positions);
[[nodiscard]] Serialized writeVtk(const Mesh& rest, const Positions& positions);

/// Returns what STL holds of `positions`, and adds a note on what it loses. Throws `OutputError` where a coordinate is
/// too large for a float.
[[nodiscard]] Positions storedInStl(const Positions& positions, std::vector<std::string>& notes);

/// What follows serves the readers. A file is written again as the bytes that were read, with other numbers in the
/// places of coordinates and normals.

enum class NumberType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

/// Returns how many bytes a number takes in a binary file.
[[nodiscard]] constexpr std::size_t sizeOf(NumberType type)
{
  return std::array<std::size_t, 8>{1, 1, 2, 2, 4, 4, 4, 8}[static_cast<std::size_t>(type)];
}

[[nodiscard]] constexpr bool isInteger(NumberType type)
{
  return type < NumberType::Float;
}

/// A number place tells where a file says the three numbers of a vertex or of a stored normal, or one of them.
struct NumberPlace {
  std::size_t offset = 0;  ///< in a text: before the blanks in front of the first number
  Index number = 0;        ///< 3 v + k for coordinate k of vertex v, -1 - (3 n + k) for that of normal n
};

/// Returns what `FileLayout` and `NumberPlace` call component `k` of normal `n`.
[[nodiscard]] constexpr Index normalNumber(Index n, Index k = 0)
{
  return -1 - (3 * n + k);
}

/// A normal reference tells where a corner of a face names its normal.
struct NormalReference {
  std::size_t offset = 0;
  std::size_t size = 0;     ///< 0 where it names none
  bool isRelative = false;  ///< it counts back from its line
  Index above = 0;          ///< how many normals the file has before its line
};

/// A layout tells where a file says what may change.
struct FileLayout {
  std::string extension;
  TextDialect dialect;
  std::vector<std::string> extras;            ///< see `MeshSource::extras`
  std::optional<std::endian> byteOrder = {};  ///< none in a text
  std::array<NumberType, 3> coordinateTypes{NumberType::Double, NumberType::Double, NumberType::Double};
  std::array<NumberType, 3> normalTypes = coordinateTypes;
  bool areTogether = true;                ///< each place has three numbers; else one
  std::vector<NumberPlace> numbers = {};  ///< ascending
  std::vector<int> normalOfCorner = {};   ///< of each corner of the faces: its stored normal, or -1
  /// Returns the reference of each corner of the faces of a file, in their order. The pointer is null where the format
  /// has no such references.
  std::vector<NormalReference> (*referencesIn)(std::string_view bytes) = nullptr;
  Index normalCount = 0;
  std::vector<std::size_t> typeWords = {};      ///< where a header names types of coordinates that become double
  std::vector<std::string> notesOfMotion = {};  ///< what is to be said where a vertex moves
  std::vector<std::string> remarks = {};        ///< see `MeshDocument::remarks`
  /// Rounds positions as the format stores them, and notes what that loses. What it returns is written: as text in its
  /// shortest form, in binary files as single precision. The pointer is null where the format holds doubles.
  Positions (*stored)(const Positions& positions, std::vector<std::string>& notes) = nullptr;
};

/// Makes the document of a file that says `mesh`.
[[nodiscard]] MeshDocument makeDocument(std::string bytes, FileLayout layout, Mesh mesh);

}  // namespace holdfast
