#include "holdfast/constraints/chosen_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraints/axis_systems.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

// A triangle lies along a plane if it rises by no more than this share of its sides.
constexpr double kFlat = 1e-6;

InputLocation placeOfRow(const ConstraintSystem& system, Index row, const std::string& source)
{
  return {source, 0, fmt::format("constraints[{}]", system.rows[row].constraint)};
}

std::string nameOfRow(const ConstraintSystem& system, Index row, const ConstraintList& list)
{
  return inQuotes(list.constraints[system.rows[row].constraint].name);
}

}  // namespace

void chooseRowsAtOdds(ConstraintSystem& system, const ConstraintList& list, const std::string& source)
{
  const std::vector<Index> rows = rowsAtOdds(system.rows);
  if (rows.empty()) return;
  if (rows.size() + system.tolerant.size() > kMostTolerantPoints)
    throw InputError(
        placeOfRow(system, rows.front(), source),
        fmt::format("{}: its direction is neither parallel nor square to those of most others. {} rows of the list are "
                    "so, and more than {} are not solved together; make directions parallel or square, or disable some",
                    nameOfRow(system, rows.front(), list), rows.size(), kMostTolerantPoints));
  for (const Index r : rows) {
    ConstraintRow& row = system.rows[r];
    row.isChosen = true;
    system.tolerant.push_back({r, Exactly{}, row.target, row.shift, {}});
  }
  std::ranges::sort(system.tolerant, {}, &TolerantRow::row);
}

void requireFewTolerant(const ConstraintSystem& system, const ConstraintList& list, const std::string& source)
{
  if (system.tolerant.size() <= kMostTolerantPoints) return;
  const bool isFrameOfCoordinates = commonFrame(system.rows).value_or(Eigen::Matrix3d::Zero()).isIdentity(0);
  const auto together = std::ranges::find_if(system.tolerant, [&](const TolerantRow& tolerant) {
    return !isFrameOfCoordinates || !isByCoordinates(tolerant, system.rows[tolerant.row].directions);
  });
  if (together == system.tolerant.end()) return;
  throw InputError(
      placeOfRow(system, together->row, source),
      fmt::format(
          "{} points have tolerances or weights or lie on surfaces. More than {} are solved together only where "
          "all have boxes, weights, or bounds along x, y or z, and {} has none of these; make some exact, "
          "select fewer, or disable some",
          system.tolerant.size(), kMostTolerantPoints, nameOfRow(system, together->row, list)));
}

std::vector<Index> flatAlong(const SolverMesh& mesh, const std::vector<Index>& unknowns, const Vector3& normal)
{
  std::vector<char> isIn(static_cast<std::size_t>(mesh.unknownCount()), 0);
  for (const Index u : unknowns) isIn[u] = 1;
  std::vector<Index> flat;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (isIn[a] == 0 || isIn[b] == 0 || isIn[c] == 0) continue;
    const Vector3 first = mesh.rest.row(b) - mesh.rest.row(a);
    const Vector3 second = mesh.rest.row(c) - mesh.rest.row(a);
    const double rise = std::max(std::abs(normal.dot(first)), std::abs(normal.dot(second)));
    if (rise <= kFlat * std::max(first.norm(), second.norm())) flat.insert(flat.end(), {a, b, c});
  }
  return sortedOnce(std::move(flat));
}

}  // namespace holdfast
