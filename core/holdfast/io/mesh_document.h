#pragma once
/// A mesh together with all that its file said besides, so that it can be written back as the same file with other
/// positions.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Contents of a file ready to be written.
struct Serialized {
  std::string bytes;
  std::vector<std::string> notes;  ///< what the user should know: "120 normals recomputed"
  bool isSinglePrecision = false;  ///< coordinates are stored as floats
};

/// What a mesh file said: the whole file, in the form that its format needs to be written again.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  /// Of the format, lower case with the dot: ".obj".
  [[nodiscard]] virtual std::string extension() const = 0;

  /// Whether numbers are written in digits.
  [[nodiscard]] virtual bool isText() const { return false; }

  /// The file as it was read, with `positions` (as many rows) in place of its own, which `rest` has with its faces.
  /// Normals are kept at corners of faces that did not move; elsewhere they are recomputed or dropped, and a note says
  /// which. Doubles read back bit for bit in formats that can hold them. Throws `OutputError` where a coordinate is too
  /// large for the format.
  [[nodiscard]] virtual Serialized withPositions(const Mesh& rest, const Positions& positions) const = 0;

  /// What another format would lose, in the words of a message: "texture coordinates", "groups".
  [[nodiscard]] virtual std::vector<std::string> extras() const = 0;

 protected:
  MeshSource() = default;
  MeshSource(const MeshSource&) = default;
  MeshSource& operator=(const MeshSource&) = default;
};

/// A mesh as read from a file, or made in memory (`source` null).
struct MeshDocument {
  Mesh mesh;
  std::shared_ptr<const MeshSource> source;
  /// Sentences about what is odd in the file, what was made of it, and what to look at. The file is written back with
  /// all of it.
  std::vector<std::string> remarks = {};
};

}  // namespace holdfast
