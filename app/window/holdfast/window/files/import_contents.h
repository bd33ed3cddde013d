#pragma once
/// Reads the constraints of a file, and tells what they would be in a document.

#include <QString>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraint_files/point_tables.h>
#include <holdfast/document/point_lists.h>

namespace holdfast {

/// A constraint of the file, or what stands in its place.
struct ImportRow {
  std::string name;
  std::optional<Index> constraint = {};  ///< its place in the list; none if it cannot be read
  QString fault = {};                    ///< a sentence; empty if there is none
};

/// The constraints of a file, and what they would be in a document.
struct ImportContents {
  ConstraintList list;
  std::vector<ImportRow> rows;
  std::optional<PointTable> table;  ///< of a point list: its format and titles
  ImportPreview preview;
  std::vector<std::string> newNames;  ///< one for each constraint of the list: what the document will call it
};

/// Reads a constraint file or a point list. `format` is the format of the point list; without it, the function finds
/// the format itself. `present` has the names that are taken. A point list may have faulty rows, a constraint file may
/// not. Throws as `readTextFile`, `readPointTable` and `readConstraints` do.
[[nodiscard]] ImportContents readImport(const std::filesystem::path& path,
                                        const std::optional<PointTableFormat>& format, const ConstraintList& present,
                                        const Model& model);

}  // namespace holdfast
