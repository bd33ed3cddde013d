#pragma once
/// The factors of one model: the one at hand, one that edits began with, and one that is made beside the next frames.

#include <memory>
#include <vector>

#include <holdfast/deform/constraint_factorization.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {

/// Serves one list of constraints after another. As long as rows, given rotations and rigid regions stay, nothing is
/// factorised. One thread at a time may call it.
class FactorStore {
 public:
  FactorStore(std::shared_ptr<const Model> model, const DeformOptions& options, DeformerMode mode);

  /// Starts to order the unknowns, beside what the caller does next. The first call does it.
  void orderUnknowns(Progress& progress);

  /// Returns the operators of the model. The first call makes them. O(T log T).
  [[nodiscard]] const ModelOperators& operators(Progress& progress);

  /// The factorization that serves `system`: the one at hand; one that was made meanwhile; the one that edits began
  /// with, bordered where `DeformerMode::Interactive` allows it; or a new one. It is at hand until the next call.
  [[nodiscard]] ConstraintFactorization& serving(const ConstraintSystem& system, Progress& progress);

  /// The factorization that is made in place of the bordered one at hand, which did not do. It is at hand then.
  [[nodiscard]] ConstraintFactorization& unbordered();

  /// A factorization with fewer rows than that at hand, which did not meet all: without those that are closer to others
  /// than `neededDistance`, or than more. It is at hand then. Null where no row goes, or the distance is 0.
  [[nodiscard]] ConstraintFactorization* withFewerRows(const ConstraintSystem& system, double neededDistance,
                                                       Progress& progress);

  /// Goes on with what takes the place of a bordered factorization, on threads that give way to others.
  void makeNext(Progress& progress);

 private:
  [[nodiscard]] std::shared_ptr<ConstraintFactorization> made(const ConstraintSystem& system, double tolerance,
                                                              Progress& progress);
  /// Borders that of `whole_` by what `system` changes. False where there is none, or too much changes.
  [[nodiscard]] bool border(std::shared_ptr<ConstraintFactorization> wanted, Progress& progress);
  [[nodiscard]] ConstraintFactorization& atHand();

  std::shared_ptr<const Model> model_;
  DeformOptions options_;
  DeformerMode mode_;
  std::unique_ptr<LongStep<std::vector<int>>> ranks_;  // the order of elimination
  ModelOperators operators_;
  std::shared_ptr<ConstraintFactorization> atHand_;
  std::shared_ptr<ConstraintFactorization> whole_;   // the last one with a factor of its own that is done
  std::shared_ptr<ConstraintFactorization> coming_;  // what takes the place of a bordered one
};

}  // namespace holdfast
