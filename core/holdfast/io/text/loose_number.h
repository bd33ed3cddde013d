#pragma once
/// These functions read numbers as programs of all kinds write them into mesh files.

#include <string_view>

#include <holdfast/io/text/number_text.h>

namespace holdfast {

/// Reads a number as `parseNumber<double>` does, and takes more. A magnitude too small for a double is 0 with its sign.
/// "1.#QNAN", "-1.#IND00" and "1.#INF" are NaN and infinity, as old C libraries of Windows print them. "1.5D+3" has an
/// exponent of Fortran.
[[nodiscard]] ParsedNumber<double> parseLooseNumber(std::string_view token);

/// Tells whether the '#' at `hash` belongs to a number like "1.#INF" and begins no comment.
[[nodiscard]] bool hasSpecialAt(std::string_view text, std::size_t hash);

}  // namespace holdfast
