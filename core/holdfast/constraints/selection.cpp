#include "holdfast/constraints/selection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace holdfast {
namespace {

/// One byte a vertex: 1 where it is selected.
using Mask = std::vector<unsigned char>;

/// The normal of about unit length, scaled by a power of two: exact, so that points on the plane stay on it, and the
/// products with it neither overflow nor vanish.
Vector3 moderate(const Vector3& normal)
{
  const int exponent = std::ilogb(normal.cwiseAbs().maxCoeff());
  return normal.unaryExpr([&](double x) { return std::scalbn(x, -exponent); });
}

/// Turns each kind of selection into a mask.
class MaskMaker {
 public:
  MaskMaker(const Positions& positions, const std::vector<Index>& componentOf)
      : positions_(positions), componentOf_(componentOf)
  {
  }

  [[nodiscard]] Mask mask(const Selection& selection) const { return std::visit(*this, selection.what); }

  Mask operator()(const VertexIds& vertices) const
  {
    Mask selected(positions_.rows(), 0);
    for (const Index id : vertices.ids) {
      assert(id >= 0 && id < positions_.rows());
      selected[id] = 1;
    }
    return selected;
  }

  Mask operator()(const InBox& box) const
  {
    return where(
        [&](const Vector3& p) { return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all(); });
  }

  Mask operator()(const InSphere& sphere) const
  {
    // The root takes back half of what rounding the squares did, so that points meant to lie on the sphere do.
    return where([&](const Vector3& p) { return (p - sphere.center).norm() <= sphere.radius; });
  }

  Mask operator()(const InHalfSpace& half) const
  {
    const Vector3 normal = moderate(half.normal);
    return where([&](const Vector3& p) { return (p - half.point).dot(normal) >= 0; });
  }

  Mask operator()(const InComponent& part) const
  {
    assert(static_cast<Index>(componentOf_.size()) == positions_.rows());
    Mask selected(componentOf_.size());
    std::transform(componentOf_.begin(), componentOf_.end(), selected.begin(),
                   [&](Index component) { return component == part.component; });
    return selected;
  }

  Mask operator()(const InsideCurve& /*curve*/) const
  {
    assert(!"curves are resolved before");
    return Mask(positions_.rows(), 0);
  }

  Mask operator()(const AllOf& all) const
  {
    Mask selected(positions_.rows(), 1);
    for (const Selection& part : all.parts) combine(selected, mask(part), std::bit_and<>());
    return selected;
  }

  Mask operator()(const AnyOf& any) const
  {
    Mask selected(positions_.rows(), 0);
    for (const Selection& part : any.parts) combine(selected, mask(part), std::bit_or<>());
    return selected;
  }

  Mask operator()(const NotIn& none) const
  {
    assert(none.part != nullptr);
    Mask selected = mask(*none.part);
    for (unsigned char& isSelected : selected) isSelected ^= 1;
    return selected;
  }

 private:
  template <class Predicate>
  Mask where(Predicate isInside) const
  {
    Mask selected(positions_.rows());
    for (Index v = 0; v < positions_.rows(); ++v) selected[v] = isInside(Vector3(positions_.row(v)));
    return selected;
  }

  template <class Operation>
  static void combine(Mask& selected, const Mask& other, Operation operation)
  {
    std::transform(selected.begin(), selected.end(), other.begin(), selected.begin(), operation);
  }

  const Positions& positions_;
  const std::vector<Index>& componentOf_;
};

}  // namespace

std::vector<Index> select(const Selection& selection, const Positions& positions, const std::vector<Index>& componentOf)
{
  const Mask selected = MaskMaker(positions, componentOf).mask(selection);
  std::vector<Index> ids;
  for (Index v = 0; v < positions.rows(); ++v)
    if (selected[v] != 0) ids.push_back(v);
  return ids;
}

}  // namespace holdfast
