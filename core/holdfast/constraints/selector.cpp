#include "holdfast/constraints/selector.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

namespace holdfast {
namespace {

/// Walks the expression: checks its ids, and puts the vertices that curves select in their place.
struct Resolver {
  const Mesh& mesh;
  Index componentCount;
  CurveSelector& curves;
  InputLocation where;

  [[nodiscard]] Selection resolved(const Selection& selection) const
  {
    return std::visit([this](const auto& what) { return Selection{(*this)(what)}; }, selection.what);
  }

  VertexIds operator()(const VertexIds& vertices) const
  {
    for (const Index v : vertices.ids) requireVertex(mesh, v, where, ".vertices");
    return vertices;
  }
  InComponent operator()(const InComponent& component) const
  {
    if (component.component < 0 || component.component >= componentCount)
      throw InputError(below(where, ".component"),
                       fmt::format("there is no part {}; the mesh has {} connected parts, numbered from 0",
                                   component.component, componentCount));
    return component;
  }
  VertexIds operator()(const InsideCurve& curve) const { return {curves.select(curve, below(where, ".curve"))}; }
  AllOf operator()(const AllOf& all) const { return {parts(all.parts, ".all")}; }
  AnyOf operator()(const AnyOf& any) const { return {parts(any.parts, ".any")}; }
  NotIn operator()(const NotIn& none) const
  {
    return {std::make_shared<const Selection>(at(".not").resolved(*none.part))};
  }
  template <class Shape>
  Shape operator()(const Shape& shape) const
  {
    return shape;
  }

 private:
  [[nodiscard]] Resolver at(const std::string& key) const { return {mesh, componentCount, curves, below(where, key)}; }

  [[nodiscard]] std::vector<Selection> parts(const std::vector<Selection>& parts, const char* key) const
  {
    std::vector<Selection> result;
    for (std::size_t k = 0; k < parts.size(); ++k)
      result.push_back(at(fmt::format("{}[{}]", key, k)).resolved(parts[k]));
    return result;
  }
};

}  // namespace

Selector::Selector(const Mesh& mesh, const SolverMesh& solverMesh, SurfaceLocator locator)
    : mesh_(mesh),
      componentOf_(componentOfVertices(solverMesh)),
      componentCount_(solverMesh.componentCount),
      curves_(mesh, solverMesh, std::move(locator))
{
}

std::vector<Index> Selector::select(const Selection& selection, const InputLocation& where)
{
  const Selection resolved = Resolver{mesh_, componentCount_, curves_, where}.resolved(selection);
  std::vector<Index> vertices = holdfast::select(resolved, mesh_.positions, componentOf_);
  if (vertices.empty())
    throw InputError(where, "selects no vertex of the mesh; check its place and size, or remove the constraint");
  return vertices;
}

}  // namespace holdfast
