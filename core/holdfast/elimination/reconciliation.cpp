#include "holdfast/elimination/reconciliation.h"

#include <numeric>

#include <holdfast/base/disjoint_sets.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

constexpr Index kNoBlock = -1;
constexpr int kCorrections = 2;

/// Blocks that redundant rows join, and all rows that hang on them.
struct Group {
  std::vector<const BlockElimination::Block*> blocks;
  std::vector<Index> rows;  // independent ones, then redundant ones
};

std::vector<Index> blockOfUnknowns(const BlockElimination& elimination)
{
  std::vector<Index> blockOf(static_cast<std::size_t>(elimination.Q2().rows()), kNoBlock);
  for (std::size_t b = 0; b < elimination.blocks().size(); ++b)
    for (const Index u : elimination.blocks()[b].unknowns) blockOf[u] = static_cast<Index>(b);
  return blockOf;
}

/// A row without an unknown in a block hangs on pins alone.
Index firstBlock(const RowTerms& row, const std::vector<Index>& blockOf)
{
  for (const Term& term : row)
    if (blockOf[term.index] != kNoBlock) return blockOf[term.index];
  return kNoBlock;
}

std::vector<Group> groupsOf(const std::vector<BlockElimination::Block>& blocks, const std::vector<RowTerms>& rows,
                            const std::vector<Index>& redundant, const std::vector<Index>& blockOf)
{
  DisjointSets sets(static_cast<Index>(blocks.size()));
  for (const Index row : redundant)
    for (const Term& term : rows[row])
      if (const Index block = blockOf[term.index]; block != kNoBlock) sets.unite(block, firstBlock(rows[row], blockOf));

  std::vector<std::vector<Index>> redundantOf(blocks.size());  // by representative
  for (const Index row : redundant)
    if (const Index block = firstBlock(rows[row], blockOf); block != kNoBlock)
      redundantOf[sets.find(block)].push_back(row);

  std::vector<Group> groups(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Group& group = groups[sets.find(static_cast<Index>(b))];
    group.blocks.push_back(&blocks[b]);
    group.rows.insert(group.rows.end(), blocks[b].rows.begin(), blocks[b].rows.end());
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
    groups[b].rows.insert(groups[b].rows.end(), redundantOf[b].begin(), redundantOf[b].end());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (redundantOf[b].empty()) groups[b].rows.clear();
  std::erase_if(groups, [](const Group& group) { return group.rows.empty(); });
  return groups;
}

/// The unit vectors of the blocks' Q1, n x (rows of the blocks).
SparseMatrix spanOf(const Group& group, Index unknownCount)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  int column = 0;
  for (const BlockElimination::Block* block : group.blocks)
    for (int k = 0; k < block->Q1.outerSize(); ++k, ++column)
      for (SparseMatrix::InnerIterator entry(block->Q1, k); entry; ++entry)
        entries.emplace_back(static_cast<int>(block->unknowns[entry.row()]), column, entry.value());
  SparseMatrix span(unknownCount, column);
  span.setFromTriplets(entries.begin(), entries.end());
  return span;
}

SparseMatrix rowsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& some, Index unknownCount)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::size_t k = 0; k < some.size(); ++k)
    for (const Term& term : rows[some[k]])
      entries.emplace_back(static_cast<int>(k), static_cast<int>(term.index), term.coefficient);
  SparseMatrix result(static_cast<Index>(some.size()), unknownCount);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// y of least |M y - d|, M of full column rank, by corrected semi-normal equations (Björck, 1987): Q would be as large
/// as the rows are many, squared.
Columns3 leastSquares(SparseMatrix M, const Columns3& d)
{
  const SparseMatrix original = M;
  const Eigen::VectorXd lengths = normalizeColumns(M);
  const SparseQrResult qr = sparseQr(M, -1, WantQ::No);
  const SparseMatrix R = qr.R.leftCols(qr.rank);
  const auto solve = [&](const Columns3& residual) {
    const Columns3 right = M.transpose() * residual;
    Columns3 x(qr.rank, 3);
    for (Index k = 0; k < qr.rank; ++k) x.row(k) = right.row(qr.columns[k]);
    R.transpose().triangularView<Eigen::Lower>().solveInPlace(x);
    R.triangularView<Eigen::Upper>().solveInPlace(x);
    Columns3 y = Columns3::Zero(M.cols(), 3);
    for (Index k = 0; k < qr.rank; ++k) y.row(qr.columns[k]) = x.row(k) / lengths[qr.columns[k]];
    return y;
  };
  Columns3 y = solve(d);
  for (int correction = 0; correction < kCorrections; ++correction) y += solve(d - original * y);
  return y;
}

}  // namespace

Columns3 reconciled(const BlockElimination& elimination, const std::vector<RowTerms>& rows,
                    const std::vector<Index>& redundant, const Columns3& d)
{
  Columns3 u = elimination.particular(d);
  const std::vector<Index> blockOf = blockOfUnknowns(elimination);
  for (const Group& group : groupsOf(elimination.blocks(), rows, redundant, blockOf)) {
    // What the group's blocks hold is found anew; what pins hold is known.
    for (const BlockElimination::Block* block : group.blocks)
      for (const Index unknown : block->unknowns) u.row(unknown).setZero();
    const SparseMatrix B = rowsOf(rows, group.rows, u.rows());
    const SparseMatrix span = spanOf(group, u.rows());
    Columns3 asked(B.rows(), 3);
    for (std::size_t k = 0; k < group.rows.size(); ++k) asked.row(k) = d.row(group.rows[k]);
    u += span * leastSquares(B * span, asked - B * u);
  }
  return u;
}

}  // namespace holdfast
