#pragma once
/// The output files of one command, written together or not at all.

#include <filesystem>
#include <vector>

#include <holdfast/io/files/output_file.h>

namespace holdfast::batch {

/// All outputs are written aside before any is put in its place. What cannot be written aside (devices, pipes, standard
/// output) goes first, because it may be full, while a rename hardly ever fails.
class Outputs {
 public:
  void add(const std::filesystem::path& path, std::string_view bytes) { files_.emplace_back(path, bytes); }

  void commitDirect() { commit(true); }
  void commitAside() { commit(false); }

  [[nodiscard]] const std::vector<OutputFile>& files() const noexcept { return files_; }

 private:
  void commit(bool areDirect)
  {
    for (OutputFile& file : files_)
      if (file.isDirect() == areDirect) file.commit();
  }

  std::vector<OutputFile> files_;
};

}  // namespace holdfast::batch
