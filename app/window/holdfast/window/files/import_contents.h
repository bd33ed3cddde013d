#pragma once
/// \file
/// The constraints of a file, and what they would be in a document. Made on any thread.

#include <filesystem>
#include <string>
#include <vector>

#include <holdfast/document/point_list_import.h>

namespace holdfast {

struct ImportContents {
  ConstraintList list;
  ImportPreview preview;
  std::vector<std::string> newNames;  ///< one for each constraint of the list: what the document will call it
};

/// Reads a constraint file or a point list, and looks where it would be in the document with the list `present`. Throws
/// as `readConstraints` does. O(n (log n + log T)).
[[nodiscard]] ImportContents readImport(const std::filesystem::path& path, const ConstraintList& present,
                                        const Model& model);

/// `present` with the constraints at `rows` of the contents at its end, by their new names.
[[nodiscard]] ConstraintList withImported(const ConstraintList& present, const ImportContents& contents,
                                          const std::vector<Index>& rows);

}  // namespace holdfast
