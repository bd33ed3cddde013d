#pragma once
/// A deformer deforms one mesh again and again, as under a drag. It does not compute again what did not change.

#include <memory>
#include <string>
#include <string_view>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// The use that a deformer is made for.
enum class DeformerMode {
  /// Every call finds what it would find if it were the first one, bit for bit.
  Repeatable,
  /// Edits and drags are answered in a fraction of the time, and constraints are held to the same limits. The last
  /// digits depend on the calls before. Up to two factors are in memory.
  ///
  /// Where few rows changed, the factor that is there answers, bordered. Another factor is made beside the next calls.
  /// This holds for hard constraints and our own factor. Where points and handles moved in at most three ways, with the
  /// same rotations, a sum of earlier solutions answers. Where they turned, the solution begins at the nearest such
  /// sum.
  Interactive,
  /// The deformer is called once. It releases what the rest of the call does not need.
  OneCall
};

/// Deforms one model under one list of constraints after another. The first call makes the operators. As long as only
/// targets and rotations change from one list to the next, nothing is factorised. Each call throws what the function
/// `deform` throws.
///
/// Calls of one deformer must not be concurrent. Deformers that share a model may run in threads of their own. A
/// deformer that was moved from can only be assigned to or destroyed.
///
///     Deformer deformer(model);
///     for (const Vector3& place : places) {
///       deformer.setTarget("tip", place);
///       show(deformer.deform().positions);
///     }
class Deformer {
 public:
  /// Makes a deformer that owns `model`, or one that shares it. A shared model is not null, and does not change.
  /// Nothing is computed before the first call.
  explicit Deformer(Model model, const DeformOptions& options = {}, DeformerMode mode = DeformerMode::Repeatable);
  explicit Deformer(std::shared_ptr<const Model> model, const DeformOptions& options = {},
                    DeformerMode mode = DeformerMode::Repeatable);
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;
  ~Deformer();

  [[nodiscard]] const Model& model() const noexcept;

  /// Deforms as the function `deform` does, but leaves out what `checked` and `examined` look for. When `progress` or
  /// an unusable list throws, the deformer is as if this had not been called.
  [[nodiscard]] DeformResult deform(const ConstraintList& constraints, const std::string& source = "constraints",
                                    Progress& progress = noProgress());

  /// Deforms as `deform` does, for a frame of a drag. Where rotations are found, this makes two iterations that go on
  /// from those of the last call. More calls with one list come nearer and nearer to what `deform` finds.
  [[nodiscard]] DeformResult deformFrame(const ConstraintList& constraints, const std::string& source = "constraints",
                                         Progress& progress = noProgress());

  /// Returns the report of `result`, which `deform` gave, with what can be said of each frame of a drag. That is folds,
  /// edges, areas, volumes and vertices that overshoot. `deform` leaves it out, as a frame need not wait for it. The
  /// result is not changed. O(T + rows).
  [[nodiscard]] Report checked(const DeformResult& result);

  /// Returns the same report with what takes longer to look for. That is faces that are inverted or cross others, and
  /// regions that stay level. It is also targets that are their points turned, scaled, shifted or swapped. O(T log T).
  /// Throws what `progress` throws.
  [[nodiscard]] Report examined(const DeformResult& result, Progress& progress = noProgress());

  /// Sets the constraints under which `deform()` deforms. Before the first call there are none, and nothing moves.
  void setConstraints(ConstraintList constraints);
  /// Returns the constraint of that name, so that it can be changed. Throws `InputError` where there is none.
  [[nodiscard]] Constraint& constraint(std::string_view name);
  /// Gives the point constraint of that name another target. Throws `InputError` where there is none.
  void setTarget(std::string_view name, const Vector3& place);
  /// Deforms under the constraints that were set, with all changes that were made to them since.
  [[nodiscard]] DeformResult deform(Progress& progress = noProgress());

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace holdfast
