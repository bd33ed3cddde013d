#pragma once
/// \file
/// A triangle mesh under construction, with a name for each part of its surface.

#include <string>
#include <vector>

#include "half_edges.h"

namespace holdfast::generate {

/// Consecutive faces from `firstFace` on belong to `name`, until the next group begins.
struct Group {
  std::string name;
  Index firstFace = 0;
};

struct GroupedMesh {
  std::vector<Vector3> points;
  std::vector<Triangle> triangles;
  std::vector<Group> groups;
};

/// The faces of each group together, groups in the order of their first appearance; patches of one name become one.
[[nodiscard]] GroupedMesh gathered(const GroupedMesh& mesh);

/// The faces of the group `name`. Throws std::logic_error where there is none.
[[nodiscard]] std::vector<Index> facesOf(const GroupedMesh& mesh, const std::string& name);

/// Coordinates to a millionth of a unit: shorter files, and no trace of how the last bits of a sine came out.
[[nodiscard]] Vector3 rounded(const Vector3& place);
[[nodiscard]] GroupedMesh rounded(GroupedMesh mesh);

}  // namespace holdfast::generate
