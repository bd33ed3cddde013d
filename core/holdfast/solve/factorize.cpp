#include <array>

#include <fmt/format.h>

#include <holdfast/solve/corrected_solve.h>

namespace holdfast {
namespace {

// A factor that leaves at most this share of an error reaches the digits of a double in a dozen corrections.
constexpr double kGoodContraction = 0.05;

/// The factor of a problem without unknowns: constraints and parts at rest have taken all.
class NothingToSolve final : public LeastSquaresFactor {
 public:
  [[nodiscard]] Columns3 solve(const Columns3& /*g*/) const override { return Columns3(0, 3); }
  [[nodiscard]] Index nonzeros() const override { return 0; }
  [[nodiscard]] std::string_view method() const override { return "nothing left to solve"; }
};

FactorResult cholesky(const LinearMap& C, Backend backend, EliminationOrder order)
{
  if (backend == Backend::Holdfast) return choleskyMultifrontal(C, order);
#ifdef HOLDFAST_WITH_CHOLMOD
  if (backend == Backend::Cholmod) return choleskyBySuiteSparse(C);
#endif
  return choleskyByEigen(C);
}

}  // namespace

std::string_view name(Backend backend)
{
  constexpr std::array kNames{"holdfast", "cholmod", "eigen"};
  return kNames[static_cast<std::size_t>(backend)];
}

bool isBuilt(Backend backend)
{
#ifdef HOLDFAST_WITH_CHOLMOD
  static_cast<void>(backend);
  return true;
#else
  return backend != Backend::Cholmod;
#endif
}

FactorResult factorizeKept(const LinearMap& C, const SparseMatrix& kept, const Columns3& probe, EliminationOrder order)
{
  FactorResult result = choleskyMultifrontal(C, order, kept);
  if (!result) return result;
  const double left = contraction(*result.value, C, probe, kept.rows());
  if (left <= kGoodContraction) return result;
  return {nullptr,
          fmt::format("the equations with multipliers keep no digits (a correction leaves {:.1g} of an error)", left)};
}

FactorResult factorize(const LinearMap& C, Backend backend, const Columns3& probe, EliminationOrder order)
{
  if (probe.rows() == 0) return {std::make_unique<NothingToSolve>()};
  FactorResult first = cholesky(C, backend, order);
  double left = 0;
  if (first.value != nullptr) {
    left = contraction(*first.value, C, probe);
    if (left <= kGoodContraction) return first;
    first.failure = fmt::format("the normal equations keep no digits (a correction leaves {:.1g} of an error)", left);
  }
  FactorResult second = seminormalQr(C, backend);
  if (second.value != nullptr) {
    const double leftByQr = contraction(*second.value, C, probe);
    if (leftByQr <= kUsableContraction) return second;
    second.failure = fmt::format("sparse QR keeps no digits (a correction leaves {:.1g} of an error)", leftByQr);
  }
  if (first.value != nullptr && left <= kUsableContraction) return {std::move(first.value)};
  return {nullptr, first.failure + "; " + second.failure};
}

}  // namespace holdfast
