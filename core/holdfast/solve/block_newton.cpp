#include "holdfast/solve/block_newton.h"

#include <algorithm>
#include <utility>

#include <holdfast/factor/dense_cholesky.h>

namespace holdfast {
namespace {

// Blocks add nothing to a pivot where they are a smaller share of it.
constexpr double kNothingAdded = 1e-17;

// Woodbury's formula loses digits where blocks differ by many powers of ten; corrections bring them back.
constexpr int kCorrections = 2;

/// c n n^T of one point.
struct RankOne {
  Index point = 0;
  Vector3 n;
  double c = 0;
};

/// The inverse of a symmetric matrix, scaled to a diagonal of ones on the way.
std::optional<Eigen::MatrixXd> scaledInverse(const Eigen::MatrixXd& A)
{
  const Eigen::VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  std::optional<Eigen::MatrixXd> inverse = inverseOfDefinite(scale.asDiagonal() * A * scale.asDiagonal());
  if (inverse) *inverse = scale.asDiagonal() * *inverse * scale.asDiagonal();
  return inverse;
}

class BlockNewton {
 public:
  BlockNewton(const Eigen::MatrixXd& K, const std::vector<Eigen::Matrix3d>& blocks) : K_(K), blocks_(blocks) {}

  [[nodiscard]] bool factorize()
  {
    Eigen::MatrixXd M = K_;
    for (Index i = 0; i < K_.rows(); ++i) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(blocks_[i]);
      const double w = std::max(0.0, eigen.eigenvalues()[0]);
      M(i, i) += w;
      for (Index k = 1; k < 3; ++k)
        if (const double c = eigen.eigenvalues()[k] - w; c > kNothingAdded * M(i, i))
          added_.push_back({i, eigen.eigenvectors().col(k), c});
    }
    std::optional<Eigen::MatrixXd> inverse = scaledInverse(M);
    if (!inverse) return false;
    inverse_ = *std::move(inverse);
    const auto count = static_cast<Index>(added_.size());
    coupling_.resize(count, count);
    for (Index b = 0; b < count; ++b)
      for (Index a = b; a < count; ++a)
        coupling_(a, b) = added_[a].n.dot(added_[b].n) * inverse_(added_[a].point, added_[b].point);
    for (Index a = 0; a < count; ++a) coupling_(a, a) += 1 / added_[a].c;
    scale_ = coupling_.diagonal().cwiseSqrt().cwiseInverse();
    coupling_ = scale_.asDiagonal() * coupling_ * scale_.asDiagonal();
    return scale_.allFinite() && factorizeDense(coupling_);
  }

  [[nodiscard]] Columns3 solve(const Columns3& g) const
  {
    Columns3 y = solveOnce(g);
    double left = sizeOf(g);
    for (int k = 0; k < kCorrections; ++k) {
      const Columns3 missed = g - times(y);
      const double its = sizeOf(missed);
      if (!(its < left)) break;
      left = its;
      y += solveOnce(missed);
    }
    return y;
  }

 private:
  [[nodiscard]] Columns3 solveOnce(const Columns3& g) const
  {
    Columns3 y = inverse_ * g;
    Eigen::VectorXd along(coupling_.rows());
    for (Index a = 0; a < along.size(); ++a) along[a] = scale_[a] * y.row(added_[a].point).dot(added_[a].n);
    coupling_.triangularView<Eigen::Lower>().solveInPlace(along);
    coupling_.triangularView<Eigen::Lower>().transpose().solveInPlace(along);
    Columns3 spread = Columns3::Zero(g.rows(), 3);
    for (Index a = 0; a < along.size(); ++a)
      spread.row(added_[a].point) += scale_[a] * along[a] * added_[a].n.transpose();
    y.noalias() -= inverse_ * spread;
    return y;
  }

  [[nodiscard]] Columns3 times(const Columns3& y) const
  {
    Columns3 result = K_ * y;
    for (Index i = 0; i < y.rows(); ++i) result.row(i) += y.row(i) * blocks_[i];
    return result;
  }

  /// Of a right-hand side: what each point makes of it alone.
  [[nodiscard]] double sizeOf(const Columns3& g) const
  {
    double most = 0;
    for (Index i = 0; i < g.rows(); ++i) {
      const Eigen::Matrix3d own = K_(i, i) * Eigen::Matrix3d::Identity() + blocks_[i];
      most = std::max(most, g.row(i).dot(own.llt().solve(Vector3(g.row(i)))));
    }
    return most;
  }

  const Eigen::MatrixXd& K_;
  const std::vector<Eigen::Matrix3d>& blocks_;
  std::vector<RankOne> added_;
  Eigen::MatrixXd inverse_;
  Eigen::MatrixXd coupling_;  // its factor, scaled
  Eigen::VectorXd scale_;
};

}  // namespace

std::optional<Eigen::VectorXd> solveBlockNewton(const Eigen::MatrixXd& K, const std::vector<Eigen::Matrix3d>& blocks,
                                                const Eigen::VectorXd& g)
{
  BlockNewton newton(K, blocks);
  if (!newton.factorize()) return std::nullopt;
  const Columns3 y = newton.solve(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>>(g.data(), K.rows(), 3));
  Eigen::VectorXd result(g.size());
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3>>(result.data(), K.rows(), 3) = y;
  return result;
}

}  // namespace holdfast
