// Sparse QR by SPQR of SuiteSparse.

#include <algorithm>
#include <memory>
#include <queue>
#include <stdexcept>
#include <vector>

#include <SuiteSparseQR.hpp>

#include <holdfast/base/cholmod_view_internal.h>
#include <holdfast/base/one_thread_internal.h>
#include <holdfast/base/types.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

/// Q = P^T H_1 H_2 ... H_k with H_j = I - tau_j h_j h_j^T and (P x)_place(i) = x_i.
struct HouseholderVectors {
  SparseMatrix h;            ///< m x k
  Eigen::VectorXd tau;       ///< k
  std::vector<Index> place;  ///< m: row i of Q is row place[i] of the product
};

/// One column at a time, in dense workspaces that are cleared where they were touched.
class ReflectedUnit {
 public:
  explicit ReflectedUnit(const HouseholderVectors& vectors)
      : vectors_(vectors),
        byRow_(vectors.h),
        x_(Eigen::VectorXd::Zero(vectors.h.rows())),
        isTouched_(static_cast<std::size_t>(vectors.h.rows()), false),
        isPending_(static_cast<std::size_t>(vectors.h.cols()), false)
  {
  }

  /// H_1 ... H_k e_row: the places that are not zero are `touched()`.
  void reflect(Index row)
  {
    touch(row, vectors_.h.cols());
    x_[row] = 1;
    while (!pending_.empty()) {
      const Index j = pending_.top();
      pending_.pop();
      isPending_[j] = false;
      apply(j);
    }
  }

  [[nodiscard]] const std::vector<Index>& touched() const { return touched_; }
  [[nodiscard]] double at(Index row) const { return x_[row]; }

  void clear()
  {
    for (const Index row : touched_) {
      x_[row] = 0;
      isTouched_[row] = false;
    }
    touched_.clear();
  }

 private:
  /// Reflections before `end` that hang on a row that was zero so far are to come.
  void touch(Index row, Index end)
  {
    if (isTouched_[row]) return;
    isTouched_[row] = true;
    touched_.push_back(row);
    for (SparseRows::InnerIterator entry(byRow_, row); entry && entry.col() < end; ++entry) {
      if (isPending_[entry.col()]) continue;
      isPending_[entry.col()] = true;
      pending_.push(entry.col());
    }
  }

  void apply(Index j)
  {
    double product = 0;
    for (SparseMatrix::InnerIterator entry(vectors_.h, j); entry; ++entry) product += entry.value() * x_[entry.row()];
    if (product == 0) return;
    for (SparseMatrix::InnerIterator entry(vectors_.h, j); entry; ++entry) {
      touch(entry.row(), j);
      x_[entry.row()] -= vectors_.tau[j] * product * entry.value();
    }
  }

  const HouseholderVectors& vectors_;
  SparseRows byRow_;
  Eigen::VectorXd x_;
  std::vector<bool> isTouched_;
  std::vector<bool> isPending_;
  std::vector<Index> touched_;
  std::priority_queue<Index> pending_;
};

/// Q, m x m. Each column meets only the reflections that share a row with what it has become: time and memory go with
/// the entries of Q, not with m^2.
SparseMatrix explicitQ(const HouseholderVectors& vectors)
{
  const Index m = vectors.h.rows();
  std::vector<Index> rowAt(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) rowAt[vectors.place[i]] = i;
  SparseMatrix Q(m, m);
  ReflectedUnit column(vectors);
  for (Index k = 0; k < m; ++k) {
    column.reflect(k);
    std::vector<Index> rows;
    for (const Index place : column.touched()) rows.push_back(rowAt[place]);
    std::sort(rows.begin(), rows.end());
    Q.startVec(k);
    for (const Index row : rows)
      if (const double value = column.at(vectors.place[row]); value != 0) Q.insertBack(row, k) = value;
    column.clear();
  }
  Q.finalize();
  return Q;
}

using LongMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;

/// CHOLMOD's workspace for 64-bit indices.
class Workspace {
 public:
  Workspace()
  {
    cholmod_l_start(&common_);
    common_.print = 0;
  }
  ~Workspace() { cholmod_l_finish(&common_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  cholmod_common* get() { return &common_; }

 private:
  OneThread libraries_;
  cholmod_common common_{};
};

/// Takes a matrix over from CHOLMOD, its first `rows` rows.
SparseMatrix taken(cholmod_sparse* matrix, Index rows, cholmod_common* common)
{
  const Eigen::Map<const LongMatrix> view(static_cast<Index>(matrix->nrow), static_cast<Index>(matrix->ncol),
                                          static_cast<SuiteSparse_long*>(matrix->p)[matrix->ncol],
                                          static_cast<SuiteSparse_long*>(matrix->p),
                                          static_cast<SuiteSparse_long*>(matrix->i), static_cast<double*>(matrix->x));
  SparseMatrix result = view;
  cholmod_l_free_sparse(&matrix, common);
  if (rows < result.rows()) result.conservativeResize(rows, result.cols());
  return result;
}

std::vector<Index> takenPermutation(SuiteSparse_long* columns, Index count, cholmod_common* common)
{
  std::vector<Index> result(static_cast<std::size_t>(count));
  for (Index k = 0; k < count; ++k) result[k] = columns == nullptr ? k : static_cast<Index>(columns[k]);
  if (columns != nullptr) cholmod_l_free(static_cast<std::size_t>(count), sizeof(SuiteSparse_long), columns, common);
  return result;
}

/// Takes the Householder vectors over from SPQR.
HouseholderVectors taken(cholmod_sparse* h, SuiteSparse_long* place, cholmod_dense* tau, cholmod_common* common)
{
  const Index m = static_cast<Index>(h->nrow);
  HouseholderVectors result;
  result.tau = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(tau->x), static_cast<Index>(h->ncol));
  result.h = taken(h, m, common);
  result.place = takenPermutation(place, m, common);
  cholmod_l_free_dense(&tau, common);
  return result;
}

}  // namespace

SparseQrResult sparseQrSuiteSparse(const SparseMatrix& M, double tolerance, WantQ wantQ, ColumnOrder order)
{
  Workspace workspace;
  cholmod_common* const common = workspace.get();
  LongMatrix matrix = M;
  matrix.makeCompressed();
  cholmod_sparse view = cholmodView(matrix, StoredPart::All);
  cholmod_sparse* R = nullptr;
  cholmod_sparse* h = nullptr;
  cholmod_dense* tau = nullptr;
  SuiteSparse_long* columns = nullptr;
  SuiteSparse_long* place = nullptr;
  const double limit = tolerance < 0 ? SPQR_NO_TOL : tolerance;
  const int ordering = order == ColumnOrder::AsGiven ? SPQR_ORDERING_FIXED : SPQR_ORDERING_COLAMD;
  const SuiteSparse_long econ = std::min(M.rows(), M.cols());
  // SPQR's own explicit Q would take memory for m x m numbers.
  const SuiteSparse_long rank =
      wantQ == WantQ::Yes ? SuiteSparseQR<double>(ordering, limit, econ, &view, &R, &columns, &h, &place, &tau, common)
                          : SuiteSparseQR<double>(ordering, limit, econ, &view, &R, &columns, common);
  if (rank < 0 || R == nullptr) throw std::bad_alloc();
  SparseQrResult result;
  result.rank = static_cast<Index>(rank);
  result.R = taken(R, result.rank, common);
  result.columns = takenPermutation(columns, M.cols(), common);
  if (h != nullptr) result.Q = explicitQ(taken(h, place, tau, common));
  return result;
}

}  // namespace holdfast
