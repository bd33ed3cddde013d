#include <algorithm>
#include <limits>
#include <utility>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/elimination/find_dependencies.h>

namespace holdfast {
namespace {

std::vector<RowTerms> termsOf(const ConstraintSystem& system)
{
  std::vector<RowTerms> rows;
  rows.reserve(system.rows.size());
  for (const ConstraintRow& row : system.rows) rows.push_back(row.terms);
  return rows;
}

std::vector<bool> unknownsWithoutRows(const std::vector<RowTerms>& rows, const SolverMesh& mesh)
{
  std::vector<bool> isAnchored(static_cast<std::size_t>(mesh.componentCount), false);
  std::vector<bool> isHeld(static_cast<std::size_t>(mesh.unknownCount()), true);
  for (const RowTerms& row : rows)
    for (const PointTerm& term : row) {
      isHeld[term.vertex] = false;
      if (const Index component = mesh.componentOf[term.vertex]; component >= 0) isAnchored[component] = true;
    }
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (mesh.componentOf[u] >= 0) isHeld[u] = !isAnchored[mesh.componentOf[u]];
  return isHeld;
}

double largestCoordinate(const SolverMesh& mesh, const ConstraintSystem& system)
{
  double largest = mesh.rest.size() == 0 ? 0 : mesh.rest.cwiseAbs().maxCoeff();
  for (const ConstraintRow& row : system.rows) largest = std::max(largest, row.target.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

bool Diagnosis::hasConflicts() const
{
  return std::find(status.begin(), status.end(), RowStatus::Conflicting) != status.end();
}

double residualLimit(const SolverMesh& mesh, const ConstraintSystem& system)
{
  const double spacing = std::numeric_limits<double>::epsilon() * largestCoordinate(mesh, system);
  return std::max(2 * kConsistentGap * mesh.diagonal, 8 * spacing);
}

EliminatedConstraints eliminate(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::vector<RowTerms> rows = termsOf(system);
  std::vector<Dependency> dependencies = findDependencies(rows, mesh.unknownCount());
  std::vector<bool> isHeld = unknownsWithoutRows(rows, mesh);
  Elimination elimination(rows, independentRows(dependencies, rows.size()), mesh.unknownCount(), isHeld);
  return {std::move(rows), std::move(dependencies), std::move(isHeld), std::move(elimination)};
}

Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system, const SolverMesh& mesh)
{
  Diagnosis diagnosis;
  diagnosis.status.assign(system.rows.size(), RowStatus::Independent);
  if (eliminated.dependencies.empty()) return diagnosis;
  // Of a displacement that meets the independent rows, what a dependent row misses is its gap; reading it there avoids
  // the rounding of the coefficients a_k.
  const double limit = residualLimit(mesh, system) / 2;
  const Columns3 u = eliminated.elimination.particular(shiftsOf(system));
  for (const Dependency& dependency : eliminated.dependencies) {
    const ConstraintRow& row = system.rows[dependency.row];
    Vector3 gap = row.shift;
    for (const PointTerm& term : row.terms) gap -= term.weight * u.row(term.vertex).transpose();
    diagnosis.status[dependency.row] = gap.norm() <= limit ? RowStatus::Redundant : RowStatus::Conflicting;
    diagnosis.dependent.push_back({dependency, gap});
  }
  return diagnosis;
}

Columns3 shiftsOf(const ConstraintSystem& system)
{
  Columns3 shifts(static_cast<Index>(system.rows.size()), 3);
  for (std::size_t r = 0; r < system.rows.size(); ++r) shifts.row(r) = system.rows[r].shift.transpose();
  return shifts;
}

}  // namespace holdfast
