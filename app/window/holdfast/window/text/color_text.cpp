#include "holdfast/window/text/color_text.h"

#include <QCoreApplication>

namespace holdfast {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ColorText)
};

}  // namespace

FieldText fieldText(ColorBy field, const QString& units, Weights weights)
{
  const QString length = units.isEmpty() ? Text::tr("that of the model's coordinates") : units;
  const QString inverse = units.isEmpty() ? Text::tr("one over that of the model's coordinates") : "1/" + units;
  const auto with = [](const QString& unit) { return ' ' + Text::tr("Unit: %1.").arg(unit); };
  switch (field) {
    case ColorBy::ConstraintResidual:
      return {Text::tr("Constraint residual"),
              Text::tr("How far constraints are from being met, at the vertices they hold; the promise is marked.") +
                  with(length)};
    case ColorBy::Rotation:
      return {Text::tr("Rotation |q|"),
              Text::tr("The length of the quaternion's logarithm: half the angle by which the detail is turned.") +
                  with(Text::tr("radians"))};
    case ColorBy::Angle:
      return {
          Text::tr("Rotation angle"),
          Text::tr("The angle by which the detail is turned; whole turns are counted.") + with(Text::tr("degrees"))};
    case ColorBy::Displacement:
      return {Text::tr("Displacement"), Text::tr("How far each vertex is from its place at rest.") + with(length)};
    case ColorBy::Detail:
      return {Text::tr("Detail residual"),
              Text::tr("How far the detail is from that at rest, turned: where the shape had to give way.") +
                  with(weights == Weights::Uniform ? length : inverse)};
    case ColorBy::Force:
      return {Text::tr("Constraint force"),
              Text::tr("How hard each constraint pulls; of hard constraints only. It has no unit.")};
    case ColorBy::None:
      break;
  }
  return {Text::tr("One colour"), Text::tr("The surface without values.")};
}

}  // namespace holdfast
