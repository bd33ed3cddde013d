#include "holdfast/deform/determined_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <holdfast/matrices/largest_size.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// A row rounds each of its sums by about an epsilon. Measured errors of rows with sensitivities of 10 to 1e12 were up
// to 2.7 times the sensitivity times that; the sensitivities of large blocks are estimates themselves.
constexpr double kSumRoundings = 5;

// Where many rows are nearly dependent the bound is far above the errors: up to this it is no matter.
constexpr double kBoundIsEnough = 1e-12;

// The step is the shortest that meets the rows. What they leave free follows them, and errors were up to 2.3 times as
// large.
constexpr double kStepFactor = 8;

/// Returns the largest coordinate of the target of a row and of the displacements in it, also where these cancel.
double sizeOfRow(const ConstraintRow& row, const Columns3& u)
{
  Eigen::RowVector3d moved = Eigen::RowVector3d::Zero();
  for (const Term& term : row.terms) moved += std::abs(term.coefficient) * u.row(term.index).cwiseAbs();
  return std::max(row.shift.cwiseAbs().maxCoeff(), moved.maxCoeff());
}

/// d - B u. With more digits than the rows are met with, where the machine has them: in doubles it may well be zero.
Columns3 leftOfRows(const ConstraintSystem& system, const Columns3& u)
{
  Columns3 rest(static_cast<Index>(system.rows.size()), 3);
  parallelBlocks(rest.rows(), [&](Index r) {
    const ConstraintRow& row = system.rows[r];
    for (int k = 0; k < 3; ++k) {
      long double left = row.shift[k];
      for (const Term& term : row.terms)
        left -= static_cast<long double>(term.coefficient) * static_cast<long double>(u(term.index, k));
      rest(r, k) = static_cast<double>(left);
    }
  });
  return rest;
}

/// By the sensitivities.
DeterminedPart boundOf(const ConstraintSystem& system, const std::vector<double>& sensitivities, const Columns3& u,
                       double size)
{
  Eigen::VectorXd lost(static_cast<Index>(system.rows.size()));
  parallelBlocks(lost.size(), [&](Index r) {
    lost[r] = sensitivities[r] == 0 ? 0 : sensitivities[r] * sizeOfRow(system.rows[r], u);
  });
  DeterminedPart part;
  if (lost.size() == 0 || !(lost.maxCoeff(&part.row) > 0)) return {};
  part.accuracy = kSumRoundings * std::numeric_limits<double>::epsilon() * lost[part.row] / size;
  return part;
}

}  // namespace

DeterminedPart determinedPart(const ConstraintSystem& system, const std::vector<double>& sensitivities,
                              const AxisSolvers& solvers, const std::vector<RowTargets>& targets, const Columns3& u)
{
  const double size = largestSize(u);
  if (!(size > 0)) return {};
  DeterminedPart part = boundOf(system, sensitivities, u, size);
  if (part.accuracy <= kBoundIsEnough) return part;
  Columns3 step = Columns3::Zero(u.rows(), 3);
  std::vector<RowTargets> left;
  for (Columns3& ofPart : solvers.eliminated().takenApart(leftOfRows(system, u)))
    left.push_back({std::move(ofPart), targets[left.size()].reconciled});
  solvers.meet(left, step);
  part.accuracy = std::clamp(kStepFactor * largestSize(step) / size, kBoundIsEnough, part.accuracy);
  return part;
}

}  // namespace holdfast
