#include "holdfast/elimination/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <holdfast/matrices/largest_size.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

std::vector<RowTerms> termsOf(const ConstraintSystem& system)
{
  std::vector<RowTerms> rows;
  rows.reserve(system.rows.size());
  for (const ConstraintRow& row : system.rows) rows.push_back(row.terms);
  return rows;
}

/// Tells whether the row says where something is, not only how far two things are apart.
bool isPositional(const RowTerms& row)
{
  double sum = 0;
  for (const Term& term : row) sum += term.coefficient;
  return std::abs(sum) > kCoefficientThreshold;
}

/// Unknowns of connected parts, loose unknowns among them, that no row places, not even by way of other parts.
///
/// A part that shifts takes others along by differences, and shifts them the opposite way by sums of two of its own and
/// of theirs, as mirrors ask for. So each part is there twice: it and its opposite. A part is placed where it would
/// have to be its own opposite.
std::vector<bool> unplacedUnknowns(const std::vector<RowTerms>& rows, const SolverMesh& mesh)
{
  const Index count = mesh.componentCount + mesh.unknownCount();
  const auto partOf = [&](Index unknown) {
    const Index component = mesh.componentOf[unknown];
    return component >= 0 ? component : mesh.componentCount + unknown;
  };
  DisjointSets parts(2 * count);
  for (const RowTerms& row : rows) {
    if (row.empty()) continue;
    const Index first = partOf(row.front().index);
    const Index opposite = isPositional(row) ? count : 0;
    if (row.size() == 1) parts.unite(first, first + count);
    for (std::size_t k = 1; k < row.size(); ++k) {
      const Index other = partOf(row[k].index);
      parts.unite(first, other + opposite);
      parts.unite(first + count, other + count - opposite);
    }
  }
  std::vector<bool> isHeld(static_cast<std::size_t>(mesh.unknownCount()), false);
  for (Index u = 0; u < mesh.unknownCount(); ++u) isHeld[u] = parts.find(partOf(u)) != parts.find(partOf(u) + count);
  return isHeld;
}

constexpr double kShare = kPromisedSpacings * std::numeric_limits<double>::epsilon();

double largestCoordinate(const Vector3& place)
{
  return place.cwiseAbs().maxCoeff();
}

/// The largest coordinate of the sum of |w_i| |x_i|, of which the rounding of B x is a few epsilon; x is `rest`
/// displaced by `u`, which may have no rows.
double largestSum(const FewTerms& row, const Positions& rest, const Columns3& u)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const Term& term : row) {
    Eigen::RowVector3d x = rest.row(term.index);
    if (u.rows() > 0) x += u.row(term.index);
    sum += std::abs(term.coefficient) * x.cwiseAbs();
  }
  return largestCoordinate(sum);
}

double largestTarget(const ConstraintSystem& system)
{
  return largestOfBlocks(static_cast<Index>(system.rows.size()), [&](Index first, Index count) {
    double largest = 0;
    for (Index r = first; r < first + count; ++r) largest = std::max(largest, largestCoordinate(system.rows[r].target));
    return largest;
  });
}

/// Tells whether every limit is the promised residual. The sizes of a row's weights sum to 2 at most: near the origin
/// no sum is large enough to count.
bool isNearOrigin(const SolverMesh& mesh, const ConstraintSystem& system)
{
  return kShare * std::max(largestTarget(system), 2 * mesh.largestCoordinate) <= kPromisedResidual * mesh.diagonal;
}

/// The largest of each row's own numbers, see `residualLimits`.
std::vector<double> magnitudes(const SolverMesh& mesh, const ConstraintSystem& system, const Columns3& u)
{
  const double asked = largestTarget(system);
  std::vector<double> sizes(system.rows.size());
  parallelBlocks(static_cast<Index>(sizes.size()), [&](Index r) {
    const ConstraintRow& row = system.rows[r];
    sizes[r] = std::max(largestCoordinate(row.target), largestSum(row.terms, mesh.rest, {}));
    if (u.rows() > 0) sizes[r] = std::max(sizes[r], std::min(asked, largestSum(row.terms, mesh.rest, u)));
  });
  return sizes;
}

