#pragma once
/// A mesh that is deformed again and again, as under a drag: what did not change is not computed again.

#include <memory>
#include <string>

#include <holdfast/deform/constraint_factorization.h>
#include <holdfast/deform/deform.h>

namespace holdfast {

/// Deforms one model under one list of constraints after another. Operators are made once. As long as only targets and
/// rotations change, from one list to the next, nothing is factorised. Not for concurrent calls.
class Deformer {
 public:
  /// `model` stays alive as long as this.
  Deformer(const Model& model, const DeformOptions& options);

  /// As the function `deform`. When `progress` or an unusable list throws, this is as if it had not been called.
  [[nodiscard]] DeformResult deform(const ConstraintList& constraints, const std::string& source, Progress& progress);

 private:
  const Model& model_;
  DeformOptions options_;
  std::shared_ptr<const Operators> operators_;
  std::unique_ptr<ConstraintFactorization> factorization_;
};

}  // namespace holdfast
