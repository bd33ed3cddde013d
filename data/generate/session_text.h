#pragma once
/// \file
/// Sessions as text, by the project's own writer.

#include "files.h"

namespace holdfast::generate {

/// A session beside `mesh`, with the constraints of a constraint file, coloured by displacement.
[[nodiscard]] std::string sessionText(const File& mesh, const std::string& constraints);

}  // namespace holdfast::generate
