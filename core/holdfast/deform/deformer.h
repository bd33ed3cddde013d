#pragma once
/// A mesh that is deformed again and again, as under a drag: what did not change is not computed again.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/deform/deform.h>

namespace holdfast {

struct ConstraintFactorization;
struct ConstraintLabel;
struct ConstraintSystem;
struct Operators;
class KnownPlaces;
class PlaceFindings;
class RotationEnergy;
class EnergyMatrix;
class ResultCheck;
template <class Result>
class LongStep;

/// Deforms one model under one list of constraints after another. Operators are made once. As long as only targets and
/// rotations change, from one list to the next, nothing is factorised. Not for concurrent calls.
class Deformer {
 public:
  explicit Deformer(Model model, const DeformOptions& options = {});
  explicit Deformer(std::shared_ptr<const Model> model, const DeformOptions& options = {});
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;
  ~Deformer();

  [[nodiscard]] const Model& model() const noexcept { return *model_; }

  /// Whether a list whose rows differ in few places from those that were factorised is answered by the factor that is
  /// there, bordered, while another is made beside the next calls (for hard constraints and our own factor), and one
  /// whose points and handles have moved in at most three ways, with the same rotations, by a sum of solutions; turns
  /// begin at the sum of earlier solutions that is nearest (`MovedSolutions`). Constraints are held to the same limits,
  /// in a fraction of the time; the last digits depend on what was there. Up to two factors are in memory. Off at
  /// first.
  void answerEditsAtOnce(bool isWanted) noexcept { answersEditsAtOnce_ = isWanted; }

  /// Rotations are found from those of the last call on, by up to so many iterations in a call: the frames of a drag.
  /// With 0, as at first, every call starts anew and finds what it finds in any other program.
  void continueRotations(int mostIterations) noexcept { continued_ = mostIterations; }

  /// As the function `deform`. When `progress` or an unusable list throws, this is as if it had not been called.
  [[nodiscard]] DeformResult deform(const ConstraintList& constraints, const std::string& source = "constraints",
                                    Progress& progress = noProgress());

  /// The report of `result`, which `deform` gave, with what can be said of each frame of a drag: folds, edges, areas,
  /// volumes and vertices that overshoot. `deform` leaves that out, as a frame need not wait for it. The result is not
  /// changed. O(T + rows).
  [[nodiscard]] Report checked(const DeformResult& result);

  /// The same with what takes longer to look for: faces that are inverted or cross others, targets that are their
  /// points turned, scaled, shifted or swapped, and regions that stay level. O(T log T). Throws what `progress` throws.
  [[nodiscard]] Report examined(const DeformResult& result, Progress& progress = noProgress());

  /// The constraints of `deform()`.
  void setConstraints(ConstraintList constraints) { constraints_ = std::move(constraints); }
  /// The one of that name, to be changed. Throws `InputError` where there is none.
  [[nodiscard]] Constraint& constraint(std::string_view name);
  /// Another place for the point constraint of that name. Throws `InputError` where there is none.
  void setTarget(std::string_view name, const Vector3& place);
  /// Deforms under the constraints that were set, with what was changed in them since.
  [[nodiscard]] DeformResult deform(Progress& progress = noProgress())
  {
    return deform(constraints_, "constraints", progress);
  }

 private:
  std::shared_ptr<const Model> model_;
  DeformOptions options_;
  ConstraintList constraints_;
  std::unique_ptr<KnownPlaces> places_;
  std::unique_ptr<PlaceFindings> placeFindings_;                // of the last list
  std::shared_ptr<const std::vector<ConstraintLabel>> labels_;  // of the last list
  std::shared_ptr<const Operators> operators_;
  std::shared_ptr<const RotationEnergy> energy_;  // where rotations are found
  std::shared_ptr<const EnergyMatrix> A_;
  std::unique_ptr<LongStep<std::vector<int>>> ranks_;  // the order of elimination
  /// The rows of `constraints`, with findings about their places in `placeFindings_`.
  [[nodiscard]] ConstraintSystem systemOf(const ConstraintList& constraints, const std::string& source);
  /// One that serves `system`: the one at hand, one that was made meanwhile, or a new one.
  [[nodiscard]] ConstraintFactorization& factorizationFor(const ConstraintSystem& system, Progress& progress);
  /// A new one without the rows that are closer to those before them than `tolerance`.
  [[nodiscard]] std::shared_ptr<ConstraintFactorization> factorizationBy(const ConstraintSystem& system,
                                                                         double tolerance, Progress& progress);
  /// One with fewer rows than that at hand, which did not meet all: without those that are closer to others than
  /// `neededDistance`, or than more. It is at hand then. Null where no row goes, or it is 0.
  [[nodiscard]] ConstraintFactorization* withFewerRows(const ConstraintSystem& system, double neededDistance,
                                                       Progress& progress);

  friend DeformResult deform(const Model&, const ConstraintList&, const std::string&, const DeformOptions&, Progress&);

  bool isForOneCall_ = false;  // what the rest of the call does not need is released
  bool answersEditsAtOnce_ = false;
  int continued_ = 0;
  Columns3 lastRotations_;
  std::unique_ptr<ResultCheck> check_;
  std::shared_ptr<ConstraintFactorization> factorization_;
  std::shared_ptr<ConstraintFactorization> whole_;   // the last one with a factor of its own that is done
  std::shared_ptr<ConstraintFactorization> coming_;  // what takes the place of a bordered one
};

}  // namespace holdfast
