#pragma once
/// A document keeps a mesh together with all that its file said besides. So it can be written back as the same file
/// with other positions.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// The contents of a file, ready to be written.
struct Serialized {
  std::string bytes;
  std::vector<std::string> notes;        ///< what the user should know: "120 normals recomputed"
  std::optional<Positions> stored = {};  ///< what a reader finds, where the format rounds positions
};

/// A source keeps the whole file that a mesh came from, in the form that its format needs to write it again.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  /// Returns the extension of the format, in lower case with the dot: ".obj".
  [[nodiscard]] virtual std::string extension() const = 0;

  /// Tells whether the file writes numbers in digits.
  [[nodiscard]] virtual bool isText() const { return false; }

  /// Returns the file as it was read, with `positions` in place of its own. `rest` is the mesh of the file, and
  /// `positions` has as many rows. Normals are kept at corners of faces that did not move. Elsewhere they are
  /// recomputed or dropped, and a note says which. Doubles read back bit for bit in formats that can hold them. Throws
  /// `OutputError` where a coordinate is too large for the format.
  [[nodiscard]] virtual Serialized withPositions(const Mesh& rest, const Positions& positions) const = 0;

  /// Names what another format would lose, in the words of a message: "texture coordinates", "groups".
  [[nodiscard]] virtual std::vector<std::string> extras() const = 0;

 protected:
  MeshSource() = default;
  MeshSource(const MeshSource&) = default;
  MeshSource& operator=(const MeshSource&) = default;
};

/// A mesh that was read from a file, or made in memory: then `source` is null.
struct MeshDocument {
  Mesh mesh;
  std::shared_ptr<const MeshSource> source;
  /// Each sentence says what is odd in the file, what was made of it, and what to look at. The file is written back
  /// with all that is odd in it.
  std::vector<std::string> remarks = {};
};

}  // namespace holdfast
