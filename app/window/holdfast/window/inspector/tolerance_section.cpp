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

/// What points with these `directions` begin with.
PointTolerance firstOf(Nearness nearness, double size, const RowDirections& directions)
{
  switch (nearness) {
    case InBall:
      return WithinBall{size};
    case InABox:
      return WithinBox{Vector3::Constant(size)};
    case InASlab:
      return WithinSlab{-size, size, directions.areAll() ? std::optional(Vector3(Vector3::UnitZ())) : std::nullopt};
    case Soft:
      return Weighted{kFirstWeight};
    default:
      return Exactly{};
  }
}

/// The tolerance of points, or of the vertices of slides.
template <class What>
class ToleranceSection : public SectionOf<What> {
 public:
  /// Names of fields begin with `prefix`.
  ToleranceSection(Editor& editor, const QString& prefix) : SectionOf<What>(editor, QObject::tr("Tolerance"))
  {
    this->bindChoice(
        QObject::tr("Comes"), prefix + "Way", QObject::tr("How near it comes to where it goes"),
        {QObject::tr("there exactly"), QObject::tr("within a ball around it"), QObject::tr("within a box around it"),
         QObject::tr("between two planes"), QObject::tr("as near as its weight says")},
        [](const What& what) { return static_cast<double>(what.within.index()); },
        [this](int way) { chooseNearness(static_cast<Nearness>(way)); });
    this->bindNumber(QObject::tr("Radius"), prefix + "Radius", ofTolerance(&WithinBall::radius),
                     QObject::tr("bring %1 within a ball of %2"), setterOf(&WithinBall::radius));
    this->explain(this->bindVector(QObject::tr("Half sides"), prefix + "Box", ofTolerance(&WithinBox::half),
                                   QObject::tr("bring %1 within a box of %2 = %3"),
                                   [](What& what, int axis, double number) {
                                     std::get<WithinBox>(what.within).half[axis] = number;
                                     requireTolerance(what);
                                   }),
                  QObject::tr("How far the point may be from its target along each axis"));
    this->explain(this->bindNumber(QObject::tr("From"), prefix + "Low", ofTolerance(&WithinSlab::low),
                                   QObject::tr("keep %1 above %2"), setterOf(&WithinSlab::low)),
                  QObject::tr("From there along the normal; -inf where there is no bound"));
    this->explain(this->bindNumber(QObject::tr("To"), prefix + "High", ofTolerance(&WithinSlab::high),
                                   QObject::tr("keep %1 below %2"), setterOf(&WithinSlab::high)),
                  QObject::tr("From there along the normal; inf where there is no bound"));
    this->bindVector(
        QObject::tr("Across"), prefix + "Normal",
        [](const What& what) {
          const auto* slab = std::get_if<WithinSlab>(&what.within);
          return slab == nullptr ? std::nullopt : slab->normal;
        },
        QObject::tr("rotate the slab of %1 to %2 = %3"),
        [](What& what, int axis, double number) {
          setDirection(*std::get<WithinSlab>(what.within).normal, axis, number);
        });
    this->explain(this->bindNumber(QObject::tr("Weight"), prefix + "Weight", ofTolerance(&Weighted::weight),
                                   QObject::tr("weigh %1 by %2"), setterOf(&Weighted::weight)),
                  QObject::tr("As that of soft constraints: the larger, the nearer"));
  }

 private:
  /// Reads a member of a tolerance; nothing from what has another one.
  template <class Tolerance, class Member>
  static auto ofTolerance(Member Tolerance::*member)
  {
    return [=](const What& what) -> std::optional<Member> {
      const auto* tolerance = std::get_if<Tolerance>(&what.within);
      return tolerance == nullptr ? std::nullopt : std::optional(tolerance->*member);
    };
  }

  static void requireTolerance(const What& what)
  {
    if (const auto error = validateTolerance(what.within, what.directions())) throw InputError({}, error->reason);
  }

  /// Sets a member of a tolerance that stays valid.
  template <class Tolerance>
  static auto setterOf(double Tolerance::*member)
  {
    return [=](What& what, double number) {
      std::get<Tolerance>(what.within).*member = number;
      requireTolerance(what);
    };
  }

  void chooseNearness(Nearness nearness)
  {
    const double size = kFirstTolerance * this->editor().model()->solverMesh.diagonal;
    const QString name = nearness == Exact ? QObject::tr("bring %1 to its target") : QObject::tr("give %1 a tolerance");
    this->edit(name.arg(this->subject()), [&](What& what) {
      if (static_cast<Nearness>(what.within.index()) == nearness) return false;
      what.within = firstOf(nearness, size, what.directions());
      requireTolerance(what);
      return true;
    });
  }
};

}  // namespace

Sections newToleranceSections(Editor& editor)
{
  return {new ToleranceSection<PointConstraint>(editor, "tolerance"),
          new ToleranceSection<SlideConstraint>(editor, "slideTolerance")};
}

}  // namespace holdfast
