#include <fmt/format.h>

#include <holdfast/constraints/selection_check.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

/// Walks the expression and checks its leaves.
struct IdCheck {
  const Mesh& mesh;
  Index componentCount;
  InputLocation where;

  void check(const Selection& selection) const { std::visit(*this, selection.what); }

  void operator()(const VertexIds& vertices) const
  {
    for (const Index v : vertices.ids) requireVertex(mesh, v, where, ".vertices");
  }
  void operator()(const InComponent& component) const
  {
    if (component.component < 0 || component.component >= componentCount)
      throw InputError(below(where, ".component"),
                       fmt::format("there is no part {}; the mesh has {} connected parts, numbered from 0",
                                   component.component, componentCount));
  }
  void operator()(const AllOf& all) const { checkParts(all.parts, ".all"); }
  void operator()(const AnyOf& any) const { checkParts(any.parts, ".any"); }
  void operator()(const NotIn& none) const { IdCheck{mesh, componentCount, below(where, ".not")}.check(*none.part); }
  void operator()(const InBox& /*box*/) const {}
  void operator()(const InSphere& /*sphere*/) const {}
  void operator()(const InHalfSpace& /*halfSpace*/) const {}

 private:
  void checkParts(const std::vector<Selection>& parts, const char* key) const
  {
    for (std::size_t k = 0; k < parts.size(); ++k)
      IdCheck{mesh, componentCount, below(where, fmt::format("{}[{}]", key, k))}.check(parts[k]);
  }
};

}  // namespace

std::vector<Index> selectOrThrow(const Selection& selection, const Mesh& mesh, const std::vector<Index>& componentOf,
                                 Index componentCount, const InputLocation& where)
{
  IdCheck{mesh, componentCount, where}.check(selection);
  std::vector<Index> vertices = select(selection, mesh.positions, componentOf);
  if (vertices.empty())
    throw InputError(where, "selects no vertex of the mesh; check its place and size, or remove the constraint");
  return vertices;
}

}  // namespace holdfast
