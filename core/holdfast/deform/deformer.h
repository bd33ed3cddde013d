#pragma once
/// A mesh that is deformed again and again, as under a drag: what did not change is not computed again.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/deform/deform.h>

namespace holdfast {

struct ConstraintFactorization;
struct Operators;
class TwoWayMatrix;
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

  /// As the function `deform`. When `progress` or an unusable list throws, this is as if it had not been called.
  [[nodiscard]] DeformResult deform(const ConstraintList& constraints, const std::string& source = "constraints",
                                    Progress& progress = noProgress());

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
  std::shared_ptr<const Operators> operators_;
  std::shared_ptr<const TwoWayMatrix> A_;
  std::unique_ptr<LongStep<std::vector<int>>> ranks_;
  std::unique_ptr<ConstraintFactorization> factorization_;
};

}  // namespace holdfast
