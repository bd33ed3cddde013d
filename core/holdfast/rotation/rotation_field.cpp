#include "holdfast/rotation/rotation_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

/// By representative: the first place in `prescribed` of an unknown of its set; -1 elsewhere.
std::vector<Index> firstGiven(DisjointSets& sets, const RotationProblem& problem)
{
  std::vector<Index> first(static_cast<std::size_t>(problem.unknownCount), -1);
  for (Index k = static_cast<Index>(problem.prescribed.size()) - 1; k >= 0; --k)
    first[sets.find(problem.prescribed[k])] = k;
  return first;
}

/// By unknown: its own place in `prescribed`, else that of its region; -1 elsewhere.
std::vector<Index> givenOfUnknowns(DisjointSets& regions, const std::vector<Index>& ofRegion,
                                   const RotationProblem& problem)
{
  std::vector<Index> given(static_cast<std::size_t>(problem.unknownCount));
  for (Index i = 0; i < problem.unknownCount; ++i) given[i] = ofRegion[regions.find(i)];
  for (Index k = static_cast<Index>(problem.prescribed.size()) - 1; k >= 0; --k) given[problem.prescribed[k]] = k;
  return given;
}

/// Numbers the columns by the last of their unknowns, see `orderedColumns`.
void orderColumns(RotationUnknowns& unknowns, const std::vector<int>& ranks)
{
  std::vector<int> last(unknowns.referenceOf.size(), -1);
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (const Index column = unknowns.columnOf[i]; column >= 0) last[column] = std::max(last[column], ranks[i]);
  const std::vector<int> order = ascending(last, static_cast<int>(ranks.size()));
  std::vector<Index> place(order.size());
  std::vector<Index> referenceOf(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = static_cast<Index>(k);
    referenceOf[k] = unknowns.referenceOf[order[k]];
  }
  for (Index& column : unknowns.columnOf)
    if (column >= 0) column = place[column];
  unknowns.referenceOf = std::move(referenceOf);
}

/// In a region where several unknowns are given, each keeps its own value, and all others have that of the first. For
/// an unknown that is given twice, the first value counts. Edges of weight 0 tie nothing. Ids are in range.
RotationUnknowns rotationUnknowns(const RotationProblem& problem)
{
  DisjointSets regions(problem.unknownCount);
  regions.uniteEach(problem.rigidRegions);
  DisjointSets parts = regions;
  for (const EdgeWeight& edge : problem.weights)
    if (edge.weight != 0) parts.unite(edge.i, edge.j);
  const std::vector<Index> ofRegion = firstGiven(regions, problem);
  const std::vector<Index> ofPart = firstGiven(parts, problem);

  RotationUnknowns result;
  result.givenOf = givenOfUnknowns(regions, ofRegion, problem);
  for (const Index unknown : problem.prescribed) result.leaderOf.push_back(ofRegion[regions.find(unknown)]);
  result.columnOf.assign(result.givenOf.size(), -1);
  for (Index i = 0; i < problem.unknownCount; ++i) {
    const Index reference = ofPart[parts.find(i)];
    if (result.givenOf[i] >= 0 || reference < 0) continue;
    const Index first = regions.find(i);
    if (first == i) result.referenceOf.push_back(reference);
    result.columnOf[i] = first == i ? result.columnCount() - 1 : result.columnOf[first];
  }
  if (!problem.ranks.empty()) orderColumns(result, problem.ranks);
  return result;
}

/// C z is to be near the sum of the pulls, z being how far the free rotations are from those that `referenceOf` names:
/// where all that are given agree, z is 0 without rounding.
struct RotationSystem {
  SparseMatrix C;  ///< rows x columnCount
  std::vector<RotationPull> pulls;
};

/// Rows by their largest coefficient: beside slivers they differ by many powers of ten.
void scaleRows(RotationSystem& system)
{
  Eigen::VectorXd size = Eigen::VectorXd::Zero(system.C.rows());
  for (Index k = 0; k < system.C.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(system.C, k); entry; ++entry)
      size[entry.row()] = std::max(size[entry.row()], std::abs(entry.value()));
  const Eigen::VectorXd scale = size.unaryExpr([](double x) { return x > 0 ? 1 / x : 1.0; });
  system.C = scaledRows(scale, std::move(system.C));
  for (RotationPull& pull : system.pulls) pull.weight *= scale[pull.row];
}

