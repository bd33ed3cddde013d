#pragma once
/// How each constraint fared, read off positions.

#include <algorithm>

#include <holdfast/base/parallel.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>

namespace holdfast {

/// |B x - d| of every row for the file's vertices at `positions`, model units.
[[nodiscard]] std::vector<double> rowResiduals(const ConstraintSystem& system, const Weld& weld,
                                               const Positions& positions);

/// The labels of a list: `known`, those of the list before it, where they are the same. O(constraints).
[[nodiscard]] std::shared_ptr<const ConstraintLabels> labelsOf(const ConstraintList& list,
                                                               std::shared_ptr<const ConstraintLabels> known);

/// The largest sensitivity of each constraint's independent rows and of the terms of its dependent ones; none without
/// rows.
[[nodiscard]] std::vector<std::optional<double>> constraintSensitivities(const DeformDetails& details);

/// One outcome for each constraint, in order, with the residuals of rows at positions as they are, or will be, stored:
/// missed where one exceeds its limit, else met. Where `residuals` is empty nothing was solved.
[[nodiscard]] std::vector<ConstraintOutcome> outcomes(const DeformDetails& details,
                                                      const std::vector<double>& residuals);

/// Whether the result misses a row by more than the row's limit.
[[nodiscard]] inline bool isMissed(const DeformDetails& details, Index row)
{
  return details.residuals[row] > details.diagnosis.limits[row];
}

/// How a row fared at the positions of the result: conflicting, missed, redundant or met.
[[nodiscard]] ConstraintStatus rowStatus(const DeformDetails& details, Index row);

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

/// Sets the largest residual in `report`. Returns the row that exceeds its limit most, as a share of it, if any does.
std::optional<MissedRow> setLargestResidual(Report& report, const DeformDetails& details,
                                            const std::vector<double>& residuals);

/// What is said of `result` for a reader of a file that stores its positions in single precision: residuals and what
/// follows from them. Returns whether a row is missed.
bool setRoundedResiduals(Report& report, const DeformResult& result, const Weld& weld);

}  // namespace holdfast
