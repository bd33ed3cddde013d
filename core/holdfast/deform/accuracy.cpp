#include "holdfast/deform/accuracy.h"

#include <fmt/format.h>

namespace holdfast {

std::string accuracyFailure(double accuracy)
{
  if (accuracy <= kUsableAccuracy) return "";
  return fmt::format("it is accurate to {:.1g} only, and {:g} is needed: the problem is nearly singular", accuracy,
                     kUsableAccuracy);
}

std::optional<Finding> accuracyWarning(const std::string& kind, const std::string& what, double accuracy)
{
  if (accuracy <= kDoubtfulAccuracy || accuracy > kUsableAccuracy) return std::nullopt;
  return Finding{kind,
                 1,
                 "solution",
                 {},
                 fmt::format("{} is accurate to {:.2g} only where constraints leave it free: the problem is nearly "
                             "singular; hold more places, or repair thin triangles",
                             what, accuracy)};
}

}  // namespace holdfast
