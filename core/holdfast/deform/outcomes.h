#pragma once
/// How each constraint fared, read off positions.

#include <algorithm>

#include <holdfast/base/parallel.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/deform.h>
#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// |B x - d| of every row for the file's vertices at `positions`, model units.
[[nodiscard]] std::vector<double> rowResiduals(const ConstraintSystem& system, const Weld& weld,
                                               const Positions& positions);

/// One outcome for each constraint of the list, in order, before anything is solved: without residuals, and none of
/// them met. `sensitivities` are those of `Elimination::sensitivities`: that of a constraint is the largest of its
/// independent rows and of the terms of its dependent ones.
[[nodiscard]] std::vector<ConstraintOutcome> outcomes(const ConstraintList& list, const ConstraintSystem& system,
                                                      const Diagnosis& diagnosis,
                                                      const std::vector<double>& sensitivities);

/// Sensitivities above this are warned of: a millionth of the model's size in what is asked for moves it by its size.
inline constexpr double kLargeSensitivity = 1e6;

/// Calls `work(c, first, end)` for each of `count` constraints and its rows, over all cores.
template <class Work>
void forEachConstraint(const ConstraintSystem& system, Index count, const Work& work)
{
  constexpr Index kBlock = 1024;
  const auto rows = static_cast<Index>(system.rows.size());
  parallelFor((count + kBlock - 1) / kBlock, [&](Index block) {
    Index c = block * kBlock;
    Index row = std::ranges::lower_bound(system.rows, c, {}, &ConstraintRow::constraint) - system.rows.begin();
    for (; c < std::min(count, (block + 1) * kBlock); ++c) {
      const Index first = row;
      while (row < rows && system.rows[row].constraint == c) ++row;
      work(c, first, row);
    }
  });
}

/// A row that was solved and is not met.
struct MissedRow {
  Index constraint = 0;  ///< place in the list
  double residual = 0;   ///< model units
  double limit = 0;      ///< what it should not exceed
};

/// How many constraints have this status.
[[nodiscard]] Index countOf(const Report& report, ConstraintStatus status);

/// Sets the residuals in `report` from positions as they are, or will be, stored, and the status of constraints that
/// were solved: missed where the residual of a row exceeds its limit in `diagnosis`, else met. Returns the row that
/// exceeds its limit most, as a share of it, if any does.
std::optional<MissedRow> setResiduals(Report& report, const ConstraintSystem& system, const Diagnosis& diagnosis,
                                      const std::vector<double>& residuals);

/// The same for a reader of a file that stores `result.positions` in single precision. Returns whether a row is missed.
bool setRoundedResiduals(Report& report, const DeformResult& result, const Weld& weld);

}  // namespace holdfast
