#pragma once
/// \file
/// The results of constraints by name: those of a list that may be older than the one on screen.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Finds outcomes of the newest deformation of an editor.
class OutcomeLookup {
 public:
  /// `editor` stays alive as long as this.
  explicit OutcomeLookup(const Editor& editor) : editor_(editor) {}

  /// The outcome of the constraint of this name, valid as long as the deformation is; null where nothing was solved
  /// with it. `place`, in the list on screen, is where it is looked for first. O(1), after O(constraints) where lists
  /// differ.
  [[nodiscard]] const ConstraintOutcome* find(const std::string& name, Index place);

 private:
  const Editor& editor_;
  std::shared_ptr<const DeformResult> indexed_;
  std::unordered_map<std::string_view, Index> placeOf_;
};

/// The status to be shown: that of the list where it says disabled, nothing where the outcome is of another state of
/// the switch or there is none.
[[nodiscard]] std::optional<ConstraintStatus> shownStatus(const Constraint& constraint,
                                                          const ConstraintOutcome* outcome);

/// Whether results are those of the list on screen.
[[nodiscard]] inline bool areResultsCurrent(const Editor& editor)
{
  return editor.solveState() == SolveState::Current;
}

}  // namespace holdfast
