#pragma once
/// \file
/// The files of the data folder: names and contents.

#include <string>
#include <vector>

namespace holdfast::generate {

struct File {
  std::string name;
  std::string bytes;
};

[[nodiscard]] std::vector<File> bracketFiles();
[[nodiscard]] std::vector<File> barFiles();
[[nodiscard]] std::vector<File> plateFiles();
[[nodiscard]] std::vector<File> headFiles();
[[nodiscard]] std::vector<File> smallFiles();

}  // namespace holdfast::generate
