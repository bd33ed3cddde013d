#include "holdfast/window/text/number_text.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kShortText = 6;  // characters that a column of coordinates has room for

constexpr double kLongWhole = 1e5;

// From here on decimals are no help to a reader.
constexpr double kLongestPlain = 1e9;

// The share of the largest number below which another one is rounding.
constexpr double kRoundingShare = 1e-14;

QString withUnit(const QString& number, const std::string& units)
{
  return units.empty() ? number : number + ' ' + QString::fromStdString(units);
}

bool isZero(const QString& number)
{
  return std::none_of(number.begin(), number.end(), [](QChar letter) { return letter >= '1' && letter <= '9'; });
}

/// "(1, 2.5, 3)"
template <class Write>
QString tupleText(const Vector3& vector, Write&& write)
{
  return '(' + write(vector.x()) + ", " + write(vector.y()) + ", " + write(vector.z()) + ')';
}

}  // namespace

QString exactText(double value)
{
  return toText(NumberText(value).view());
}

QString roundedText(double value)
{
  // No sum is -0.
  return toText(fmt::format("{:.4g}", value + 0.0));
}

QString shortText(double value)
{
  return toText(fmt::format("{:.2g}", value + 0.0));
}

double withoutNoise(double value, double scale)
{
  return std::abs(value) <= kRoundingShare * scale ? 0 : value;
}

QString numberText(double value, const LengthStyle& style)
{
  if (!style.decimals || !(std::abs(value) < kLongestPlain)) return roundedText(value);
  const QString number = toText(fmt::format("{:.{}f}", value, *style.decimals));
  return isZero(number) && number.startsWith('-') ? number.mid(1) : number;
}

QString metText(double limit, const std::string& units)
{
  return withUnit(QObject::tr("met ≤ %1").arg(shortText(limit)), units);
}

QString coordinateText(double value, const LengthStyle& style)
{
  if (style.decimals) return numberText(value, style);
  const QString exact = exactText(value);
  return exact.size() <= kShortText ? exact : toText(fmt::format("{:.5g}", value));
}

QString fittingText(double value, const QString& text, const std::function<bool(const QString&)>& fits)
{
  QStringList texts{text};
  if (!typedNumber(text) && text.contains(' ')) return fits(text) ? text : text.section(' ', 0, 0);
  // From here on all digits before the point need less room than a power of ten.
  if (std::abs(value) >= kLongWhole) texts << toText(fmt::format("{:.0f}", value));
  for (const int digits : {4, 3, 2}) texts << toText(fmt::format("{:.{}g}", value, digits));
  const auto found = std::find_if(texts.begin(), texts.end(), fits);
  return found != texts.end() ? *found : QStringLiteral("…");
}

QString countText(Index count)
{
  constexpr QChar kNarrowSpace(0x202f);
  QString digits = QString::number(count);
  for (int place = digits.size() - 3; place > 0; place -= 3) digits.insert(place, kNarrowSpace);
  return digits;
}

QString countText(Index count, const char* one, const char* many)
{
  return count == 1 ? QObject::tr(one) : QObject::tr(many).arg(countText(count));
}

QString lengthText(double length, const LengthStyle& style)
{
  const QString number = numberText(length, style);
  if (length == 0 || !isZero(number)) return withUnit(number, style.units);
  return withUnit('<' + numberText(std::pow(10, -*style.decimals), style), style.units);
}

QString roundedText(const Vector3& vector)
{
  return placeText(vector, {});
}

QString placeText(const Vector3& place, const LengthStyle& style)
{
  return tupleText(place, [&, scale = place.cwiseAbs().maxCoeff()](double value) {
    return numberText(withoutNoise(value, scale), style);
  });
}

QString exactText(const Vector3& vector)
{
  return tupleText(vector, [](double value) { return exactText(value); });
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
