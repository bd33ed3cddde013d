#include "holdfast/document/point_tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/base/printable.h>
#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr std::size_t kRowsToGuessBy = 50;
constexpr std::size_t kFirstTarget = 4;

std::string blanksRemoved(const std::string& field)
{
  const std::size_t first = field.find_first_not_of(" \t");
  return first == std::string::npos ? "" : field.substr(first, field.find_last_not_of(" \t") - first + 1);
}

std::optional<double> numberIn(const std::string& field, char decimalSign)
{
  std::string digits = blanksRemoved(field);
  if (decimalSign == ',') {
    if (digits.find('.') != std::string::npos) return std::nullopt;
    std::ranges::replace(digits, ',', '.');
  }
  const auto [value, fault] = parseNumber<double>(digits);
  return fault == NumberFault::None && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

char separatorOf(std::string_view text)
{
  const std::string_view firstLine = text.substr(0, text.find_first_of("\r\n"));
  for (const char separator : {';', '\t'})
    if (firstLine.find(separator) != std::string_view::npos) return separator;
  return ',';
}

char decimalSignOf(const std::vector<CsvRecord>& records, char separator)
{
  if (separator == ',') return '.';
  for (std::size_t row = 0; row < std::min(records.size(), kRowsToGuessBy); ++row)
    for (const std::string& field : records[row].fields)
      if (field.find(',') != std::string::npos && numberIn(field, ',')) return ',';
  return '.';
}

PointTableFormat formatOf(const std::vector<CsvRecord>& records, char separator)
{
  PointTableFormat format{separator, decimalSignOf(records, separator), 1, true, {}};
  const std::vector<std::string>& first = records.front().fields;
  const auto isNumber = [&](const std::string& field) { return numberIn(field, format.decimalSign).has_value(); };
  format.hasHeader = std::ranges::none_of(first, isNumber);
  if (format.hasHeader)
    for (std::size_t place = first.size(); place-- > 0;)
      for (std::size_t column = 0; column < kPointColumns.size(); ++column)
        if (lowerCase(blanksRemoved(first[place])) == kPointColumns[column]) format.columns[column] = place;
  if (format.columns[1] && format.columns[2] && format.columns[3]) return format;
  const bool hasNames = first.size() != 3 && first.size() != 6;
  format.columns = {};
  if (hasNames) format.columns[0] = 0;
  const std::size_t count = first.size() < kPointColumns.size() - (hasNames ? 0 : 1) ? 3 : 6;
  for (std::size_t k = 0; k < count; ++k) format.columns[k + 1] = k + (hasNames ? 1 : 0);
  return format;
}

/// Reads numbers of one row, and keeps the first fault.
class RowReader {
 public:
  RowReader(const CsvRecord& record, const PointTableFormat& format) : record_(record), format_(format) {}

  [[nodiscard]] const std::string& fault() const { return fault_; }

  std::string name(std::size_t number) const
  {
    const std::optional<std::size_t> place = format_.columns[0];
    const bool isNamed = place && *place < record_.fields.size() && !record_.fields[*place].empty();
    return isNamed ? record_.fields[*place] : fmt::format("point {}", number);
  }

  Vector3 vector(std::size_t column) { return {number(column), number(column + 1), number(column + 2)}; }

 private:
  double number(std::size_t column)
  {
    const std::optional<std::size_t> place = format_.columns[column];
    const std::string field = place && *place < record_.fields.size() ? blanksRemoved(record_.fields[*place]) : "";
    if (const auto value = numberIn(field, format_.decimalSign)) return *value * format_.scale;
    if (fault_.empty())
      fault_ = field.empty() ? fmt::format("{} is missing", kPointColumns[column])
                             : fmt::format("{} is {}, which is not a number", kPointColumns[column], inQuotes(field));
    return 0;
  }

  const CsvRecord& record_;
  const PointTableFormat& format_;
  std::string fault_;
};

}  // namespace

PointTable readPointTable(std::string_view text, const std::string& file, const std::optional<PointTableFormat>& format)
{
  text = requireUtf8(text, file);
  const char separator = format ? format->separator : separatorOf(text);
  const std::vector<CsvRecord> records = splitCsv(text, file, separator);
  if (records.empty()) throw InputError({file, 1, ""}, "there are no rows; give a row for each point");
  const auto isGiven = [](const auto& place) { return place.has_value(); };
  PointTable table;
  table.format = format && std::ranges::any_of(format->columns, isGiven) ? *format : formatOf(records, separator);
  if (format) table.format.scale = format->scale;
  for (std::size_t place = 0; place < records.front().fields.size(); ++place)
    table.titles.push_back(table.format.hasHeader ? blanksRemoved(records.front().fields[place])
                                                  : fmt::format("column {}", place + 1));
  const bool hasTarget = std::any_of(table.format.columns.begin() + kFirstTarget, table.format.columns.end(), isGiven);
  std::map<std::string, Index> lineOf;  // by name
  for (std::size_t k = table.format.hasHeader ? 1 : 0; k < records.size(); ++k) {
    RowReader reader(records[k], table.format);
    PointTableRow row{records[k].line, reader.name(table.rows.size() + 1), {}, {}};
    const Vector3 place = reader.vector(1);
    const Vector3 target = hasTarget ? reader.vector(kFirstTarget) : place;
    row.fault = reader.fault();
    if (records[k].fields.size() > table.titles.size())
      row.fault = fmt::format("it has {} fields, the first row has {}", records[k].fields.size(), table.titles.size());
    if (row.fault.empty()) row.point = PointConstraint{AtNear{place}, Target{target}};
    if (const auto [first, isNew] = lineOf.try_emplace(row.name, row.line); !isNew && row.fault.empty())
      row.fault = fmt::format("its name is that of line {}, too", first->second);
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) throw InputError({file, 1, ""}, "there is no row after the header; add a line a point");
  return table;
}

}  // namespace holdfast
