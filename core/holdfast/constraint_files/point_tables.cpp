#include "holdfast/constraint_files/point_tables.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/constraint_files/point_table_format_internal.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

std::string textOfField(const CsvRecord& record, std::size_t place)
{
  return place < record.fields.size() ? std::string(withoutBlanks(record.fields[place])) : "";
}

bool isEmptyRow(const CsvRecord& record)
{
  return std::ranges::all_of(record.fields, [](const std::string& field) { return withoutBlanks(field).empty(); });
}

/// Units that stand apart from their titles, as in "x [mm] y [mm]" split at blanks, go back to them.
void joinUnits(std::vector<std::string>& titles)
{
  for (std::size_t place = 1; place < titles.size();)
    if (titles[place].starts_with('[') || titles[place].starts_with('(')) {
      titles[place - 1] += ' ' + titles[place];
      titles.erase(titles.begin() + static_cast<std::ptrdiff_t>(place));
    } else {
      ++place;
    }
}

/// What is wrong with a field that is no number.
std::string numberFault(std::string_view digits, NumberFault fault, char decimalSign)
{
  if (digits.empty()) return "a number is missing; every coordinate is needed";
  if (fault == NumberFault::OutOfRange)
    return fmt::format("{} does not fit a number in double precision", shortened(digits));
  const char other = decimalSign == ',' ? '.' : ',';
  if (digits.find(other) == std::string_view::npos)
    return fmt::format("{} is not a number; correct it", inQuotes(digits));
  return fmt::format("{} is not a number; the decimal sign is a {}", inQuotes(digits),
                     decimalSign == ',' ? "comma in this table" : "point");
}

/// Reads rows; of each it keeps the first fault.
class RowReader {
 public:
  RowReader(const PointTableFormat& format, const std::vector<std::string>& titles) : format_(format), titles_(titles)
  {
    for (const auto& place : format.columns)
      if (place) lastUsed_ = std::max(lastUsed_, *place);
  }

  [[nodiscard]] PointTableRow read(const CsvRecord& record, std::size_t number) const
  {
    PointTableRow row{record.line, nameOf(record, number), {}, extraOf(record), "", lengthFault(record)};
    const Vector3 place = vectorOf(record, kFirstPlaceColumn, row);
    const bool hasTarget = std::any_of(format_.columns.begin() + kFirstTargetColumn, format_.columns.end(),
                                       [](const auto& column) { return column.has_value(); });
    const Vector3 target = hasTarget ? vectorOf(record, kFirstTargetColumn, row) : place;
    if (!row.fault.empty()) return row;
    PointConstraint& point = row.point.emplace();
    point.at = AtNear{place};
    point.to = Target{target};
    return row;
  }

 private:
  [[nodiscard]] std::string nameOf(const CsvRecord& record, std::size_t number) const
  {
    const std::optional<std::size_t> place = format_.columns[0];
    const bool isNamed = place && !textOfField(record, *place).empty();
    return isNamed ? record.fields[*place] : fmt::format("point {}", number);
  }

  /// Fields that are empty may be too many, and those that mean nothing may be missing.
  [[nodiscard]] std::string lengthFault(const CsvRecord& record) const
  {
    const std::size_t count = record.fields.size();
    const auto isNotEmpty = [&](std::size_t place) { return !textOfField(record, place).empty(); };
    bool isLong = false;
    for (std::size_t place = titles_.size(); place < count; ++place) isLong = isLong || isNotEmpty(place);
    if (count > lastUsed_ && !isLong) return "";
    const char* const hint =
        isLong ? "decimal signs are points, and a name with a comma stands in double quotes" : "complete the row";
    return fmt::format("this row has {} fields, the {} has {}; {}", count, format_.hasHeader ? "header" : "first row",
                       titles_.size(), hint);
  }

  Vector3 vectorOf(const CsvRecord& record, std::size_t column, PointTableRow& row) const
  {
    return {numberOf(record, column, row), numberOf(record, column + 1, row), numberOf(record, column + 2, row)};
  }

  double numberOf(const CsvRecord& record, std::size_t column, PointTableRow& row) const
  {
    const std::optional<std::size_t> place = format_.columns[column];
    const std::string digits = place ? textOfField(record, *place) : "";
    const auto [value, fault] = numberInField(digits, format_.decimalSign);
    if (fault == NumberFault::None) return value * format_.scale;
    if (row.fault.empty()) {
      row.column = kPointColumns[column];
      row.fault = numberFault(digits, fault, format_.decimalSign);
    }
    return 0;
  }

