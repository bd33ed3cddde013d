#pragma once
/// \file
/// The meshes that are measured on: generated ones always, well-known ones where the mesh library has them.

#include <functional>
#include <string>
#include <vector>

#include <holdfast/deform/model.h>

namespace holdfast::bench {

/// A mesh that is made or read when it is asked for.
struct BenchMesh {
  std::string name;     ///< "bumpy 35k"
  Index thousands = 0;  ///< of vertices: 35, 173 or 438
  std::function<Model()> load;
};

/// The generated meshes of about 35,000, 173,000 and 438,000 vertices, then those of the library.
[[nodiscard]] std::vector<BenchMesh> benchMeshes();

/// Those of at most so many thousand vertices.
[[nodiscard]] std::vector<BenchMesh> benchMeshesUpTo(Index thousands);

/// The generated one of 173,000 vertices.
[[nodiscard]] Model middleModel();

}  // namespace holdfast::bench
