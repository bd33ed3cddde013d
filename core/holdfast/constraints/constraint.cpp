#include "holdfast/constraints/constraint.h"

namespace holdfast {
namespace {

struct TypeName {
  const char* operator()(const FixedConstraint&) const { return "fixed"; }
  const char* operator()(const HandleConstraint&) const { return "handle"; }
  const char* operator()(const PointConstraint&) const { return "point"; }
  const char* operator()(const RigidConstraint&) const { return "rigid"; }
  const char* operator()(const RelativeConstraint&) const { return "relative"; }
};

}  // namespace

const char* typeName(const Constraint& constraint)
{
  return std::visit(TypeName{}, constraint.what);
}

}  // namespace holdfast
