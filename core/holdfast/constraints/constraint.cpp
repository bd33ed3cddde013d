#include "holdfast/constraints/constraint.h"

namespace holdfast {
namespace {

struct TypeName {
  const char* operator()(const Fixed&) const { return "fixed"; }
  const char* operator()(const Handle&) const { return "handle"; }
  const char* operator()(const Point&) const { return "point"; }
  const char* operator()(const Rigid&) const { return "rigid"; }
  const char* operator()(const Relative&) const { return "relative"; }
};

}  // namespace

const char* typeName(const Constraint& constraint)
{
  return std::visit(TypeName{}, constraint.what);
}

}  // namespace holdfast
