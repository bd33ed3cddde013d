#pragma once
/// Numbers over the points or the faces of a mesh.

#include <string>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// One array over the points or the faces of a mesh.
struct Field {
  std::string name;            ///< unique among its kind, not empty
  Index components = 1;        ///< numbers a point or face: 1 for scalars, 3 for vectors
  std::vector<double> values;  ///< those of one point or face side by side: `components` times their count
};

}  // namespace holdfast
