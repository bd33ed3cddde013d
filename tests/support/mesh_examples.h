#pragma once
/// \file
/// One small mesh as a file of every format and variant, made without any of the code under test.

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast::test {

/// How coordinates stand in an example.
enum class Spelling {
  AsRead,     ///< as another program might have written them: "+1.5000", single precision
  AsWritten,  ///< as they must be written back: shortest text, double precision
};

/// A file with a square and a triangle beside it, both in the plane z = 0; every normal in it is (0, 0, 1).
struct MeshExample {
  std::string name;
  std::string extension;
  bool isText = false;
  bool holdsDoubles = true;
  Positions rest;
  Polygons faces;
  /// The whole file with these positions.
  std::function<std::string(const Positions& positions, Spelling spelling)> bytes;

  [[nodiscard]] std::string file() const { return bytes(rest, Spelling::AsRead); }
};

/// An example of every format and variant.
[[nodiscard]] const std::vector<MeshExample>& meshExamples();

std::ostream& operator<<(std::ostream& stream, const MeshExample& example);

}  // namespace holdfast::test
