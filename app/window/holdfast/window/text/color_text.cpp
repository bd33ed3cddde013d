#include "holdfast/window/text/color_text.h"

#include <QObject>
#include <cmath>
#include <map>

#include <holdfast/deform/deform.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

bool isLength(ColorBy field)
{
  switch (field) {
    case ColorBy::ConstraintResidual:
    case ColorBy::Displacement:
    case ColorBy::DisplacementX:
    case ColorBy::DisplacementY:
    case ColorBy::DisplacementZ:
    case ColorBy::DisplacementNormal:
      return true;
    default:
      return false;
  }
}

}  // namespace

QString valueText(double value, const ValueMeaning& meaning, std::optional<int> decimals)
{
  if (std::isnan(value)) return QObject::tr("none here");
  if (meaning.promise && value <= *meaning.promise) return metText(*meaning.promise, {});
  return isLength(meaning.field) ? numberText(value, {{}, decimals}) : roundedText(value);
}

std::optional<Vector3> rotationAxis(const Model& model, const DeformResult& deformation, const SurfacePoint& point)
{
  Vector3 q = Vector3::Zero();
  for (const Term& term : point.terms)
    q += term.coefficient * deformation.rotations.row(model.solverMesh.weld.unknownOf[term.index]).transpose();
  const double length = q.stableNorm();
  return length > 0 ? std::optional<Vector3>(q / length) : std::nullopt;
}

FieldText fieldText(ColorBy field, const QString& units, Weights weights)
{
  const QString length = units.isEmpty() ? QObject::tr("that of the model's coordinates") : units;
  const QString inverse = units.isEmpty() ? QObject::tr("one over that of the model's coordinates") : "1/" + units;
  const auto with = [](const QString& unit) { return ' ' + QObject::tr("Unit: %1.").arg(unit); };
  const std::map<ColorBy, FieldText> texts{
      {ColorBy::None, {QObject::tr("One colour"), QObject::tr("The surface without values.")}},
      {ColorBy::ConstraintResidual,
       {QObject::tr("Constraint residual"),
        QObject::tr("How far constraints are from being met, at the vertices they hold; the promise is marked.") +
            with(length)}},
      {ColorBy::Rotation,
       {QObject::tr("Rotation |q|"),
        QObject::tr("The length of the quaternion's logarithm: half the angle by which the detail is rotated.") +
            with(QObject::tr("radians"))}},
      {ColorBy::Angle,
       {QObject::tr("Rotation angle"),
        QObject::tr("The angle by which the detail is rotated; whole turns are counted.") +
            with(QObject::tr("degrees"))}},
      {ColorBy::Displacement,
       {QObject::tr("Displacement"), QObject::tr("How far each vertex is from its place at rest.") + with(length)}},
      {ColorBy::Detail,
       {QObject::tr("Detail residual"),
        QObject::tr("How far the detail is from that at rest, rotated: where the shape could not be kept.") +
            with(weights == Weights::Uniform ? length : inverse)}},
      {ColorBy::Force,
       {QObject::tr("Force"),
        QObject::tr("How hard each constraint pulls; of hard constraints only. It has no unit.")}},
      {ColorBy::DisplacementX,
       {QObject::tr("Displacement x"), QObject::tr("How far each vertex has moved along x.") + with(length)}},
      {ColorBy::DisplacementY,
       {QObject::tr("Displacement y"), QObject::tr("How far each vertex has moved along y.") + with(length)}},
      {ColorBy::DisplacementZ,
       {QObject::tr("Displacement z"), QObject::tr("How far each vertex has moved along z.") + with(length)}},
      {ColorBy::DisplacementNormal,
       {QObject::tr("Displacement along the normal"),
        QObject::tr("How far each vertex has moved outwards, along the normal at rest; below zero is inwards.") +
            with(length)}},
      {ColorBy::AreaChange,
       {QObject::tr("Change of area"),
        QObject::tr("How much larger the triangles at each vertex are than at rest.") + with(QObject::tr("percent"))}},
      {ColorBy::EdgeChange,
       {QObject::tr("Change of edge length"),
        QObject::tr("How much longer the sides of the triangles at each vertex are than at rest.") +
            with(QObject::tr("percent"))}}};
  return texts.at(field);
}

}  // namespace holdfast
