#include "holdfast/elimination/block_elimination.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>

#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {
namespace {

using Triplets = std::vector<Eigen::Triplet<double, int>>;

constexpr Index kNotPivot = -1;
constexpr Index kTaken = -2;

// The inverse of a triangular matrix of this size is formed as it is; of larger ones the lengths of rows are estimated.
constexpr Index kLargestInverse = 512;
constexpr int kProbes = 16;

// Rows of blocks that a thread takes at a time.
constexpr Index kPart = 4096;

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

BlockElimination::BlockElimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent,
                                   Index unknownCount, const std::vector<bool>& isHeld)
    : isHeld_(isHeld), rowCount_(rows.size())
{
  std::vector<bool> isPinned(static_cast<std::size_t>(unknownCount), false);
  for (const Index row : independent)
    if (rows[row].size() == 1) {
      pins_.push_back({rows[row].front().index, row, rows[row].front().coefficient});
      isPinned[rows[row].front().index] = true;
    }
  std::vector<RowTerms> left(rows.size());
  std::vector<RowTerms> pinned(rows.size());
  for (const Index row : independent)
    if (rows[row].size() > 1)
      for (const Term& term : rows[row]) (isPinned[term.index] ? pinned : left)[row].push_back(term);
  std::vector<RowComponent> components = connectedRows(left, unknownCount);
  std::stable_partition(components.begin(), components.end(), std::not_fn(isDense));

  Triplets ofR1;
  Triplets ofQ1;
  std::vector<RowTerms> atPins;
  parts_.push_back(0);
  for (const RowComponent& component : components) {
    auto [block, factors] = isDense(component) ? denseBlock(left, component) : sparseBlock(left, component);
    const auto first = static_cast<int>(rows_.size());
    for (int k = 0; k < factors.R1.cols(); ++k) {
      for (SparseMatrix::InnerIterator entry(factors.R1, k); entry; ++entry)
        ofR1.emplace_back(first + static_cast<int>(entry.row()), first + k, entry.value());
      if (!block.isLarge())
        for (SparseMatrix::InnerIterator entry(factors.Q1, k); entry; ++entry)
          ofQ1.emplace_back(static_cast<int>(block.unknowns[entry.row()]), first + k, entry.value());
      rows_.push_back(block.rows[k]);
      atPins.push_back(std::move(pinned[rows_.back()]));
    }
    blocks_.push_back(std::move(block));
    if (static_cast<Index>(rows_.size()) - parts_.back() >= kPart) parts_.push_back(static_cast<Index>(rows_.size()));
  }
  parts_.push_back(static_cast<Index>(rows_.size()));
  const auto count = static_cast<Index>(rows_.size());
  R1_.resize(count, count);
  R1_.setFromTriplets(ofR1.begin(), ofR1.end());
  parallelFor(2, [&](Index k) {
    if (k == 0) {
      SparseMatrix Q1(unknownCount, count);
      Q1.setFromTriplets(ofQ1.begin(), ofQ1.end());
      Q1_ = TwoWayMatrix(std::move(Q1));
    } else {
      pinnedTerms_ = TwoWayMatrix(constraintMatrix(atPins, unknownCount));
    }
  });
}

std::pair<BlockElimination::Block, BlockElimination::Factors> BlockElimination::denseBlock(
    const std::vector<RowTerms>& rows, const RowComponent& component)
{
  const Eigen::MatrixXd BT = transposedBlock(rows, component);
  SequentialQr qr(BT.rows(), BT.cols());
  Block block{{}, component.unknowns, {}, {}, {}};
  for (Index k = 0; k < BT.cols(); ++k)
    if (qr.append(BT.col(k))) block.rows.push_back(component.rows[k]);
  const Eigen::MatrixXd Q = qr.applyQ(Eigen::MatrixXd::Identity(BT.rows(), BT.rows()));
  block.Q2 = Q.rightCols(BT.rows() - qr.rank()).sparseView(1, 0);
  Factors factors{qr.R().sparseView(1, 0), Q.leftCols(qr.rank()).sparseView(1, 0)};
  return {std::move(block), std::move(factors)};
}

std::pair<BlockElimination::Block, BlockElimination::Factors> BlockElimination::sparseBlock(
    const std::vector<RowTerms>& rows, const RowComponent& component)
{
  SparseMatrix BT = transposedBlock(rows, component);
  const Eigen::VectorXd lengths = normalizeColumns(BT);
  constexpr double kAcceptAll = -1;
  SparseQrResult qr = sparseQr(BT, kAcceptAll, WantQ::Yes);
  Block block{{}, component.unknowns, {}, std::move(qr.Q), {}};
  Factors factors{qr.R.leftCols(qr.rank), {}};
  for (Index k = 0; k < qr.rank; ++k) block.rows.push_back(component.rows[qr.columns[k]]);
  for (Index k = 0; k < qr.rank; ++k) factors.R1.col(k) *= lengths[qr.columns[k]];
  block.parts = freeParts(localRows(rows, {block.rows, block.unknowns}), BT.rows());
  block.Q2 = basisOf(block.parts, BT.rows());
  return {std::move(block), std::move(factors)};
}

