#pragma once
/// \file
/// The inside of closed curves of constraint files, evaluated from the text of docs/formats.md with none of the code
/// under test.

#include <set>

#include <nlohmann/json_fwd.hpp>

#include "support/plain_mesh.h"

namespace holdfast::test {

/// The vertices on the curve and on its smaller side. It serves meshes of triangles without repeated vertices, on which
/// no two paths are equally long, and curves through `near` places that do not cross themselves.
[[nodiscard]] std::set<long> insidePlain(const nlohmann::json& curve, const PlainMesh& mesh);

}  // namespace holdfast::test
