#pragma once
/// \file
/// A folder that a test has for itself.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace holdfast::test {

/// An empty folder, removed with all that is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Names of what is in the folder, sorted.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Writes a file into the folder and returns its path.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// All bytes of a file.
[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);

}  // namespace holdfast::test
