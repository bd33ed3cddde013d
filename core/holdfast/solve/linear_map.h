#pragma once
/// The matrix C of min |C z - f|, as factorisations and corrections need it.

#include <functional>
#include <memory>
#include <type_traits>

#include <holdfast/matrices/sparse_products.h>

namespace holdfast {

/// A view of a matrix, or of a product of matrices. The product is made only where it is factorised by QR.
struct LinearMap {
  std::function<Columns3(const Columns3& z)> times;                        ///< C z
  std::function<Columns3(const Columns3& f, const Columns3& z)> residual;  ///< f - C z
  std::function<Columns3(const Columns3& f)> transposeTimes;               ///< C^T f
  std::function<SparseMatrix()> gramLower;                                 ///< the lower triangle of C^T C
  std::function<std::shared_ptr<const TwoWayMatrix>()> matrix;             ///< C

  /// `C` has these functions, or is a matrix. It must stay alive as long as this.
  template <class Map>
  LinearMap(const Map& C)
      : times([&C](const Columns3& z) { return C.times(z); }),
        residual([&C](const Columns3& f, const Columns3& z) { return C.residual(f, z); }),
        transposeTimes([&C](const Columns3& f) { return C.transposeTimes(f); }),
        gramLower([&C] { return C.gramLower(); }),
        matrix([&C]() -> std::shared_ptr<const TwoWayMatrix> {
          if constexpr (std::is_same_v<Map, TwoWayMatrix>)
            return {std::shared_ptr<void>(), &C};
          else
            return C.matrix();
        })
  {
  }
};

}  // namespace holdfast
