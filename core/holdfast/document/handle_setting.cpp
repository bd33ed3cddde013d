#include "holdfast/document/handle_setting.h"

#include <algorithm>

#include <fmt/format.h>

#include <holdfast/geometry/centroid.h>

namespace holdfast {

HandleSetting settingOf(const Model& model, const ConstraintList& list, Index index, const std::string& source)
{
  SurfaceLocator locator(model.mesh, model.triangulation);
  Selector selector(model.mesh, model.solverMesh, locator);
  const auto& handle = std::get<HandleConstraint>(list.constraints[index].what);
  const InputLocation where = placeInList(source, index);
  const std::vector<Index> selected = selector.select(handle.select, below(where, ".select"));
  const auto* listed = std::get_if<VertexIds>(&handle.select.what);
  const bool isInOrder = listed != nullptr && listed->ids.size() == selected.size();
  return {rowsOf(model.mesh.positions, isInOrder ? listed->ids : selected),
          {centerOfFixed(model, list, selector, source), model.solverMesh.diagonal},
          where};
}

InputLocation placeInList(const std::string& source, Index constraint)
{
  return {source, 0, fmt::format("constraints[{}]", constraint)};
}

Positions rowsOf(const Positions& positions, const std::vector<Index>& vertices)
{
  return positions(vertices, Eigen::all);
}

std::optional<Vector3> centerOfFixed(const Model& model, const ConstraintList& list, Selector& selector,
                                     const std::string& source)
{
  std::vector<Index> fixed;
  for (std::size_t c = 0; c < list.constraints.size(); ++c) {
    const auto* what = std::get_if<FixedConstraint>(&list.constraints[c].what);
    if (!what || !list.constraints[c].isEnabled) continue;
    const auto selected = selector.select(what->select, below(placeInList(source, static_cast<Index>(c)), ".select"));
    fixed.insert(fixed.end(), selected.begin(), selected.end());
  }
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  if (fixed.empty()) return std::nullopt;
  return centroid(rowsOf(model.mesh.positions, fixed));
}

}  // namespace holdfast
