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

/// How a document's lengths are written.
struct LengthStyle {
  std::string units;                           ///< the user's name of the model's length; may be empty
  std::optional<int> decimals = std::nullopt;  ///< behind the point; without it four significant digits
};

/// A length or a coordinate without its unit: "12.500" of three decimals.
[[nodiscard]] QString numberText(double value, const LengthStyle& style);

/// A coordinate of a narrow column: with the decimals of `style`; without them exact where that is short, else with
/// five significant digits.
[[nodiscard]] QString coordinateText(double value, const LengthStyle& style = {});

/// What a residual within its limit reads: "met ≤ 1.6e-10 mm". Digits below the limit are rounding.
[[nodiscard]] QString metText(double limit, const std::string& units);

/// `text` of `value` if it fits, or the first that does of fewer digits, two at least; else "…". Of words the first.
[[nodiscard]] QString fittingText(double value, const QString& text, const std::function<bool(const QString&)>& fits);

[[nodiscard]] inline QString axisText(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

/// How many: "173 402", in groups that narrow spaces part and no line breaks.
[[nodiscard]] QString countText(Index count);
/// "1 vertex", "12 vertices" of "1 vertex" and "%1 vertices".
[[nodiscard]] QString countText(Index count, const char* one, const char* many);

/// "0.42 mm" of a length that is not negative; "<0.001 mm" where the decimals would make it 0.
[[nodiscard]] QString lengthText(double length, const LengthStyle& style);

/// "(1, 2.5, 3)", rounded and `withoutNoise`, or exact.
[[nodiscard]] QString roundedText(const Vector3& vector);
/// The same with the decimals of `style`.
[[nodiscard]] QString placeText(const Vector3& place, const LengthStyle& style);
[[nodiscard]] QString exactText(const Vector3& vector);

/// What the user typed, blanks around it aside, as the nearest double; nothing where that is no finite number.
[[nodiscard]] std::optional<double> typedNumber(const QString& typed);

/// Why `typedNumber` gave nothing, and what to write instead.
[[nodiscard]] QString notANumber(const QString& typed);

}  // namespace holdfast
