#pragma once
/// \file
/// The form of report files, version 1: every key with its type.

#include <gtest/gtest.h>
#include <nlohmann/json_fwd.hpp>

namespace holdfast::test {

/// How far the run came that made the report; what was not computed is null.
enum class SolveState { Solved, Failed, NotRun };

/// Tells whether `report` has every key of the format with a value of its type and range, and no value outside what the
/// format lists.
[[nodiscard]] testing::AssertionResult isReport(const nlohmann::json& report, SolveState state);

}  // namespace holdfast::test
