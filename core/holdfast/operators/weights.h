#pragma once
/// \file
/// The weights of the Laplacian, by name.

#include <string_view>

namespace holdfast {

/// The weights w_ij of the Laplacian, equations (1) to (3). With both kinds of cotangents L p is that of (10). On a
/// smooth surface that is twice the mean curvature along the normal.
enum class Weights {
  Cotangent,       ///< (10) with guarded cotangents and mixed Voronoi areas, rows scaled to the integrated energy
  CotangentPaper,  ///< cotangents as printed in (10)
  Uniform          ///< (9), uniform weights 1 / n_i
};

/// Returns the name of the weights in files and options: "cotangent", "cotangent-paper", "uniform".
[[nodiscard]] std::string_view name(Weights weights);

}  // namespace holdfast
