#pragma once
/// \file
/// The output files of one command, written together or not at all.

#include <filesystem>
#include <string>
#include <vector>

#include <holdfast/io/files/output_file.h>

namespace holdfast::batch {

/// All outputs are written aside before any is put in its place. What cannot be written aside (devices, pipes, standard
/// output) goes first, because it may turn out to be full, while a rename hardly fails.
class Outputs {
 public:
  /// Writes aside. Throws `OutputError`.
  void add(const std::filesystem::path& path, std::string_view bytes) { files_.emplace_back(path, bytes); }

  /// Writes what cannot be written aside. Throws `OutputError`.
  void commitDirect();
  /// Puts the others in their places; call it last. Throws `OutputError`.
  void commitAside();

  /// A line for each, for people.
  [[nodiscard]] std::string names() const;

 private:
  std::vector<OutputFile> files_;
};

}  // namespace holdfast::batch
