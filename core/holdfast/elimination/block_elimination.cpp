#include "holdfast/elimination/block_elimination.h"

#include <cmath>
#include <map>
#include <random>
#include <utility>

#include <holdfast/elimination/own_unknowns.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {
namespace {

using Triplets = std::vector<Eigen::Triplet<double, int>>;

constexpr Index kNotPivot = -1;
constexpr Index kTaken = -2;

// The inverse of a triangular matrix of this size is formed as it is; of larger ones the lengths of rows are estimated.
constexpr Index kLargestInverse = 512;
constexpr int kProbes = 16;

/// R1^-1, or rows that have about its lengths, and so have their sums: what R1^-1 makes of vectors of random signs. The
/// mean square of an entry is that of the row's length.
Eigen::MatrixXd inverseRows(const SparseMatrix& R1)
{
  Eigen::MatrixXd result;
  if (R1.cols() <= kLargestInverse) {
    result.setIdentity(R1.cols(), R1.cols());
  } else {
    std::minstd_rand random(1);
    result.resize(R1.cols(), kProbes);
    const double size = 1 / std::sqrt(static_cast<double>(kProbes));
    for (double& entry : result.reshaped()) entry = (random() >> 16) % 2 == 0 ? size : -size;
  }
  R1.triangularView<Eigen::Upper>().solveInPlace(result);
  return result;
}

}  // namespace

Columns3 BlockElimination::Block::spanTimes(const Columns3& y) const
{
  if (!isLarge()) return Q1 * y;
  Columns3 padded = Columns3::Zero(static_cast<Index>(unknowns.size()), 3);
  padded.topRows(y.rows()) = y;
  return Q.times(padded);
}

Columns3 BlockElimination::Block::spanTransposeTimes(const Columns3& x) const
{
  if (!isLarge()) return Q1.transpose() * x;
  return Q.transposeTimes(x).topRows(static_cast<Index>(rows.size()));
}

BlockElimination::BlockElimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent,
                                   Index unknownCount, const std::vector<bool>& isHeld)
    : pinnedTerms_(rows.size()), isHeld_(isHeld)
{
  std::vector<bool> isPinned(static_cast<std::size_t>(unknownCount), false);
  for (const Index row : independent)
    if (rows[row].size() == 1) {
      pins_.push_back({rows[row].front().index, row, rows[row].front().coefficient});
      isPinned[rows[row].front().index] = true;
    }
  std::vector<RowTerms> left(rows.size());
  for (const Index row : independent)
    if (rows[row].size() > 1)
      for (const Term& term : rows[row]) (isPinned[term.index] ? pinnedTerms_ : left)[row].push_back(term);
  for (const RowComponent& component : connectedRows(left, unknownCount))
    blocks_.push_back(isDense(component) ? denseBlock(left, component) : sparseBlock(left, component));
  Q2_ = assembleQ2();
}

BlockElimination::Block BlockElimination::denseBlock(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  const Eigen::MatrixXd BT = transposedBlock(rows, component);
  SequentialQr qr(BT.rows(), BT.cols());
  Block block{{}, component.unknowns, {}, {}, {}, {}, {}};
  for (Index k = 0; k < BT.cols(); ++k)
    if (!qr.add(BT.col(k))) block.rows.push_back(component.rows[k]);
  const Eigen::MatrixXd Q = qr.applyQ(Eigen::MatrixXd::Identity(BT.rows(), BT.rows()));
  block.Q1 = Q.leftCols(qr.rank()).sparseView(1, 0);
  block.Q2 = Q.rightCols(BT.rows() - qr.rank()).sparseView(1, 0);
  block.R1 = qr.R().sparseView(1, 0);
  return block;
}

BlockElimination::Block BlockElimination::sparseBlock(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  SparseMatrix BT = transposedBlock(rows, component);
  const Eigen::VectorXd lengths = normalizeColumns(BT);
  SparseQrResult qr = sparseQr(BT, kRankTolerance, WantQ::Yes);
  Block block{{}, component.unknowns, qr.R.leftCols(qr.rank), {}, {}, std::move(qr.Q), {}};
  for (Index k = 0; k < qr.rank; ++k) block.rows.push_back(component.rows[qr.columns[k]]);
  for (Index k = 0; k < qr.rank; ++k) block.R1.col(k) *= lengths[qr.columns[k]];
  if (block.rows.size() == block.unknowns.size()) return block;
  SubstitutedRows left = substituted(localRows(rows, {block.rows, block.unknowns}), BT.rows());
  for (const Index row : left.kept) block.kept.push_back(block.rows[row]);
  block.Q2 = std::move(left.basis);
  return block;
}

