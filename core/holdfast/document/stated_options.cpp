#include "holdfast/document/stated_options.h"

namespace holdfast {

DeformOptions withStated(DeformOptions options, const StatedOptions& stated)
{
  options.weights = stated.weights.value_or(options.weights);
  options.solver.kind = stated.solver.value_or(options.solver.kind);
  options.solver.softWeight = stated.softWeight.value_or(options.solver.softWeight);
  options.solver.backend = stated.backend.value_or(options.solver.backend);
  return options;
}

StatedOptions beside(const StatedOptions& stronger, StatedOptions stated)
{
  if (stronger.weights) stated.weights.reset();
  if (stronger.solver) stated.solver.reset();
  if (stronger.softWeight) stated.softWeight.reset();
  if (stronger.backend) stated.backend.reset();
  return stated;
}

}  // namespace holdfast
