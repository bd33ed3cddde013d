#pragma once
/// How accurate a solution has to be. An accuracy is the estimated relative error of what constraints leave free.

#include <optional>
#include <string>

#include <holdfast/check/finding.h>

namespace holdfast {

/// Solutions less accurate than this are no answer: in a picture the error would show.
inline constexpr double kUsableAccuracy = 1e-6;

/// Solutions less accurate than this are warned of: a thousand times what doubles lose on a well-shaped mesh.
inline constexpr double kDoubtfulAccuracy = 1e-9;

/// Why a solution of this accuracy is refused; empty where it is usable.
[[nodiscard]] std::string accuracyFailure(double accuracy);

/// The warning of `what` ("the solution"), of the kind `kind`, where it is usable and doubtful.
[[nodiscard]] std::optional<Finding> accuracyWarning(const std::string& kind, const std::string& what, double accuracy);

}  // namespace holdfast