SparseMatrix BlockElimination::wholeQ2() const
{
  BlockElimination whole = *this;
  for (Block& block : whole.blocks_)
    if (block.isLarge()) block.Q2 = wholeBasisOf(block.parts, static_cast<Index>(block.unknowns.size()));
  return whole.Q2();
}

SparseMatrix BlockElimination::Q2() const
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

  const Index columns = freeCount();
  SparseMatrix result(unknownCount, columns);
  result.reserve(columns);
  // In the order of the unknowns, a block's at its first: neighbours on the surface stay neighbours.
  Index column = 0;
  for (Index u = 0; u < unknownCount; ++u) {
    if (role[u] == kTaken) continue;
    if (role[u] == kNotPivot) {
      result.startVec(column);
      result.insertBack(u, column++) = 1;
      continue;
    }
    const Block& block = blocks_[role[u]];
    for (Index k = 0; k < block.Q2.cols(); ++k, ++column) {
      result.startVec(column);
      for (SparseMatrix::InnerIterator entry(block.Q2, k); entry; ++entry)
        result.insertBack(block.unknowns[entry.row()], column) = entry.value();
    }
  }
  result.finalize();
  return result;
}

Index BlockElimination::freeCount() const
{
  Index count = std::ranges::count(isHeld_, false) - static_cast<Index>(pins_.size());
  for (const Block& block : blocks_) count -= static_cast<Index>(block.unknowns.size()) - block.Q2.cols();
  return count;
}

Columns3 BlockElimination::particular(const Columns3& d) const
{
  Columns3 u = Columns3::Zero(static_cast<Index>(isHeld_.size()), 3);
  for (const Pin& pin : pins_) u.row(pin.unknown) = d.row(pin.row) / pin.weight;
  Columns3 y(R1_.rows(), 3);  // of R1^T y = d, (18)
  parallelBlocks(y.rows(), [&](Index k) { y.row(k) = d.row(rows_[k]) - gathered(pinnedTerms_.rows(), k, u); });
  forEachPart([&](Index first, Index end) {
    for (Index k = first; k < end; ++k) {
      Eigen::RowVector3d left = y.row(k);
      SparseMatrix::InnerIterator entry(R1_, k);
      for (; entry.row() < k; ++entry) left -= entry.value() * y.row(entry.row());
      y.row(k) = left / entry.value();
    }
  });
  parallelBlocks(u.rows(), [&](Index i) { u.row(i) += gathered(Q1_.rows(), i, y); });
  forEachLarge([&](const Block& block, Index first, Index count) {
    Columns3 padded = Columns3::Zero(static_cast<Index>(block.unknowns.size()), 3);
    padded.topRows(count) = y.middleRows(first, count);
    u(block.unknowns, Eigen::all) = block.Q.times(std::move(padded));
  });
  return u;
}

Columns3 BlockElimination::multipliers(const Columns3& gradient) const
{
  Columns3 y(R1_.rows(), 3);  // Q1^T gradient
  parallelBlocks(y.rows(), [&](Index k) { y.row(k) = gathered(Q1_.columns(), k, gradient); });
  forEachLarge([&](const Block& block, Index first, Index count) {
    y.middleRows(first, count) = block.Q.transposeTimes(gradient(block.unknowns, Eigen::all)).topRows(count);
  });
  forEachPart([&](Index first, Index end) {
    for (Index k = end - 1; k >= first; --k) {
      SparseMatrix::ReverseInnerIterator entry(R1_, k);
      y.row(k) /= entry.value();
      while (--entry) y.row(entry.row()) -= entry.value() * y.row(k);
    }
  });
  Columns3 result = Columns3::Zero(static_cast<Index>(rowCount_), 3);
  parallelBlocks(y.rows(), [&](Index k) { result.row(rows_[k]) = y.row(k); });
  for (const Pin& pin : pins_)
    result.row(pin.row) = (gradient.row(pin.unknown) - gathered(pinnedTerms_.columns(), pin.unknown, y)) / pin.weight;
  return result;
}

std::vector<double> BlockElimination::sensitivities() const
{
  // The transpose of the pseudo-inverse, row by row: R1^-1 Q1^T at the rows of blocks, and at a pin 1, and what the
  // blocks do when it moves.
  std::vector<double> result(rowCount_, 0);
  std::vector<double> squaresOfPinned(isHeld_.size(), 1);
  Index first = 0;
  for (const Block& block : blocks_) {
    const auto count = static_cast<Index>(block.rows.size());
    const Eigen::MatrixXd inverse = inverseRows(R1_.block(first, first, count, count));
    std::map<Index, Eigen::RowVectorXd> ofPinned;
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      const auto row = inverse.row(static_cast<Index>(k));
      result[block.rows[k]] = row.norm();
      for (SparseRows::InnerIterator term(pinnedTerms_.rows(), first + static_cast<Index>(k)); term; ++term)
        ofPinned.try_emplace(term.col(), Eigen::RowVectorXd::Zero(inverse.cols())).first->second += term.value() * row;
    }
    first += count;
    for (const auto& [unknown, moved] : ofPinned) squaresOfPinned[unknown] += moved.squaredNorm();
  }
  for (const Pin& pin : pins_) result[pin.row] = std::sqrt(squaresOfPinned[pin.unknown]) / std::abs(pin.weight);
  return result;
}

}  // namespace holdfast
