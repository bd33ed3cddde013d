#pragma once
/// \file
/// Where the handles of constraint files go, from the text of docs/formats.md with none of the code under test.

#include <array>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "support/plain_mesh.h"

namespace holdfast::test {

using PlainPlace = std::array<long double, 3>;

/// Of those vertices, at rest.
[[nodiscard]] PlainPlace centroidOf(const std::vector<long>& vertices, const PlainMesh& rest);

/// Each vertex of a handle, and the place where it goes: the sum of two doubles where it does not turn. `fixed` are the
/// vertices of all enabled constraints of type `fixed`, each once. Throws `std::runtime_error` for keys that a handle
/// does not have.
[[nodiscard]] std::vector<std::pair<long, PlainPlace>> placesOfHandle(const nlohmann::json& handle,
                                                                      const std::vector<long>& fixed,
                                                                      const PlainMesh& rest);

/// Tells whether the handle is turned: if not, it goes to places that can be copied.
[[nodiscard]] bool isTurned(const nlohmann::json& handle);

}  // namespace holdfast::test
