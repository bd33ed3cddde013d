#include "holdfast/elimination/sequential_qr.h"

#include <algorithm>
#include <cmath>

namespace holdfast {

SequentialQr::SequentialQr(Index rows, Index maxColumns)
    : reflectors_(rows, std::min(rows, maxColumns)), R_(std::min(rows, maxColumns), std::min(rows, maxColumns))
{
  reflectors_.setZero();
  R_.setZero();
}

std::optional<Eigen::VectorXd> SequentialQr::add(const Eigen::VectorXd& column)
{
  Eigen::VectorXd x = column;
  for (Index k = 0; k < rank_; ++k) {
    const auto h = reflectors_.col(k).tail(x.size() - k);
    x.tail(x.size() - k) -= 2 * h.dot(x.tail(x.size() - k)) * h;
  }
  const double left = x.tail(x.size() - rank_).norm();
  if (left <= kRankTolerance * column.norm())
    return R_.topLeftCorner(rank_, rank_).triangularView<Eigen::Upper>().solve(x.head(rank_));

  const double diagonal = std::copysign(left, -x[rank_]);
  auto h = reflectors_.col(rank_).tail(x.size() - rank_);
  h = x.tail(x.size() - rank_);
  h[0] -= diagonal;
  h.normalize();
  R_.col(rank_).head(rank_) = x.head(rank_);
  R_(rank_, rank_) = diagonal;
  ++rank_;
  return std::nullopt;
}

Eigen::MatrixXd SequentialQr::applyQ(Eigen::MatrixXd block) const
{
  for (Index k = rank_ - 1; k >= 0; --k) {
    const auto h = reflectors_.col(k);
    block -= 2 * h * (h.transpose() * block);
  }
  return block;
}

}  // namespace holdfast
