#include "holdfast/elimination/sequential_qr.h"

#include <algorithm>
#include <cmath>

namespace holdfast {

SequentialQr::SequentialQr(Index rows, Index maxColumns)
    : reflectors_(rows, std::min(rows, maxColumns)),
      R_(std::min(rows, maxColumns), std::min(rows, maxColumns)),
      lengths_(std::min(rows, maxColumns))
{
  reflectors_.setZero();
  R_.setZero();
}

std::optional<Eigen::VectorXd> SequentialQr::add(const Eigen::VectorXd& column, double tolerance)
{
  const Eigen::VectorXd x = reflected(column);
  Eigen::VectorXd coefficients = R_.topLeftCorner(rank_, rank_).triangularView<Eigen::Upper>().solve(x.head(rank_));
  const double length = column.norm();
  const double left = x.tail(x.size() - rank_).norm();
  // Of columns of length 1.
  const double size = coefficients.cwiseProduct(lengths_.head(rank_)).norm() / length;
  distance_ = left / length / std::hypot(1, size);
  if (distance_ <= tolerance) return coefficients;
  accept(x, left, length);
  return std::nullopt;
}

bool SequentialQr::append(const Eigen::VectorXd& column)
{
  const Eigen::VectorXd x = reflected(column);
  const double left = x.tail(x.size() - rank_).norm();
  if (left == 0) return false;
  accept(x, left, column.norm());
  return true;
}

Eigen::VectorXd SequentialQr::reflected(const Eigen::VectorXd& column) const
{
  Eigen::VectorXd x = column;
  for (Index k = 0; k < rank_; ++k) {
    const auto h = reflectors_.col(k).tail(x.size() - k);
    x.tail(x.size() - k) -= 2 * h.dot(x.tail(x.size() - k)) * h;
  }
  return x;
}

void SequentialQr::accept(const Eigen::VectorXd& x, double left, double length)
{
  const double diagonal = std::copysign(left, -x[rank_]);
  auto h = reflectors_.col(rank_).tail(x.size() - rank_);
  h = x.tail(x.size() - rank_);
  h[0] -= diagonal;
  h.normalize();
  R_.col(rank_).head(rank_) = x.head(rank_);
  R_(rank_, rank_) = diagonal;
  lengths_[rank_] = length;
  ++rank_;
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
