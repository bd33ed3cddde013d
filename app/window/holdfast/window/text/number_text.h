#pragma once
/// Writes and reads numbers as the window does, whatever the locale is.

#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns the text that `text` has in UTF-8.
[[nodiscard]] inline QString toText(std::string_view text)
{
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// Returns the shortest text that reads back as the same double.
[[nodiscard]] QString exactText(double value);

/// Returns four significant digits, for numbers that are only shown.
[[nodiscard]] QString roundedText(double value);

/// Returns two significant digits, for residuals in tables: "1.2e-16".
[[nodiscard]] QString shortText(double value);

/// Returns the value, or 0 if it is only rounding beside numbers of the size of `scale`.
[[nodiscard]] double withoutNoise(double value, double scale);

/// Says how a document's lengths are written.
struct LengthStyle {
  std::string units;                           ///< the user's name of the model's length; may be empty
  std::optional<int> decimals = std::nullopt;  ///< behind the point; without it four significant digits
};

/// Returns a length or a coordinate without its unit: "12.500" with three decimals.
[[nodiscard]] QString numberText(double value, const LengthStyle& style);

/// Returns a coordinate for a narrow column. It has the decimals of `style`. Without decimals it is exact where that is
/// short, else it has five significant digits.
[[nodiscard]] QString coordinateText(double value, const LengthStyle& style = {});

/// Returns what is shown for a residual within its limit: "met ≤ 1.6e-10 mm". Digits below the limit are rounding.
[[nodiscard]] QString metText(double limit, const std::string& units);

/// Returns `text`, which is that of `value`, if it fits. Else it returns the first text with fewer digits that fits,
/// with at least two of them, or else "…". If `text` consists of words that do not fit, it returns the first word.
[[nodiscard]] QString fittingText(double value, const QString& text, const std::function<bool(const QString&)>& fits);

[[nodiscard]] inline QString axisText(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

/// Returns a number of things: "173 402". Narrow spaces part its groups of digits, and no line breaks there.
[[nodiscard]] QString countText(Index count);
/// Returns a number of things with their name: "1 vertex" or "12 vertices" of "1 vertex" and "%1 vertices".
[[nodiscard]] QString countText(Index count, const char* one, const char* many);

/// Returns a length with its unit: "0.42 mm". It returns "<0.001 mm" where the decimals would make it 0. The length is
/// not negative.
[[nodiscard]] QString lengthText(double length, const LengthStyle& style);

/// Returns "(1, 2.5, 3)", rounded and `withoutNoise`.
[[nodiscard]] QString roundedText(const Vector3& vector);
/// Returns the rounded text of a place with the decimals of `style`.
[[nodiscard]] QString placeText(const Vector3& place, const LengthStyle& style);
/// Returns "(1, 2.5, 3)", with the exact text of each number.
[[nodiscard]] QString exactText(const Vector3& vector);

/// Returns what the user typed as the nearest double, without blanks around it. It returns nothing if that is no finite
/// number.
[[nodiscard]] std::optional<double> typedNumber(const QString& typed);

/// Returns why `typedNumber` has returned nothing, and what to write instead.
[[nodiscard]] QString notANumber(const QString& typed);

}  // namespace holdfast
