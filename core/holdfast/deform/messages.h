#pragma once
/// \file
/// What a solve has to say, in sentences: what was wrong, where, and what to do.

#include <string>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// Of weights that are not finite at some vertices.
[[nodiscard]] std::string undefinedRowsMessage(const Model& model, const Operators& operators);

/// Of numbers that went wrong: `reason`, and the options that may help.
[[nodiscard]] std::string failureMessage(const DeformOptions& options, const std::string& reason);

/// Of a solution: what is met, and what is not. `limit` is the residual of a constraint that is met.
[[nodiscard]] std::string solvedMessage(const Report& report, double limit);

/// Of hard constraints that cannot be kept in doubles: which, by how much, and what to do.
[[nodiscard]] std::string missedMessage(const Report& report, double limit);

}  // namespace holdfast
