#pragma once
/// \file
/// The report of a solution as lines that people read and copy.

#include <QString>
#include <string>
#include <vector>

#include <holdfast/deform/report.h>

namespace holdfast {

/// A value with its title; `key` names it for scripts.
struct ReportLine {
  QString key;
  QString title;
  QString value;
};

/// In the order in which they are read.
using ReportLines = std::vector<ReportLine>;

[[nodiscard]] ReportLines reportLines(const Report& report, const std::string& units);

/// The lines as text, aligned.
[[nodiscard]] QString reportText(const ReportLines& lines);

}  // namespace holdfast