/// A row for each edge with a free end, sqrt(w_ij) (q_i - q_j): least squares of them minimise the Dirichlet energy. No
/// weight is negative.
RotationSystem energyRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns)
{
  const auto forEachRow = [&](const auto& visit) {
    Index row = 0;
    for (auto [i, j, weight] : weights) {
      if (unknowns.columnOf[i] < 0) std::swap(i, j);
      const Index column = unknowns.columnOf[i];
      if (column >= 0 && column != unknowns.columnOf[j] && weight != 0) visit(row++, column, j, std::sqrt(weight));
    }
  };
  RotationSystem system;
  Index rows = 0;
  forEachRow([&](Index row, Index column, Index j, double root) {
    rows = row + 1;
    if (unknowns.columnOf[j] < 0)
      system.pulls.push_back({row, root, unknowns.givenOf[j], unknowns.referenceOf[column]});
  });
  system.C = sparseMatrix<SparseMatrix>(rows, unknowns.columnCount(), 1, [&](Index /*part*/, const auto& add) {
    forEachRow([&](Index row, Index column, Index j, double root) {
      add(row, column, root);
      if (unknowns.columnOf[j] >= 0) add(row, unknowns.columnOf[j], -root);
    });
  });
  return system;
}

/// A row for each column, the sum of w_ij (q_i - q_j) over its unknowns and their neighbours, of L q = 0, (25), by the
/// size of its largest coefficient. Square, for weights of any sign.
RotationSystem balanceRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns)
{
  RotationSystem system;
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(4 * weights.size());
  const auto add = [&](Index row, Index column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  const auto addEnd = [&](Index i, Index j, double weight) {
    const Index column = unknowns.columnOf[i];
    if (column < 0) return;
    add(column, column, weight);
    if (unknowns.columnOf[j] >= 0)
      add(column, unknowns.columnOf[j], -weight);
    else
      system.pulls.push_back({column, weight, unknowns.givenOf[j], unknowns.referenceOf[column]});
  };
  for (const auto& [i, j, weight] : weights) {
    if (unknowns.columnOf[i] == unknowns.columnOf[j] || weight == 0) continue;
    addEnd(i, j, weight);
    addEnd(j, i, weight);
  }
  system.C.resize(unknowns.columnCount(), unknowns.columnCount());
  system.C.setFromTriplets(entries.begin(), entries.end());
  scaleRows(system);
  return system;
}

std::vector<RotationGap> rotationGaps(const RotationUnknowns& unknowns, const Columns3& values)
{
  std::vector<RotationGap> gaps;
  for (Index k = 0; k < values.rows(); ++k) {
    const Vector3 difference = values.row(k) - values.row(unknowns.leaderOf[k]);
    if (!difference.isZero(0)) gaps.push_back({k, unknowns.leaderOf[k], difference});
  }
  return gaps;
}

/// Values that differ: which each row is, and the first row of each.
struct DistinctRows {
  std::vector<int> valueOf;
  std::vector<Index> first;
};

/// Nothing where there are more than `most`.
std::optional<DistinctRows> distinctRows(const Columns3& values, std::size_t most)
{
  DistinctRows result;
  for (Index k = 0; k < values.rows(); ++k) {
    const auto isSame = [&](Index first) { return values.row(first) == values.row(k); };
    const auto found = std::ranges::find_if(result.first, isSame);
    result.valueOf.push_back(static_cast<int>(found - result.first.begin()));
    if (found == result.first.end()) result.first.push_back(k);
    if (result.first.size() > most) return std::nullopt;
  }
  return result;
}

std::string notFiniteMessage(const EdgeWeight& edge)
{
  return fmt::format(
      "the weight of the edge between unknowns {} and {} is not finite, because a face there has no area; use the "
      "weights \"cotangent\" or repair that face",
      edge.i, edge.j);
}

}  // namespace

