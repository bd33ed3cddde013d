#pragma once
/// \file
/// Selections of constraint files and closest points, evaluated from the text of docs/formats.md with none of the code
/// under test.

#include <array>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "support/plain_mesh.h"

namespace holdfast::test {

/// The vertices that a selection names, ascending. Parts are those that faces connect by their ids. Rings are those of
/// meshes of triangles.
[[nodiscard]] std::vector<long> selectPlain(const nlohmann::json& selection, const PlainMesh& mesh);

/// The vertices of a constraint: those of its selection, and of the rings around it that it has.
[[nodiscard]] std::vector<long> verticesOfPlain(const nlohmann::json& constraint, const PlainMesh& mesh);

/// The point of the surface closest to `place`, as the corners of a face and their weights. All faces are looked at,
/// one after the other; they must be triangles.
[[nodiscard]] std::pair<std::array<long, 3>, std::array<long double, 3>> nearestPlain(const PlainMesh& mesh,
                                                                                      const PlainPoint& place);

}  // namespace holdfast::test
