#include "holdfast/window/text/number_text.h"

#include <QObject>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kShortText = 9;  // characters that a column of coordinates has room for

}  // namespace

QString exactText(double value)
{
  return toText(NumberText(value).view());
}

QString roundedText(double value)
{
  return toText(fmt::format("{:.4g}", value));
}

QString coordinateText(double value)
{
  const QString exact = exactText(value);
  return exact.size() <= kShortText ? exact : toText(fmt::format("{:.7g}", value));
}

QString countText(Index count)
{
  constexpr QChar kNarrowSpace(0x202f);
  QString digits = QString::number(count);
  for (int place = digits.size() - 3; place > 0; place -= 3) digits.insert(place, kNarrowSpace);
  return digits;
}

QString lengthText(double length, const std::string& units)
{
  return units.empty() ? roundedText(length) : roundedText(length) + ' ' + QString::fromStdString(units);
}

QString roundedText(const Vector3& vector)
{
  return toText(fmt::format("({:.4g}, {:.4g}, {:.4g})", vector.x(), vector.y(), vector.z()));
}

QString exactText(const Vector3& vector)
{
  return '(' + exactText(vector.x()) + ", " + exactText(vector.y()) + ", " + exactText(vector.z()) + ')';
}

std::optional<double> typedNumber(const QString& typed)
{
  const std::string token = typed.trimmed().toStdString();
  const ParsedNumber<double> parsed = parseNumber<double>(token);
  if (parsed.fault != NumberFault::None || !std::isfinite(parsed.value)) return std::nullopt;
  return parsed.value;
}

QString notANumber(const QString& typed)
{
  const QString shown = typed.trimmed();
  if (shown.isEmpty()) return QObject::tr("A number is needed here, such as 1.5.");
  if (parseNumber<double>(shown.toStdString()).fault == NumberFault::OutOfRange)
    return QObject::tr("“%1” is beyond what a double can hold; write a number nearer to 1.").arg(shown);
  if (shown.contains(','))
    return QObject::tr("“%1” is no number; write decimals with a point, such as 1.5.").arg(shown);
  return QObject::tr("“%1” is no number; write one such as 1.5 or -2e-3.").arg(shown);
}

}  // namespace holdfast
