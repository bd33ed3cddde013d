#include <algorithm>
#include <cmath>
#include <map>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

enum Column : std::size_t { kName, kX, kY, kZ, kTargetX, kTargetY, kTargetZ, kColumnCount };

constexpr std::array<std::string_view, kColumnCount> kColumnNames{"name",     "x",        "y",       "z",
                                                                  "target_x", "target_y", "target_z"};

/// Where in a record each column is.
using Places = std::array<std::size_t, kColumnCount>;

std::string_view trimmed(std::string_view field)
{
  const std::size_t first = field.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return field.substr(first, field.find_last_not_of(" \t") - first + 1);
}

class PointListReader {
 public:
  PointListReader(std::string_view file, char separator) : file_(file), separator_(separator) {}

  [[nodiscard]] ConstraintList read(std::string_view text) const
  {
    if (separator_ == ',') requireCommas(text);
    const std::vector<CsvRecord> records = splitCsv(text, file_, separator_);
    if (records.empty()) fail(1, "", fmt::format("there is no header; the first line must be {}", header()));
    const Places places = readHeader(records.front());
    if (records.size() == 1) fail(records.front().line, "", "there is no row after the header; add a line a point");
    return readRows(records, places);
  }

 private:
  [[noreturn]] void fail(Index line, std::string_view column, const std::string& reason) const
  {
    throw InputError({std::string(file_), line, column.empty() ? "" : fmt::format("column {}", column)}, reason);
  }

  static std::string header() { return fmt::format("{}", fmt::join(kColumnNames, ",")); }

  /// Tables with other separators are common where the comma is the decimal sign.
  void requireCommas(std::string_view text) const
  {
    const std::string_view firstLine = text.substr(0, text.find_first_of("\r\n"));
    if (firstLine.find(',') != std::string_view::npos) return;
    for (const auto& [separator, name] : {std::pair(';', "semicolons"), std::pair('\t', "tabs")})
      if (firstLine.find(separator) != std::string_view::npos)
        fail(
            1, "",
            fmt::format("the fields are separated by {}; separate them by commas, with points as decimal signs", name));
  }

  [[nodiscard]] Places readHeader(const CsvRecord& record) const
  {
    constexpr std::size_t kMissing = static_cast<std::size_t>(-1);
    Places places;
    places.fill(kMissing);
    for (std::size_t place = 0; place < record.fields.size(); ++place) {
      const std::string_view name = trimmed(record.fields[place]);
      const auto column = static_cast<std::size_t>(std::ranges::find(kColumnNames, name) - kColumnNames.begin());
      if (column == kColumnCount)
        fail(record.line, "",
             fmt::format("unknown column {}{}. The first line is the header", inQuotes(name),
                         spellingHint(name, kColumnNames)));
      if (std::exchange(places[column], place) != kMissing)
        fail(record.line, name, "this column stands here more than once; keep one");
    }
    for (std::size_t column = 0; column < kColumnCount; ++column)
      if (places[column] == kMissing)
        fail(record.line, kColumnNames[column], fmt::format("this column is missing; the header is {}", header()));
    return places;
  }

  [[nodiscard]] ConstraintList readRows(const std::vector<CsvRecord>& records, const Places& places) const
  {
    ConstraintList list;
    std::map<std::string, Index, std::less<>> lineOf;  // by name
    for (std::size_t row = 1; row < records.size(); ++row) {
      requireLength(records[row]);
      list.constraints.push_back(readRow(records[row], places, row));
      const std::string& name = list.constraints.back().name;
      const auto [first, isNew] = lineOf.try_emplace(name, records[row].line);
      if (!isNew)
        fail(records[row].line, kColumnNames[kName],
             fmt::format("{} is the name of the point in line {} already; names are unique, and the name of a row "
                         "without one is \"point\" and its number",
                         inQuotes(name), first->second));
    }
    return list;
  }

  void requireLength(const CsvRecord& record) const
  {
    if (record.fields.size() == kColumnCount) return;
    const char* hint = record.fields.size() > kColumnCount
                           ? "decimal signs are points, and a name with a comma stands in double quotes"
                           : "fill the row up";
    fail(record.line, "",
         fmt::format("this row has {} fields, the header has {}; {}", record.fields.size(),
                     static_cast<std::size_t>(kColumnCount), hint));
  }

  [[nodiscard]] Constraint readRow(const CsvRecord& record, const Places& places, std::size_t row) const
  {
    const auto number = [&](Column column) { return readNumber(record.fields[places[column]], record.line, column); };
    const std::string& name = record.fields[places[kName]];
    const Vector3 place(number(kX), number(kY), number(kZ));
    const Vector3 target(number(kTargetX), number(kTargetY), number(kTargetZ));
    return {name.empty() ? fmt::format("point {}", row) : name, true, PointConstraint{AtNear{place}, Target{target}}};
  }

  [[nodiscard]] double readNumber(std::string_view field, Index line, Column column) const
  {
    const std::string_view digits = trimmed(field);
    if (digits.empty()) fail(line, kColumnNames[column], "a number is missing; every coordinate is needed");
    const auto [value, fault] = parseNumber<double>(digits);
    if (fault == NumberFault::OutOfRange)
      fail(line, kColumnNames[column], fmt::format("{} does not fit a number in double precision", shortened(digits)));
    if (fault == NumberFault::None && std::isfinite(value)) return value;
    const bool hasComma = digits.find(',') != std::string_view::npos;
    fail(line, kColumnNames[column],
         fmt::format("{} is not a number{}", inQuotes(digits),
                     hasComma ? "; the decimal sign is a point" : "; correct it"));
  }

  std::string_view file_;
  char separator_;
};

}  // namespace

ConstraintList parsePointListCsv(std::string_view text, const std::string& name, char separator)
{
  return PointListReader(name, separator).read(requireUtf8(text, name));
}

}  // namespace holdfast
