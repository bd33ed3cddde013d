#include "holdfast/constraint_files/constraint_file.h"

#include <algorithm>

#include <holdfast/constraint_files/constraint_file_text_internal.h>

namespace holdfast {

bool isPointList(const std::filesystem::path& path)
{
  const std::string extension = path.extension().string();
  constexpr std::string_view kCsv = ".csv";
  return std::equal(extension.begin(), extension.end(), kCsv.begin(), kCsv.end(),
                    [](char a, char b) { return a == b || (b >= 'a' && b <= 'z' && a == b - 'a' + 'A'); });
}

ConstraintList readConstraints(const std::filesystem::path& path)
{
  const std::string text = readTextFile(path);
  return isPointList(path) ? parsePointListCsv(text, path.string()) : parseConstraintsJson(text, path.string());
}

}  // namespace holdfast
