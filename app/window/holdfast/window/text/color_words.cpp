#include "holdfast/window/text/color_words.h"

#include <QCoreApplication>

namespace holdfast {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ColorWords)
};

}  // namespace

FieldWords fieldWords(ColorBy field)
{
  switch (field) {
    case ColorBy::ConstraintResidual:
      return {Words::tr("Constraint residual"),
              Words::tr("How far constraints are from being met, at the vertices they hold; the promise is marked.")};
    case ColorBy::Rotation:
      return {Words::tr("Rotation |q|"),
              Words::tr("The length of the quaternion's logarithm: half the angle by which the detail is turned.")};
    case ColorBy::Angle:
      return {Words::tr("Rotation angle"),
              Words::tr("The angle by which the detail is turned; whole turns are counted.")};
    case ColorBy::Displacement:
      return {Words::tr("Displacement"), Words::tr("How far each vertex is from its place at rest.")};
    case ColorBy::Detail:
      return {Words::tr("Detail residual"),
              Words::tr("How far the detail is from that at rest, turned: where the shape had to give way.")};
    case ColorBy::Force:
      return {Words::tr("Constraint force"), Words::tr("How hard each constraint pulls; of hard constraints only.")};
    case ColorBy::None:
      break;
  }
  return {Words::tr("One colour"), Words::tr("The surface without values.")};
}

QString unitSentence(ColorBy field, const QString& units, Weights weights)
{
  const QString length = units.isEmpty() ? Words::tr("that of the model's coordinates") : units;
  const QString sentence = Words::tr("Unit: %1.");
  switch (field) {
    case ColorBy::ConstraintResidual:
    case ColorBy::Displacement:
      return sentence.arg(length);
    case ColorBy::Rotation:
      return sentence.arg(Words::tr("radians"));
    case ColorBy::Angle:
      return sentence.arg(Words::tr("degrees"));
    case ColorBy::Detail:
      if (weights == Weights::Uniform) return sentence.arg(length);
      return sentence.arg(units.isEmpty() ? Words::tr("one over that of the model's coordinates") : "1/" + units);
    case ColorBy::Force:
      return Words::tr("It has no unit.");
    case ColorBy::None:
      break;
  }
  return {};
}

}  // namespace holdfast
