#pragma once
/// A field is numbers over the points or the faces of a mesh.

#include <string>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A field holds one array over the points or the faces of a mesh.
struct Field {
  std::string name;            ///< unique among its kind, not empty
  Index components = 1;        ///< how many numbers each point or face has: 1 for scalars, 3 for vectors
  std::vector<double> values;  ///< `components` numbers for each point or face, side by side
};

}  // namespace holdfast
