#pragma once
/// \file
/// Experiments as tests run them: from the project's root, with outputs in a folder that goes away.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "bench/paper/experiments.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast::paper {

class PaperTest : public testing::Test {
 protected:
  PaperTest() { std::filesystem::current_path(test::sourceFolder()); }

  [[nodiscard]] const Workbench& bench() const { return bench_; }

  /// The section of an experiment. Expects tables without holes, and pictures that were written.
  [[nodiscard]] Section sectionOf(Section (*experiment)(const Workbench&)) const
  {
    Section section = experiment(bench_);
    EXPECT_FALSE(section.paper.empty());
    EXPECT_FALSE(section.method.empty());
    for (const Table& table : section.tables)
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    for (const Illustration& picture : section.pictures) {
      const std::string path = picture.isCommitted ? bench_.picture(picture.file) : picture.file;
      EXPECT_GT(std::filesystem::file_size(path), 500) << path;
    }
    return section;
  }

 private:
  test::TemporaryFolder folder_;
  Workbench bench_{{folder_.path() / "out", folder_.path() / "pictures", folder_.path() / "models"}};
};

}  // namespace holdfast::paper
