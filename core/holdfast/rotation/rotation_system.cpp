#include "holdfast/rotation/rotation_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace holdfast {
namespace {

using Entries = std::vector<Eigen::Triplet<double, int>>;

void addEntry(Entries& entries, Index row, Index column, double value)
{
  entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
}

SparseMatrix matrixOf(const Entries& entries, Index rows, Index columns)
{
  SparseMatrix result(rows, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Adds `weight` times the end `j` of an edge, seen from the column `from`, to equation `row`: as an entry where it is
/// free, as a pull where it is given.
void addNeighbour(RotationSystem& system, Entries& entries, const RotationUnknowns& unknowns, Index row, Index from,
                  Index j, double weight)
{
  if (unknowns.columnOf[j] >= 0)
    addEntry(entries, row, unknowns.columnOf[j], -weight);
  else
    system.pulls.push_back({row, weight, unknowns.givenOf[j], unknowns.referenceOf[from]});
}

/// Rows by their largest coefficient: beside slivers they differ by many powers of ten.
void scaleRows(RotationSystem& system)
{
  Eigen::VectorXd size = Eigen::VectorXd::Zero(system.C.rows());
  for (Index k = 0; k < system.C.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(system.C, k); entry; ++entry)
      size[entry.row()] = std::max(size[entry.row()], std::abs(entry.value()));
  const Eigen::VectorXd scale = size.unaryExpr([](double x) { return x > 0 ? 1 / x : 1.0; });
  system.C = scale.asDiagonal() * system.C;
  for (RotationPull& pull : system.pulls) pull.weight *= scale[pull.row];
}

}  // namespace

RotationSystem energyRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns)
{
  RotationSystem system;
  Entries entries;
  entries.reserve(2 * weights.size());
  Index row = 0;
  for (auto [i, j, weight] : weights) {
    if (unknowns.columnOf[i] < 0) std::swap(i, j);
    const Index column = unknowns.columnOf[i];
    if (column < 0 || column == unknowns.columnOf[j] || weight == 0) continue;
    addEntry(entries, row, column, std::sqrt(weight));
    addNeighbour(system, entries, unknowns, row, column, j, std::sqrt(weight));
    ++row;
  }
  system.C = matrixOf(entries, row, unknowns.columnCount());
  return system;
}

RotationSystem balanceRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns)
{
  RotationSystem system;
  Entries entries;
  entries.reserve(4 * weights.size());
  const auto addEnd = [&](Index i, Index j, double weight) {
    const Index column = unknowns.columnOf[i];
    if (column < 0) return;
    addEntry(entries, column, column, weight);
    addNeighbour(system, entries, unknowns, column, column, j, weight);
  };
  for (const auto& [i, j, weight] : weights) {
    if (unknowns.columnOf[i] == unknowns.columnOf[j] || weight == 0) continue;
    addEnd(i, j, weight);
    addEnd(j, i, weight);
  }
  system.C = matrixOf(entries, unknowns.columnCount(), unknowns.columnCount());
  scaleRows(system);
  return system;
}

}  // namespace holdfast