RotationFieldSolver::RotationFieldSolver(RotationUnknowns unknowns, std::vector<RotationPull> pulls,
                                         ScaledColumns scaled, std::unique_ptr<const LeastSquaresFactor> factor)
    : unknowns_(std::move(unknowns)), pulls_(std::move(pulls)), scaled_(std::move(scaled)), factor_(std::move(factor))
{
  for (std::size_t i = 0; i < unknowns_.givenOf.size(); ++i) {
    const Index column = unknowns_.columnOf[i];
    baseOf_.push_back(static_cast<int>(column >= 0 ? unknowns_.referenceOf[column] : unknowns_.givenOf[i]));
  }
}

RotationField RotationFieldSolver::solve(const Columns3& values) const
{
  assert(values.rows() == static_cast<Index>(unknowns_.leaderOf.size()));
  // The field is linear in the given values: where few differ, as for a few handles, a solution says how far the
  // difference of each from the first reaches, and stays right as long as the same are equal.
  constexpr Index kResponses = 3;
  Eigen::Matrix3d differences = Eigen::Matrix3d::Identity();
  const std::optional<DistinctRows> distinct = distinctRows(values, kResponses + 1);
  if (distinct) {
    differences.setZero();
    for (std::size_t k = 1; k < distinct->first.size(); ++k)
      differences.row(static_cast<Index>(k) - 1) = values.row(distinct->first[k]) - values.row(0);
    if (response_.valueOf != distinct->valueOf) {
      Columns3 isValue(values.rows(), 3);
      for (Index k = 0; k < isValue.rows(); ++k)
        for (int column = 0; column < kResponses; ++column) isValue(k, column) = distinct->valueOf[k] == column + 1;
      response_ = {distinct->valueOf, pulled(isValue)};
    }
  } else {
    response_ = {{}, pulled(values)};
  }
  const Columns3& reach = response_.reach.z;
  RotationField field{Columns3(reach.rows(), 3), response_.reach.accuracy, rotationGaps(unknowns_, values)};
  parallelBlocks(reach.rows(), [&](Index i) {
    field.q.row(i).setZero();
    if (baseOf_[i] >= 0) field.q.row(i) = values.row(baseOf_[i]) + reach.row(i) * differences;
  });
  return field;
}

CorrectedSolution RotationFieldSolver::pulled(const Columns3& values) const
{
  Columns3 f = Columns3::Zero(scaled_.C.rows().rows(), 3);
  for (const auto& [row, weight, given, reference] : pulls_)
    f.row(row) += weight * (values.row(given) - values.row(reference));
  CorrectedSolution result = correctedSolve(*factor_, scaled_.C, scaled_.scale, f);
  Columns3 ofUnknowns(static_cast<Index>(unknowns_.columnOf.size()), 3);
  parallelBlocks(ofUnknowns.rows(), [&](Index i) {
    const Index column = unknowns_.columnOf[i];
    ofUnknowns.row(i).setZero();
    if (column >= 0) ofUnknowns.row(i) = scaled_.scale[column] * result.z.row(column);
  });
  result.z = std::move(ofUnknowns);
  return result;
}

RotationFieldResult makeRotationFieldSolver(const RotationProblem& problem, Backend backend)
{
  for (const EdgeWeight& edge : problem.weights)
    if (!std::isfinite(edge.weight)) return {nullptr, notFiniteMessage(edge)};
  RotationUnknowns unknowns = rotationUnknowns(problem);
  const bool hasNegative =
      std::any_of(problem.weights.begin(), problem.weights.end(), [](const auto& edge) { return edge.weight < 0; });
  RotationSystem system = hasNegative ? balanceRows(problem.weights, unknowns) : energyRows(problem.weights, unknowns);
  Result<ScaledColumns> columns = scaleColumns(std::move(system.C));
  if (!columns) return {nullptr, "the rotation field: " + columns.failure};
  ScaledColumns& scaled = columns.value;
  // A common rotation: what edges resist least, and so the hardest to find.
  const Columns3 probe = scaled.scale.cwiseInverse().replicate(1, 3);
  FactorResult result = factorize(scaled.C, backend, probe,
                                  problem.ranks.empty() ? EliminationOrder::ToBeFound : EliminationOrder::OfColumns);
  if (!result) return {nullptr, "the rotation field: " + result.failure};
  return {std::make_unique<RotationFieldSolver>(std::move(unknowns), std::move(system.pulls), std::move(scaled),
                                                std::move(result.value))};
}

}  // namespace holdfast
