#pragma once
/// What holdfast-batch says: results on standard output, everything else on standard error.

#include <string_view>

namespace holdfast::batch {

/// Writes `text` to standard output at once. Throws `OutputError` where it does not arrive there (disk full, closed).
void printResult(std::string_view text);

/// Writes `text` to standard error. Failures are ignored: there is no other place to report them.
void printMessage(std::string_view text) noexcept;

}  // namespace holdfast::batch
