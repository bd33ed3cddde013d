#pragma once
/// An outcome says how a constraint fared, as positions show it.

#include <algorithm>

#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {

/// Returns |B x - d| of every row for the file's vertices at `positions`, in model units.
[[nodiscard]] std::vector<double> rowResiduals(const ConstraintSystem& system, const Weld& weld,
                                               const Positions& positions);

/// Returns the labels of a list. It returns `known`, the labels of the list before it, where these are the same.
/// O(constraints).
[[nodiscard]] std::shared_ptr<const ConstraintLabels> labelsOf(const ConstraintList& list,
                                                               std::shared_ptr<const ConstraintLabels> known);

/// Returns for each constraint the largest sensitivity of its independent rows and of the terms of its dependent ones.
/// A constraint without rows has none.
[[nodiscard]] std::vector<std::optional<double>> constraintSensitivities(const DeformDetails& details);

/// Returns one outcome for each constraint, in order. `residuals` are those of rows at positions as they are stored, or
/// will be. A constraint is missed where one of them exceeds its limit, else met. Where `residuals` is empty nothing
/// was solved.
[[nodiscard]] std::vector<ConstraintOutcome> outcomes(const DeformDetails& details,
                                                      const std::vector<double>& residuals);

/// Tells whether the result misses a row by more than the row's limit.
[[nodiscard]] inline bool isMissed(const DeformDetails& details, Index row)
{
  return details.residuals[row] > details.diagnosis.limits[row];
}

/// Tells how a row fared at the positions of the result: conflicting, missed, redundant or met.
[[nodiscard]] ConstraintStatus rowStatus(const DeformDetails& details, Index row);

/// A sensitivity above this gets a warning. Then a change of a millionth of the model's size in what is asked for moves
/// the model by its size.
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

/// Counts the constraints that have this status.
[[nodiscard]] Index countOf(const Report& report, ConstraintStatus status);

/// Sets the largest residual in `report`. Returns the row that exceeds its limit most, as a share of the limit, if any
/// does.
std::optional<MissedRow> setLargestResidual(Report& report, const DeformDetails& details,
                                            const std::vector<double>& residuals);

/// Sets the outcomes in `report` to what a reader of a file finds that holds `stored` for the positions of `result`.
/// These are the residuals, and what follows from them. Returns whether a row is missed.
bool setStoredResiduals(Report& report, const DeformResult& result, const Positions& stored, const Weld& weld);

}  // namespace holdfast
