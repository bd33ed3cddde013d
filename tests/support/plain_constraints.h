#pragma once
/// \file
/// Constraint files and point lists as plain JSON, without the readers under test.

#include <filesystem>

#include <nlohmann/json.hpp>

namespace holdfast::test {

/// The list of constraints in a constraint file; the rows of a point list (`.csv`, unquoted names) in the same form.
/// Those without a name get the default one.
[[nodiscard]] nlohmann::json readPlainConstraints(const std::filesystem::path& path);

}  // namespace holdfast::test
