#include "holdfast/window/files/import_contents.h"

#include <utility>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>

namespace holdfast {

ImportContents readImport(const std::filesystem::path& path, const ConstraintList& present, const Model& model)
{
  ImportContents contents;
  contents.list = readConstraints(path);
  // What counts as far is up to the user, who has not said yet.
  contents.preview = previewImport(contents.list, present, model, 0);
  const ConstraintList all = pasted(present, contents.list);
  for (std::size_t k = present.constraints.size(); k < all.constraints.size(); ++k)
    contents.newNames.push_back(all.constraints[k].name);
  return contents;
}

ConstraintList withImported(const ConstraintList& present, const ImportContents& contents,
                            const std::vector<Index>& rows)
{
  ConstraintList imported = extracted(contents.list, rows);
  for (std::size_t k = 0; k < rows.size(); ++k) imported.constraints[k].name = contents.newNames[rows[k]];
  return pasted(present, std::move(imported));
}

}  // namespace holdfast
