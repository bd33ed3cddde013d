#pragma once
/// The numbers and matrices that every part of Holdfast speaks in.

#include <utility>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace holdfast {

/// The one index type, for vertices, faces, rows and columns. It is signed; ids count from 0 in file order.
using Index = Eigen::Index;

/// A place or a displacement in space, in model units.
using Vector3 = Eigen::Vector3d;

/// N x 3, one row a vertex, in model units. Row-major, so that a row is three doubles side by side as files and
/// renderers want them.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// n x 3: three right-hand sides or three solutions, side by side, so that a matrix is read once for all three.
using Columns3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Eigen's sparse matrix with 32-bit inner indices, as CHOLMOD and SPQR take them: no more than 2^31 - 1 non-zeros. A
/// matrix that is moved from is empty. Eigen 3.4 itself would copy it.
template <int Order>
class MovableSparse : public Eigen::SparseMatrix<double, Order, int> {
  using Base = Eigen::SparseMatrix<double, Order, int>;

 public:
  using Base::Base;
  using Base::operator=;
  MovableSparse() = default;
  MovableSparse(const MovableSparse&) = default;
  MovableSparse& operator=(const MovableSparse&) = default;
  MovableSparse(MovableSparse&& other) noexcept { this->swap(other); }
  MovableSparse& operator=(MovableSparse&& other) noexcept
  {
    MovableSparse(std::move(other)).swap(*this);
    return *this;
  }
  ~MovableSparse() = default;
};

/// A sparse matrix by columns.
using SparseMatrix = MovableSparse<Eigen::ColMajor>;

/// A sparse matrix by rows.
using SparseRows = MovableSparse<Eigen::RowMajor>;

}  // namespace holdfast
