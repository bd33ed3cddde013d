#pragma once
/// The report file (JSON, version 1). docs/formats.md describes every key.

#include <string>

#include <holdfast/deform/report.h>

namespace holdfast {

/// The text of a report file, indented, every double in its shortest exact form. Numbers that were not computed are
/// null.
[[nodiscard]] std::string reportToJson(const Report& report);

}  // namespace holdfast
