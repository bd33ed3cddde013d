#include "holdfast/window/model/outcome_lookup.h"

namespace holdfast {

const ConstraintOutcome* OutcomeLookup::find(const std::string& name, Index place)
{
  const std::shared_ptr<const DeformResult>& deformation = editor_.deformation();
  if (deformation == nullptr) return nullptr;
  const std::vector<ConstraintOutcome>& outcomes = deformation->report.constraints;
  if (place < static_cast<Index>(outcomes.size()) && outcomes[place].name == name) return &outcomes[place];
  if (indexed_ != deformation) {
    indexed_ = deformation;
    placeOf_.clear();
    for (std::size_t k = 0; k < outcomes.size(); ++k) placeOf_.emplace(outcomes[k].name, static_cast<Index>(k));
  }
  const auto found = placeOf_.find(name);
  return found == placeOf_.end() ? nullptr : &outcomes[found->second];
}

std::optional<ConstraintStatus> shownStatus(const Constraint& constraint, const ConstraintOutcome* outcome)
{
  if (!constraint.isEnabled) return ConstraintStatus::Disabled;
  if (outcome == nullptr || outcome->status == ConstraintStatus::Disabled) return std::nullopt;
  return outcome->status;
}

}  // namespace holdfast
