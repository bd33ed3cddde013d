#include "holdfast/window/files/import_contents.h"

#include <QObject>
#include <utility>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

ImportContents readImport(const std::filesystem::path& path, const std::optional<PointTableFormat>& format,
                          const ConstraintList& present, const Model& model)
{
  ImportContents contents;
  const auto add = [&](ImportRow row, Constraint&& constraint) {
    row.constraint = static_cast<Index>(contents.list.constraints.size());
    contents.rows.push_back(std::move(row));
    contents.list.constraints.push_back(std::move(constraint));
  };
  if (const std::string text = readTextFile(path); isPointList(path, text)) {
    contents.table = readPointTable(text, path.string(), format);
    contents.list.units = contents.table->units;
    for (PointTableRow& row : std::exchange(contents.table->rows, {})) {
      const QString fault =
          row.fault.empty() ? QString() : QObject::tr("Line %1: %2.").arg(row.line).arg(toText(faultText(row)));
      if (row.point)
        add({row.name, {}, fault}, {row.name, true, *row.point, row.extra});
      else
        contents.rows.push_back({row.name, {}, fault});
    }
  } else {
    ConstraintList read = readConstraints(path);
    contents.list.units = read.units;
    for (Constraint& constraint : read.constraints) add({constraint.name}, std::move(constraint));
  }
  contents.preview = previewImport(contents.list, present, model);
  const ConstraintList all = pasted(present, contents.list);
  for (std::size_t k = present.constraints.size(); k < all.constraints.size(); ++k)
    contents.newNames.push_back(all.constraints[k].name);
  return contents;
}

}  // namespace holdfast
