#include <cmath>

#include <holdfast/window/inspector/guide_section.h>

namespace holdfast {
namespace {

/// In the order of `PointTolerance`.
enum Nearness { Exact, InBall, InABox, InASlab, Soft };
static_assert(std::variant_size_v<PointTolerance> == Soft + 1);

// A tolerance begins with this share of the diagonal.
constexpr double kFirstTolerance = 1e-3;

// The weight that soft constraints have unless it is said otherwise.
const double kFirstWeight = SolverOptions().softWeight;

PointTolerance firstOf(Nearness nearness, double size)
{
  switch (nearness) {
    case InBall:
      return WithinBall{size};
    case InABox:
      return WithinBox{Vector3::Constant(size)};
    case InASlab:
      return WithinSlab{-size, size, Vector3::UnitZ()};
    case Soft:
      return Weighted{kFirstWeight};
    default:
      return Exactly{};
  }
}

/// Reads a member of a tolerance; nothing from points with another one.
template <class Tolerance, class Member>
auto ofTolerance(Member Tolerance::*member)
{
  return [=](const PointConstraint& point) -> std::optional<Member> {
    const auto* tolerance = std::get_if<Tolerance>(&point.within);
    return tolerance == nullptr ? std::nullopt : std::optional(tolerance->*member);
  };
}

void requireTolerance(const PointConstraint& point)
{
  if (const auto error = validateTolerance(point.within)) throw InputError({}, error->reason);
}

/// Sets a member of a tolerance that stays valid.
template <class Tolerance>
auto setterOf(double Tolerance::*member)
{
  return [=](PointConstraint& point, double number) {
    std::get<Tolerance>(point.within).*member = number;
    requireTolerance(point);
  };
}

class ToleranceSection : public SectionOf<PointConstraint> {
 public:
  explicit ToleranceSection(Editor& editor) : SectionOf(editor, tr("Tolerance"))
  {
    bindChoice(
        tr("Comes"), "toleranceWay", tr("How near the point comes to its target"),
        {tr("to its target exactly"), tr("within a ball around it"), tr("within a box around it"),
         tr("between two planes"), tr("as near as its weight says")},
        [](const PointConstraint& point) { return static_cast<double>(point.within.index()); },
        [this](int way) { chooseNearness(static_cast<Nearness>(way)); });
    bindNumber(tr("Radius"), "toleranceRadius", ofTolerance(&WithinBall::radius), tr("bring %1 within a ball of %2"),
               setterOf(&WithinBall::radius));
    explain(bindVector(tr("Half sides"), "toleranceBox", ofTolerance(&WithinBox::half),
                       tr("bring %1 within a box of %2 = %3"),
                       [](PointConstraint& point, int axis, double number) {
                         std::get<WithinBox>(point.within).half[axis] = number;
                         requireTolerance(point);
                       }),
            tr("How far the point may be from its target along each axis"));
    explain(bindNumber(tr("From"), "toleranceLow", ofTolerance(&WithinSlab::low), tr("keep %1 above %2"),
                       setterOf(&WithinSlab::low)),
            tr("From the target along the normal; -inf where there is no bound"));
    explain(bindNumber(tr("To"), "toleranceHigh", ofTolerance(&WithinSlab::high), tr("keep %1 below %2"),
                       setterOf(&WithinSlab::high)),
            tr("From the target along the normal; inf where there is no bound"));
    bindVector(tr("Across"), "toleranceNormal", ofTolerance(&WithinSlab::normal),
               tr("rotate the slab of %1 to %2 = %3"), [](PointConstraint& point, int axis, double number) {
                 setDirection(std::get<WithinSlab>(point.within).normal, axis, number);
               });
    explain(bindNumber(tr("Weight"), "toleranceWeight", ofTolerance(&Weighted::weight), tr("weigh %1 by %2"),
                       setterOf(&Weighted::weight)),
            tr("As that of soft constraints: the larger, the nearer"));
  }

  bool fits(const Constraint& constraint) const override
  {
    const auto* point = std::get_if<PointConstraint>(&constraint.what);
    return point != nullptr && point->hasTarget();
  }

 private:
  void chooseNearness(Nearness nearness)
  {
    const double size = kFirstTolerance * editor().model()->solverMesh.diagonal;
    edit(nearness == Exact ? tr("bring %1 to its target").arg(subject()) : tr("give %1 a tolerance").arg(subject()),
         [&](PointConstraint& point) {
           if (static_cast<Nearness>(point.within.index()) == nearness) return false;
           point.within = firstOf(nearness, size);
           return true;
         });
  }
};

}  // namespace

Sections newToleranceSections(Editor& editor)
{
  return {new ToleranceSection(editor)};
}

}  // namespace holdfast
