#pragma once
/// \file
/// Q of a sparse QR as the product of its Householder reflections, and its columns one by one, each as sparse as it is.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// Q = P^T H_1 H_2 ... H_k with H_j = I - tau_j h_j h_j^T and (P x)_place(i) = x_i.
struct HouseholderVectors {
  SparseMatrix h;            ///< m x k
  Eigen::VectorXd tau;       ///< k
  std::vector<Index> place;  ///< m: row i of Q is row place[i] of the product
};

/// Q, m x m. Each column meets only the reflections that share a row with what it has become: time and memory go with
/// the entries of Q, not with m^2.
[[nodiscard]] SparseMatrix explicitQ(const HouseholderVectors& vectors);

}  // namespace holdfast
