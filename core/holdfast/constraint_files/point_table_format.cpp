#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <holdfast/constraint_files/point_table_format_internal.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>
#include <holdfast/words/spelling.h>

namespace holdfast {
namespace {

using Fields = std::vector<std::string>;

constexpr std::size_t kFirstTargetPlace = 3;  // without names

/// How titles may be written, as `partsOf` has them. The name may also stand under the titles of `kOtherNames`.
constexpr std::array<std::array<std::string_view, 3>, kPointColumns.size()> kKeys{{{"name"},
                                                                                   {"x"},
                                                                                   {"y"},
                                                                                   {"z"},
                                                                                   {"targetx", "xtarget", "tx"},
                                                                                   {"targety", "ytarget", "ty"},
                                                                                   {"targetz", "ztarget", "tz"}}};
constexpr std::array<std::string_view, 3> kOtherNames{"id", "label", "point"};

std::optional<std::size_t> columnOfKey(std::string_view key)
{
  for (std::size_t column = 0; column < kKeys.size(); ++column)
    if (!key.empty() && std::ranges::count(kKeys[column], key) != 0) return column;
  return std::nullopt;
}

/// The fields of one line, with their quotes: what a separator makes of it is only looked at.
Fields fieldsOfLine(std::string_view line, char separator)
{
  Fields fields(1);
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"') isQuoted = !isQuoted;
    if (!isQuoted && (c == separator || (separator == ' ' && c == '\t')))
      fields.emplace_back();
    else if (c != '"')
      fields.back() += c;
  }
  if (separator == ' ') std::erase(fields, "");
  return fields;
}

bool namesPlaces(const Fields& titles)
{
  std::array<bool, kPointColumns.size()> isThere{};
  for (const std::string& title : titles)
    if (const auto column = columnOfKey(partsOf(title).key)) isThere[*column] = true;
  return isThere[kFirstPlaceColumn] && isThere[kFirstPlaceColumn + 1] && isThere[kFirstPlaceColumn + 2];
}

bool isNumber(std::string_view field, char decimalSign)
{
  return numberInField(field, decimalSign).fault == NumberFault::None;
}

bool hasThreeNumbers(const Fields& fields)
{
  return std::ranges::count_if(
             fields, [](const std::string& field) { return isNumber(field, '.') || isNumber(field, ','); }) >= 3;
}

/// Whichever of both signs more numbers have. Between commas numbers have points.
char decimalSignOf(const std::vector<CsvRecord>& records, char separator)
{
  if (separator == ',') return '.';
  std::ptrdiff_t commas = 0;
  std::ptrdiff_t points = 0;
  for (const CsvRecord& record : records)
    for (const std::string& field : record.fields) {
      if (field.find(',') != std::string::npos && isNumber(field, ',')) ++commas;
      if (field.find('.') != std::string::npos && isNumber(field, '.')) ++points;
    }
  return commas > points ? ',' : '.';
}

bool isWhole(std::string_view field)
{
  const std::string_view digits = withoutBlanks(field);
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Tells whether the first column of a table without titles has names: something that is no number, or numbers that
/// count.
bool beginsWithNames(const std::vector<CsvRecord>& records, char decimalSign)
{
  std::set<std::string_view> different;
  bool areWhole = true;
  for (const CsvRecord& record : records) {
    if (!isNumber(record.fields.front(), decimalSign)) return true;
    areWhole = areWhole && isWhole(record.fields.front());
    different.insert(record.fields.front());
  }
  return areWhole && different.size() == records.size();
}

/// Tells whether `holds` is true of the three numbers from column `first` on in every row that has them.
template <class Holds>
bool holdsOfAll(const std::vector<CsvRecord>& records, std::size_t first, char decimalSign, const Holds& holds)
{
  return std::ranges::all_of(records, [&](const CsvRecord& record) {
    if (record.fields.size() < first + 3) return true;
    std::array<double, 3> numbers{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [value, fault] = numberInField(record.fields[first + k], decimalSign);
      if (fault != NumberFault::None) return true;
      numbers[k] = value;
    }
    return holds(numbers);
  });
}

/// Tells whether the numbers from column 3 on are normals or colours, as clouds of points have them, and no targets: of
/// length 1, or whole from 0 to 255, and the places are not.
bool areNormalsOrColors(const std::vector<CsvRecord>& records, char decimalSign)
{
  const auto isUnit = [](const std::array<double, 3>& v) {
    constexpr double kRounded = 1e-3;  // three digits, as such files have at least
    return std::abs(Vector3(v[0], v[1], v[2]).norm() - 1) < kRounded;
  };
  const auto isColor = [](const std::array<double, 3>& v) {
    return std::ranges::all_of(v, [](double x) { return x >= 0 && x <= 255 && x == std::floor(x); });
  };
  const auto areOnlyTargets = [&](const auto& holds) {
    return holdsOfAll(records, kFirstTargetPlace, decimalSign, holds) && !holdsOfAll(records, 0, decimalSign, holds);
  };
  return areOnlyTargets(isUnit) || areOnlyTargets(isColor);
}

/// Columns in the order of `kPointColumns`.
void setColumns(PointTableFormat& format, bool hasNames, bool hasTargets)
{
  const std::size_t shift = hasNames ? 1 : 0;
  if (hasNames) format.columns[0] = 0;
  for (std::size_t k = 0; k < (hasTargets ? 6 : 3); ++k) format.columns[k + 1] = k + shift;
}

std::string headerText()
{
  return fmt::format("{}", fmt::join(kPointColumns, ","));
}

/// A table whose first row has numbers.
void setColumnsWithoutTitles(FoundFormat& found, const std::vector<CsvRecord>& records)
{
  const std::size_t count = records.front().fields.size();
  const char sign = found.format.decimalSign;
  const bool canHaveNames = count != 3 && count != 6;
  const bool hasNames = canHaveNames && (count != 4 || beginsWithNames(records, sign));
  const bool hasTargets = count > 6 || (count == 6 && !areNormalsOrColors(records, sign));
  setColumns(found.format, hasNames, hasTargets);
  const bool isClear = count == 3 || count == 4 || count == 6 || (count == 7 && beginsWithNames(records, sign));
  if (!isClear)
    found.doubt = {"", fmt::format("the table has no titles and {}, whose meaning is not clear; begin it with "
                                   "a line of titles: {}, and others where there are more columns",
                                   counted(static_cast<Index>(count), "column"), headerText())};
}

/// Units of the columns that are used. Where they differ nothing says which of them is that of the mesh.
void takeUnits(FoundFormat& found, const Fields& titles)
{
  std::size_t first = 0;
  for (std::size_t column = kFirstPlaceColumn; column < kPointColumns.size(); ++column) {
    const std::optional<std::size_t> place = found.format.columns[column];
    const std::string unit = place ? partsOf(titles[*place]).unit : "";
    if (unit.empty()) continue;
    if (found.units.empty()) {
      found.units = unit;
      first = column;
    } else if (unit != found.units && !found.doubt) {
      found.doubt = {std::string(kPointColumns[column]),
                     fmt::format("this column is in {}, and {} is in {}; write all of them in the unit of the mesh",
                                 shortened(unit), kPointColumns[first], shortened(found.units))};
    }
  }
}

std::optional<std::size_t> placeOfOtherName(const Fields& titles)
{
  for (const std::string_view name : kOtherNames)
    for (std::size_t place = 0; place < titles.size(); ++place)
      if (partsOf(titles[place]).key == name) return place;
  return std::nullopt;
}

void setColumnsByTitles(FoundFormat& found, const Fields& titles)
{
  auto& columns = found.format.columns;
  for (std::size_t place = 0; place < titles.size(); ++place) {
    const std::optional<std::size_t> column = columnOfKey(partsOf(titles[place]).key);
    if (!column) continue;
    if (!columns[*column])
      columns[*column] = place;
    else if (!found.doubt)
      found.doubt = {std::string(kPointColumns[*column]), "this column stands here more than once; keep one"};
  }
  if (!columns[0]) columns[0] = placeOfOtherName(titles);
  takeUnits(found, titles);
}

/// A header that does not name x, y and z.
void guessColumns(FoundFormat& found, const Fields& titles)
{
  setColumns(found.format, titles.size() != 3 && titles.size() != 6, titles.size() >= 6);
  for (std::size_t column = kFirstPlaceColumn; column < kFirstTargetColumn && !found.doubt; ++column)
    if (std::ranges::none_of(titles, [&](const auto& title) { return columnOfKey(partsOf(title).key) == column; }))
      found.doubt = missingColumn(column, titles);
}

}  // namespace

FoundFormat formatOf(const std::vector<CsvRecord>& records, char separator)
{
  const Fields& first = records.front().fields;
  FoundFormat found{{separator, decimalSignOf(records, separator), 1, true, {}}, "", {}};
  const bool isNamed = namesPlaces(first);
  found.format.hasHeader =
      isNamed || std::ranges::none_of(first, [&](const auto& f) { return isNumber(f, found.format.decimalSign); });
  if (!found.format.hasHeader)
    setColumnsWithoutTitles(found, records);
  else if (isNamed)
    setColumnsByTitles(found, first);
  else
    guessColumns(found, first);
  return found;
}

bool isHeaderLine(std::string_view line)
{
  return namesPlaces(fieldsOfLine(line, separatorOf(line)));
}

bool isRowLine(std::string_view line)
{
  return hasThreeNumbers(fieldsOfLine(line, separatorOf(line)));
}

PointTableDoubt missingColumn(std::size_t column, const std::vector<std::string>& titles)
{
  std::vector<std::string_view> others;
  for (const std::string& title : titles)
    if (!columnOfKey(partsOf(title).key)) others.push_back(title);
  const auto meant = closestSpelling(kPointColumns[column], others);
  return {std::string(kPointColumns[column]),
          fmt::format("this column is missing{}; the header is {}",
                      meant ? fmt::format("; is it the one called {}?", inQuotes(*meant)) : "", headerText())};
}

char separatorOf(std::string_view text)
{
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  for (const char separator : kSeparators)
    if (const Fields fields = fieldsOfLine(line, separator); namesPlaces(fields) || hasThreeNumbers(fields))
      return separator;
  for (const char separator : kSeparators)
    if (fieldsOfLine(line, separator).size() > 1) return separator;
  return ',';
}

}  // namespace holdfast
