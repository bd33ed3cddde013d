#pragma once
/// A mesh that is deformed again and again, as under a drag: what did not change is not computed again.

#include <memory>
#include <string>
#include <string_view>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// What a deformer is made for.
enum class DeformerMode {
  /// Every call finds what it would find as the first one, bit for bit.
  Repeatable,
  /// Edits and drags are answered in a fraction of the time, and constraints are held to the same limits. Few changed
  /// rows are answered by the factor that is there, bordered, while another factor is made beside the next calls: for
  /// hard constraints and our own factor. Points and handles that moved in at most three ways, with the same rotations,
  /// are answered by a sum of earlier solutions; turns begin at the sum that is nearest. The last digits depend on the
  /// calls before. Up to two factors are in memory.
  Interactive,
  /// There is one call. What the rest of it does not need is released.
  OneCall
};

/// Deforms one model under one list of constraints after another. Operators are made once. As long as only targets and
/// rotations change, from one list to the next, nothing is factorised. Not for concurrent calls.
///
///     Deformer deformer(model);
///     for (const Vector3& place : places) {
///       deformer.setTarget("tip", place);
///       show(deformer.deform().positions);
///     }
class Deformer {
 public:
  explicit Deformer(Model model, const DeformOptions& options = {}, DeformerMode mode = DeformerMode::Repeatable);
  explicit Deformer(std::shared_ptr<const Model> model, const DeformOptions& options = {},
                    DeformerMode mode = DeformerMode::Repeatable);
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;
  ~Deformer();

  [[nodiscard]] const Model& model() const noexcept;

  /// As the function `deform`. When `progress` or an unusable list throws, this is as if it had not been called.
  [[nodiscard]] DeformResult deform(const ConstraintList& constraints, const std::string& source = "constraints",
                                    Progress& progress = noProgress());

  /// The same as a frame of a drag: where rotations are found, two iterations go on from those of the last call. Calls
  /// with one list come nearer and nearer to what `deform` finds.
  [[nodiscard]] DeformResult deformFrame(const ConstraintList& constraints, const std::string& source = "constraints",
                                         Progress& progress = noProgress());

  /// The report of `result`, which `deform` gave, with what can be said of each frame of a drag: folds, edges, areas,
  /// volumes and vertices that overshoot. `deform` leaves that out, as a frame need not wait for it. The result is not
  /// changed. O(T + rows).
  [[nodiscard]] Report checked(const DeformResult& result);

  /// The same with what takes longer to look for: faces that are inverted or cross others, targets that are their
  /// points turned, scaled, shifted or swapped, and regions that stay level. O(T log T). Throws what `progress` throws.
  [[nodiscard]] Report examined(const DeformResult& result, Progress& progress = noProgress());

  /// The constraints of `deform()`.
  void setConstraints(ConstraintList constraints);
  /// The one of that name, to be changed. Throws `InputError` where there is none.
  [[nodiscard]] Constraint& constraint(std::string_view name);
  /// Another place for the point constraint of that name. Throws `InputError` where there is none.
  void setTarget(std::string_view name, const Vector3& place);
  /// Deforms under the constraints that were set, with what was changed in them since.
  [[nodiscard]] DeformResult deform(Progress& progress = noProgress());

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace holdfast
