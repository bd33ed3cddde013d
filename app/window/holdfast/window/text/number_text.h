#pragma once
/// Numbers as the window writes and reads them, whatever the locale is.

#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// Of UTF-8.
[[nodiscard]] inline QString toText(std::string_view text)
{
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// The shortest text that reads back as the same double.
[[nodiscard]] QString exactText(double value);

/// Four significant digits, for numbers that are only shown.
[[nodiscard]] QString roundedText(double value);

/// Two significant digits, for residuals in tables: "1.2e-16".
[[nodiscard]] QString shortText(double value);

/// 0 for what is only rounding beside numbers of the size of `scale`.
[[nodiscard]] double withoutNoise(double value, double scale);

/// The exact text where it is short, five significant digits otherwise: for tables, where columns are narrow.
[[nodiscard]] QString coordinateText(double value);

/// `text` of `value` if it fits, or the first that does of fewer digits, two at least; else "…".
[[nodiscard]] QString fittingText(double value, const QString& text, const std::function<bool(const QString&)>& fits);

[[nodiscard]] inline QString axisText(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

/// How many: "173 402", in groups that narrow spaces part and no line breaks.
[[nodiscard]] QString countText(Index count);
/// "1 vertex", "12 vertices" of "1 vertex" and "%1 vertices".
[[nodiscard]] QString countText(Index count, const char* one, const char* many);

/// "0.42 mm", rounded; without a unit where `units` is empty.
[[nodiscard]] QString lengthText(double length, const std::string& units);

/// "(1, 2.5, 3)", rounded and `withoutNoise`, or exact.
[[nodiscard]] QString roundedText(const Vector3& vector);
[[nodiscard]] QString exactText(const Vector3& vector);

/// What the user typed, blanks around it aside, as the nearest double; nothing where that is no finite number.
[[nodiscard]] std::optional<double> typedNumber(const QString& typed);

/// Why `typedNumber` gave nothing, and what to write instead.
[[nodiscard]] QString notANumber(const QString& typed);

}  // namespace holdfast
