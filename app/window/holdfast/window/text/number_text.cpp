#include "holdfast/window/text/number_text.h"

#include <QCoreApplication>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

struct Numbers {
  Q_DECLARE_TR_FUNCTIONS(NumberText)
};

constexpr int kShortText = 9;  // characters that a column of coordinates has room for

QString toText(const std::string& text)
{
  return QString::fromStdString(text);
}

}  // namespace

QString exactText(double value)
{
  const NumberText text(value);
  return QString::fromLatin1(text.view().data(), static_cast<int>(text.view().size()));
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
  if (shown.isEmpty()) return Numbers::tr("A number is needed here, such as 1.5.");
  if (parseNumber<double>(shown.toStdString()).fault == NumberFault::OutOfRange)
    return Numbers::tr("“%1” is beyond what a double can hold; write a number nearer to 1.").arg(shown);
  if (shown.contains(','))
    return Numbers::tr("“%1” is no number; write decimals with a point, such as 1.5.").arg(shown);
  return Numbers::tr("“%1” is no number; write one such as 1.5 or -2e-3.").arg(shown);
}

}  // namespace holdfast
