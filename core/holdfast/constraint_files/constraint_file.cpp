#include "holdfast/constraint_files/constraint_file.h"

#include <holdfast/base/lower_case.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/io/files/file_bytes.h>

namespace holdfast {

bool isPointList(const std::filesystem::path& path)
{
  return lowerCase(path.extension().string()) == ".csv";
}

ConstraintList readConstraints(const std::filesystem::path& path)
{
  const std::string text = readTextFile(path);
  return isPointList(path) ? parsePointListCsv(text, path.string()) : parseConstraintsJson(text, path.string());
}

}  // namespace holdfast