/// The rows that dependent rows are and depend on, each once, ascending.
std::vector<Index> rowsOf(const std::vector<Dependency>& dependencies)
{
  std::vector<Index> rows;
  for (const Dependency& dependency : dependencies) {
    rows.push_back(dependency.row);
    for (const Term& term : dependency.terms) rows.push_back(term.index);
  }
  return sortedOnce(std::move(rows));
}

Columns3 shiftsOf(const ConstraintSystem& system, const std::vector<Index>& rows)
{
  Columns3 shifts(static_cast<Index>(rows.size()), 3);
  parallelBlocks(shifts.rows(), [&](Index k) { shifts.row(k) = system.rows[rows[k]].shift; });
  return shifts;
}

/// Returns those of `agreeing` that circuits join to one that is `missed`. What is changed to meet the one moves the
/// others, by as much as their coefficients are large: all are met together, or some would be missed in turn.
std::vector<Index> joinedToMissed(const std::vector<Index>& missed, const std::vector<const Dependency*>& agreeing,
                                  const std::vector<RowTerms>& rows)
{
  DisjointSets joined(static_cast<Index>(rows.size()));
  for (const Dependency* dependency : agreeing)
    for (const Term& term : dependency->terms)
      if (rows[term.index].size() > 1) joined.unite(dependency->row, term.index);
  std::vector<bool> isMissed(rows.size(), false);
  for (const Index row : missed) isMissed[joined.find(row)] = true;
  std::vector<Index> result;
  for (const Dependency* dependency : agreeing)
    if (isMissed[joined.find(dependency->row)]) result.push_back(dependency->row);
  return result;
}

/// How far the smallest change of targets that closes a gap is below the gap: |(1, -a)| of b_j = sum a_k b_k, over the
/// rows that are no pins.
double gapPerChange(const EliminatedConstraints& eliminated, const Dependency& dependency)
{
  double squares = 1;
  for (const Term& term : dependency.terms)
    if (eliminated.rows[term.index].size() > 1) squares += term.coefficient * term.coefficient;
  return std::sqrt(squares);
}

/// What a row that is no exact combination of others may miss of the shortest displacement, though a longer one that
/// moves vertices as far as rows ask for meets it with them.
double undecidedGap(const Dependency& dependency, const ConstraintSystem& system)
{
  if (!dependency.isUndecided()) return 0;
  double asked = system.rows[dependency.row].shift.stableNorm();
  for (const Term& term : dependency.terms) asked = std::max(asked, system.rows[term.index].shift.stableNorm());
  return dependency.distance * asked;
}

/// What each dependent row misses of a displacement `u` that meets the independent ones: its gap. Read off there, it is
/// free of the rounding of the coefficients a_k.
std::vector<DependentRow> gapsOf(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                 const Columns3& u)
{
  std::vector<DependentRow> result;
  result.reserve(eliminated.dependencies.size());
  for (const Dependency& dependency : eliminated.dependencies) {
    Vector3 gap = system.rows[dependency.row].shift;
    for (const Term& term : system.rows[dependency.row].terms) gap -= term.coefficient * u.row(term.index).transpose();
    result.push_back({dependency, gap});
  }
  return result;
}

}  // namespace

bool Diagnosis::hasConflicts() const
{
  return std::find(status.begin(), status.end(), RowStatus::Conflicting) != status.end();
}

std::vector<double> residualLimits(const SolverMesh& mesh, const ConstraintSystem& system,
                                   const std::vector<DependentRow>& dependent, const Columns3& u)
{
  const std::vector<double> own = magnitudes(mesh, system, u);
  std::vector<double> limits = own;
  for (const auto& [dependency, gap, isConflicting] : dependent)
    for (const Term& term : dependency.terms)
      limits[dependency.row] = std::max(limits[dependency.row], own[term.index]);
  for (double& limit : limits) limit = std::max(kPromisedResidual * mesh.diagonal, kShare * limit);
  return limits;
}