  [[nodiscard]] std::vector<ExtraText> extraOf(const CsvRecord& record) const
  {
    std::vector<ExtraText> extra;
    for (std::size_t place = 0; place < std::min(titles_.size(), record.fields.size()); ++place) {
      const bool isUsed = std::ranges::count(format_.columns, std::optional(place)) != 0;
      if (std::string text = textOfField(record, place); !isUsed && !text.empty())
        extra.push_back({titles_[place], std::move(text)});
    }
    return extra;
  }

  const PointTableFormat& format_;
  const std::vector<std::string>& titles_;
  std::size_t lastUsed_ = 0;  // of the columns
};

/// Titles that are empty or stand there before get the number of their column.
std::vector<std::string> differentTitles(const CsvRecord& first, bool hasHeader)
{
  std::vector<std::string> titles;
  for (std::size_t place = 0; place < first.fields.size(); ++place) {
    std::string title = hasHeader ? textOfField(first, place) : "";
    if (title.empty())
      title = fmt::format("column {}", place + 1);
    else if (std::ranges::count(titles, title) != 0)
      title += fmt::format(" (column {})", place + 1);
    titles.push_back(std::move(title));
  }
  return titles;
}

/// The unit in a row below the titles that has nothing but units where numbers should be; empty for other rows.
std::string unitOfRow(const CsvRecord& record, const PointTableFormat& format)
{
  std::string unit;
  for (std::size_t column = kFirstPlaceColumn; column < format.columns.size(); ++column) {
    if (!format.columns[column]) continue;
    const std::string found = unitIn(textOfField(record, *format.columns[column]));
    if (found.empty() || (!unit.empty() && found != unit)) return "";
    unit = found;
  }
  return unit;
}

void markRepeatedNames(std::vector<PointTableRow>& rows)
{
  std::map<std::string_view, Index> lineOf;
  for (PointTableRow& row : rows) {
    const auto [first, isNew] = lineOf.try_emplace(row.name, row.line);
    if (isNew || !row.fault.empty()) continue;
    row.column = kPointColumns[0];
    row.fault = fmt::format(
        "{} is the name of the point in line {} already; names are unique, and the name of a row "
        "without one is \"point\" and its number",
        inQuotes(row.name), first->second);
  }
}

}  // namespace

std::string faultText(const PointTableRow& row)
{
  return row.column.empty() ? row.fault : fmt::format("column {}: {}", row.column, row.fault);
}

PointTable readPointTable(std::string_view text, const std::string& file, const std::optional<PointTableFormat>& format)
{
  text = requireUtf8(text, file);
  const TablePreamble preamble = preambleOf(text);
  text.remove_prefix(preamble.size);
  const char separator = format ? format->separator : preamble.separator ? *preamble.separator : separatorOf(text);
  std::vector<CsvRecord> records = splitCsv(text, file, separator, preamble.lines + 1);
  std::erase_if(records, isEmptyRow);
  if (records.empty())
    throw InputError({file, 1, ""}, fmt::format("there is no header and no row; the first line must be {}",
                                                fmt::join(kPointColumns, ",")));
  if (separator == ' ') joinUnits(records.front().fields);
  const bool isChosen = format && std::ranges::any_of(format->columns, [](const auto& c) { return c.has_value(); });
  FoundFormat found = isChosen ? FoundFormat{*format, "", {}} : formatOf(records, separator);
  if (format) found.format.scale = format->scale;
  PointTable table{found.format,         differentTitles(records.front(), found.format.hasHeader),
                   records.front().line, found.units,
                   found.doubt,          {}};
  const RowReader reader(table.format, table.titles);
  std::size_t first = table.format.hasHeader ? 1 : 0;
  if (const std::string unit = first < records.size() ? unitOfRow(records[first], table.format) : ""; !unit.empty()) {
    table.units = unit;
    ++first;
  }
  for (std::size_t k = first; k < records.size(); ++k)
    table.rows.push_back(reader.read(records[k], table.rows.size() + 1));
  if (table.rows.empty())
    throw InputError({file, table.firstLine, ""}, "there is no row after the header; add one line for each point");
  markRepeatedNames(table.rows);
  return table;
}

}  // namespace holdfast
