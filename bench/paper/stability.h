#pragma once
/// \file
/// Table 1: which solver solves which mesh with which weights, in which precision, and how well.

#include <functional>
#include <string>
#include <vector>

#include "bench/paper/printed_solver.h"

namespace holdfast::paper {

/// One mesh, one kind of weights, one method.
struct StabilityRow {
  std::string mesh;
  Index unknowns = 0;
  Weights weights = Weights::Uniform;
  Method method;
  Outcome inSingle;
  Outcome inDouble;
  Outcome byProduct;
  double condition = 0;       ///< of the normal equations; 0 where the product has no factor of them
  double referenceError = 1;  ///< `Reference::lastCorrection`; errors are NaN where there is no reference
};

/// "soft 5", "Lagrange", "hard".
[[nodiscard]] std::string text(const Method& method);

/// Soft constraints with the weights 1, 5, 10, 100, ... 1e8, Lagrange multipliers and hard constraints.
[[nodiscard]] std::vector<Method> allMethods();

/// Calls `tell` with each row as soon as it is there: all three kinds of weights, each with all `methods`.
void measureStability(const std::string& name, const Mesh& mesh, const std::vector<Method>& methods,
                      const std::function<void(const StabilityRow&)>& tell);

}  // namespace holdfast::paper
