#pragma once
/// \file
/// The report of a solution as lines that people read and copy.

#include <QString>
#include <string>
#include <vector>

#include <holdfast/deform/report.h>

namespace holdfast {

/// A value with its title.
struct ReportLine {
  QString key;  ///< its name for scripts
  QString title;
  QString value;
  QString exact;  ///< with all digits, where `value` is rounded
};

/// In the order in which they are read.
using ReportLines = std::vector<ReportLine>;

[[nodiscard]] ReportLines reportLines(const Report& report, const std::string& units);

/// The lines as text, aligned.
[[nodiscard]] QString reportText(const ReportLines& lines);

}  // namespace holdfast
