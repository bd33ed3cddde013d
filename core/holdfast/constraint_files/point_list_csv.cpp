#include <algorithm>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/point_table_format_internal.h>
#include <holdfast/constraint_files/point_tables.h>

namespace holdfast {
namespace {

std::string inColumn(const std::string& column)
{
  return column.empty() ? "" : fmt::format("column {}", column);
}

/// What the columns mean is sure, and a table with titles names a target.
void requireClearColumns(const PointTable& table, const std::string& file)
{
  const auto fail = [&](const PointTableDoubt& doubt) {
    throw InputError({file, table.firstLine, inColumn(doubt.column)}, doubt.reason);
  };
  if (table.doubt) fail(*table.doubt);
  for (std::size_t column = kFirstTargetColumn; table.format.hasHeader && column < kPointColumns.size(); ++column)
    if (!table.format.columns[column]) fail(missingColumn(column, table.titles));
}

}  // namespace

PointList parsePointList(std::string_view text, const std::string& name, BadRows badRows)
{
  PointTable table = readPointTable(text, name);
  requireClearColumns(table, name);
  PointList list{{table.units, {}}, {}};
  for (PointTableRow& row : table.rows)
    if (row.fault.empty())
      list.list.constraints.push_back({std::move(row.name), true, std::move(*row.point), std::move(row.extra)});
    else if (badRows == BadRows::Skip)
      list.skippedRows.push_back({row.line, row.name, faultText(row)});
    else
      throw InputError({name, row.line, inColumn(row.column)}, row.fault);
  if (list.list.constraints.empty())
    throw InputError({name, list.skippedRows.front().line, ""},
                     "no row can be read; the first fault: " + list.skippedRows.front().fault);
  return list;
}

ConstraintList parsePointListCsv(std::string_view text, const std::string& name)
{
  return parsePointList(text, name, BadRows::Refuse).list;
}

}  // namespace holdfast
