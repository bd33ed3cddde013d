// Dense kernels by LAPACK and BLAS, which come with SuiteSparse.

#ifdef HOLDFAST_WITH_CHOLMOD

#include <holdfast/factor/dense_kernels_internal.h>

// Fortran's: every argument is an address.
extern "C" {
void dpotrf_(const char* part, const int* n, double* A, const int* ldA, int* info);
void dtrsm_(const char* side, const char* part, const char* transposed, const char* unit, const int* m, const int* n,
            const double* factor, const double* A, const int* ldA, double* B, const int* ldB);
void dsyrk_(const char* part, const char* transposed, const int* n, const int* k, const double* factor, const double* A,
            const int* ldA, const double* scale, double* C, const int* ldC);
void dgemm_(const char* transposedA, const char* transposedB, const int* m, const int* n, const int* k,
            const double* factor, const double* A, const int* ldA, const double* B, const int* ldB, const double* scale,
            double* C, const int* ldC);
}

namespace holdfast {
namespace {

constexpr double kOne = 1;

}  // namespace

int denseCholesky(int n, double* A, int ld)
{
  int info = 0;
  dpotrf_("L", &n, A, &ld, &info);
  return info;
}

void denseSolveRight(int m, int n, const double* L, int ldL, double* B, int ldB)
{
  dtrsm_("R", "L", "T", "N", &m, &n, &kOne, L, &ldL, B, &ldB);
}

void denseSymmetricUpdate(int n, int k, double factor, const double* A, int ldA, double scale, double* C, int ldC)
{
  dsyrk_("L", "N", &n, &k, &factor, A, &ldA, &scale, C, &ldC);
}

void denseUpdate(int m, int n, int k, double factor, const double* A, const double* B, int ldAB, double scale,
                 double* C, int ldC)
{
  dgemm_("N", "T", &m, &n, &k, &factor, A, &ldAB, B, &ldAB, &scale, C, &ldC);
}

}  // namespace holdfast

#endif
