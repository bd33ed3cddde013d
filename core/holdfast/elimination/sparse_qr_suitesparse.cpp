// Sparse QR by SPQR of SuiteSparse.

#include <algorithm>

#include <SuiteSparseQR.hpp>

#include <holdfast/elimination/sparse_qr.h>
#include <holdfast/matrices/cholmod_view_internal.h>
#include <holdfast/threads/one_thread_internal.h>

namespace holdfast {
namespace {

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

/// Takes the reflections over from SPQR.
Reflections taken(cholmod_sparse* h, SuiteSparse_long* place, cholmod_dense* tau, cholmod_common* common)
{
  const Index m = static_cast<Index>(h->nrow);
  Reflections result;
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
  const SuiteSparse_long rank =
      wantQ == WantQ::Yes ? SuiteSparseQR<double>(ordering, limit, econ, &view, &R, &columns, &h, &place, &tau, common)
                          : SuiteSparseQR<double>(ordering, limit, econ, &view, &R, &columns, common);
  if (rank < 0 || R == nullptr) throw std::bad_alloc();
  SparseQrResult result;
  result.rank = static_cast<Index>(rank);
  result.R = taken(R, result.rank, common);
  result.columns = takenPermutation(columns, M.cols(), common);
  if (h != nullptr) result.Q = taken(h, place, tau, common);
  return result;
}

}  // namespace holdfast