SparseMatrix BlockElimination::wholeQ2() const
{
  BlockElimination whole = *this;
  for (Block& block : whole.blocks_)
    if (block.isLarge()) block.Q2 = block.Q.columnsFrom(static_cast<Index>(block.rows.size()));
  return whole.assembleQ2();
}

SparseMatrix BlockElimination::assembleQ2() const
{
  const auto unknownCount = static_cast<Index>(isHeld_.size());
  std::vector<Index> role(isHeld_.size(), kNotPivot);
  for (Index u = 0; u < unknownCount; ++u)
    if (isHeld_[u]) role[u] = kTaken;
  for (const Pin& pin : pins_) role[pin.unknown] = kTaken;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (const Index u : blocks_[b].unknowns) role[u] = kTaken;
    role[blocks_[b].unknowns.front()] = static_cast<Index>(b);
  }

  // Columns in the order of the unknowns, a block's at its first: neighbours on the surface stay neighbours.
  Triplets entries;
  int column = 0;
  for (Index u = 0; u < unknownCount; ++u) {
    if (role[u] == kNotPivot) entries.emplace_back(static_cast<int>(u), column++, 1.0);
    if (role[u] < 0) continue;
    const Block& block = blocks_[role[u]];
    for (int k = 0; k < block.Q2.outerSize(); ++k, ++column)
      for (SparseMatrix::InnerIterator entry(block.Q2, k); entry; ++entry)
        entries.emplace_back(static_cast<int>(block.unknowns[entry.row()]), column, entry.value());
  }
  SparseMatrix result(unknownCount, column);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Columns3 BlockElimination::particular(const Columns3& d) const
{
  Columns3 u = Columns3::Zero(Q2_.rows(), 3);
  for (const Pin& pin : pins_) u.row(pin.unknown) = d.row(pin.row) / pin.weight;
  for (const Block& block : blocks_) {
    Columns3 y(static_cast<Index>(block.rows.size()), 3);
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      y.row(k) = d.row(block.rows[k]);
      for (const Term& term : pinnedTerms_[block.rows[k]]) y.row(k) -= term.coefficient * u.row(term.index);
    }
    block.R1.transpose().triangularView<Eigen::Lower>().solveInPlace(y);  // R1^T y = d, (18)
    u(block.unknowns, Eigen::all) = block.spanTimes(y);
  }
  return u;
}

Columns3 BlockElimination::multipliers(const Columns3& gradient, Index rowCount) const
{
  Columns3 result = Columns3::Zero(rowCount, 3);
  Columns3 left = gradient;
  for (const Block& block : blocks_) {
    Columns3 y = block.spanTransposeTimes(gradient(block.unknowns, Eigen::all));
    block.R1.triangularView<Eigen::Upper>().solveInPlace(y);
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      result.row(block.rows[k]) = y.row(k);
      for (const Term& term : pinnedTerms_[block.rows[k]]) left.row(term.index) -= term.coefficient * y.row(k);
    }
  }
  for (const Pin& pin : pins_) result.row(pin.row) = left.row(pin.unknown) / pin.weight;
  return result;
}

std::vector<double> BlockElimination::sensitivities(std::size_t rowCount) const
{
  // The transpose of the pseudo-inverse, row by row: R1^-1 Q1^T at the rows of blocks, and at a pin 1, and what the
  // blocks do when it moves.
  std::vector<double> result(rowCount, 0);
  std::vector<double> squaresOfPinned(static_cast<std::size_t>(Q2_.rows()), 1);
  for (const Block& block : blocks_) {
    const Eigen::MatrixXd inverse = inverseRows(block.R1);
    std::map<Index, Eigen::RowVectorXd> ofPinned;
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      const auto row = inverse.row(static_cast<Index>(k));
      result[block.rows[k]] = row.norm();
      for (const Term& term : pinnedTerms_[block.rows[k]])
        ofPinned.try_emplace(term.index, Eigen::RowVectorXd::Zero(inverse.cols())).first->second +=
            term.coefficient * row;
    }
    for (const auto& [unknown, moved] : ofPinned) squaresOfPinned[unknown] += moved.squaredNorm();
  }
  for (const Pin& pin : pins_) result[pin.row] = std::sqrt(squaresOfPinned[pin.unknown]) / std::abs(pin.weight);
  return result;
}

}  // namespace holdfast