EliminatedConstraints eliminate(const ConstraintSystem& system, const SolverMesh& mesh, double tolerance)
{
  std::vector<RowTerms> rows = termsOf(system);
  std::vector<bool> isHeld = unplacedUnknowns(rows, mesh);
  // Vertices at rest have no unknowns: their rows hold if the displacement that they ask for is 0.
  for (RowTerms& row : rows)
    if (!row.empty() && isHeld[row.front().index]) row.clear();
  std::vector<Dependency> dependencies = findDependencies(rows, mesh.unknownCount(), tolerance);
  Elimination elimination(rows, independentRows(dependencies, rows.size()), mesh.unknownCount(), isHeld);
  return {std::move(rows), std::move(dependencies), std::move(isHeld), std::move(elimination)};
}

Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system, const SolverMesh& mesh,
                   KnownGaps& known)
{
  Diagnosis diagnosis;
  RowTargets& targets = diagnosis.targets.emplace_back();
  targets.shifts = shiftsOf(system);
  diagnosis.isNearOrigin = isNearOrigin(mesh, system);
  diagnosis.status.assign(system.rows.size(), RowStatus::Independent);
  if (!eliminated.dependencies.empty()) {
    if (known.rows.empty()) known.rows = rowsOf(eliminated.dependencies);
    Columns3 shifts = shiftsOf(system, known.rows);
    // Limits of other rows need the displacement.
    if (known.gaps.empty() || known.shifts != shifts || !diagnosis.isNearOrigin) {
      targets.particular = eliminated.elimination.particular(targets.shifts);
      known.shifts = std::move(shifts);
      known.gaps = gapsOf(eliminated, system, targets.particular);
    }
    diagnosis.dependent = known.gaps;
  }
  diagnosis.limits = diagnosis.isNearOrigin ? std::vector<double>(system.rows.size(), kPromisedResidual * mesh.diagonal)
                                            : residualLimits(mesh, system, diagnosis.dependent, targets.particular);
  std::vector<const Dependency*> agreeing;
  std::vector<Index> missed;
  for (auto& [dependency, gap, isConflicting] : diagnosis.dependent) {
    const double limit = kConsistentShare * diagnosis.limits[dependency.row];
    const bool agrees = gap.stableNorm() <= limit * gapPerChange(eliminated, dependency);
    const bool mayAgree = agrees || gap.stableNorm() <= undecidedGap(dependency, system);
    isConflicting = !mayAgree;
    diagnosis.status[dependency.row] = mayAgree ? RowStatus::Redundant : RowStatus::Conflicting;
    if (agrees) agreeing.push_back(&dependency);
    if (agrees && gap.stableNorm() > limit) missed.push_back(dependency.row);
  }
  if (!missed.empty()) targets.reconciled = joinedToMissed(missed, agreeing, eliminated.rows);
  return diagnosis;
}

std::vector<double> agreeingGaps(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                 const SolverMesh& mesh)
{
  std::vector<double> limits(system.rows.size(), kPromisedResidual * mesh.diagonal);
  if (!isNearOrigin(mesh, system)) {
    std::vector<DependentRow> dependent;
    for (const Dependency& dependency : eliminated.dependencies) dependent.push_back({dependency, Vector3::Zero()});
    limits = residualLimits(mesh, system, dependent, {});
  }
  std::vector<double> result;
  for (const Dependency& dependency : eliminated.dependencies)
    result.push_back(kConsistentShare * limits[dependency.row] * gapPerChange(eliminated, dependency));
  return result;
}

Columns3 shiftsOf(const ConstraintSystem& system)
{
  Columns3 shifts(static_cast<Index>(system.rows.size()), 3);
  parallelBlocks(shifts.rows(), [&](Index r) { shifts.row(r) = system.rows[r].shift; });
  return shifts;
}

}  // namespace holdfast
