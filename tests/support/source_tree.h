#pragma once
/// \file
/// Where tests find what the project ships.

#include <string>

namespace holdfast::test {

/// The folder of the sample meshes and constraint files, without a slash at its end.
[[nodiscard]] std::string dataFolder();

/// The project's root folder, without a slash at its end.
[[nodiscard]] std::string sourceFolder();

}  // namespace holdfast::test
