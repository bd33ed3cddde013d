#include "holdfast/elimination/free_parts.h"

#include <utility>

#include <holdfast/elimination/own_unknowns.h>
#include <holdfast/elimination/row_matching.h>
#include <holdfast/elimination/sequential_qr.h>
#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {
namespace {

SparseMatrix denseBasis(const SparseMatrix& block)
{
  SequentialQr qr(block.rows(), block.cols());
  for (Index k = 0; k < block.cols(); ++k) static_cast<void>(qr.append(Eigen::VectorXd(block.col(k))));
  const Index free = block.rows() - qr.rank();
  Eigen::MatrixXd last = Eigen::MatrixXd::Zero(block.rows(), free);
  last.bottomRows(free).setIdentity();
  return qr.applyQ(std::move(last)).sparseView(1, 0);
}

SparseMatrix wholeBasis(const FreePart& part)
{
  if (part.kept.empty()) return part.basis;
  constexpr double kAcceptAll = -1;
  SparseMatrix block = part.block;
  static_cast<void>(normalizeColumns(block));
  return sparseQr(block, kAcceptAll, WantQ::Yes).Q.columnsFrom(block.cols());
}

FreePart partOf(RowComponent component, const std::vector<RowTerms>& rows)
{
  SparseMatrix block = transposedBlock(rows, component);
  FreePart part{std::move(component), {}, {}, {}};
  if (isDense(part.component)) {
    part.basis = denseBasis(block);
    return part;
  }
  part.block = std::move(block);
  SubstitutedRows left =
      substituted(localRows(rows, part.component), static_cast<Index>(part.component.unknowns.size()));
  for (const Index row : left.kept) part.kept.push_back(part.component.rows[row]);
  part.basis = std::move(left.basis);
  return part;
}

/// `of(part)` gives the columns of each.
template <class Basis>
SparseMatrix assembledBasis(const std::vector<FreePart>& parts, Index unknownCount, const Basis& of)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  Index columns = 0;
  for (const FreePart& part : parts) {
    const SparseMatrix& basis = of(part);
    for (Index k = 0; k < basis.cols(); ++k)
      for (SparseMatrix::InnerIterator entry(basis, k); entry; ++entry)
        entries.emplace_back(static_cast<int>(part.component.unknowns[entry.row()]), static_cast<int>(columns + k),
                             entry.value());
    columns += basis.cols();
  }
  SparseMatrix result(unknownCount, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

std::vector<FreePart> freeParts(const std::vector<RowTerms>& rows, Index unknownCount)
{
  const std::vector<bool> isFree = freeUnknowns(rows, unknownCount);
  std::vector<RowTerms> free(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Term& term : rows[r])
      if (isFree[term.index]) free[r].push_back(term);
  std::vector<FreePart> parts;
  for (RowComponent& component : connectedRows(free, unknownCount)) parts.push_back(partOf(std::move(component), free));
  return parts;
}

SparseMatrix basisOf(const std::vector<FreePart>& parts, Index unknownCount)
{
  return assembledBasis(parts, unknownCount, [](const FreePart& part) -> const SparseMatrix& { return part.basis; });
}

SparseMatrix wholeBasisOf(const std::vector<FreePart>& parts, Index unknownCount)
{
  return assembledBasis(parts, unknownCount, wholeBasis);
}

}  // namespace holdfast
