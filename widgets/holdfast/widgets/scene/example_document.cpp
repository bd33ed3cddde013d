#include "holdfast/widgets/scene/example_document.h"

namespace holdfast {
namespace {

// Vertices along a side.
constexpr Index kSide = 4;

Mesh sheet()
{
  Mesh mesh;
  mesh.positions.resize(kSide * kSide, 3);
  for (Index y = 0; y < kSide; ++y)
    for (Index x = 0; x < kSide; ++x)
      mesh.positions.row(x + kSide * y) << static_cast<double>(x), static_cast<double>(y), 0;
  for (Index y = 0; y + 1 < kSide; ++y)
    for (Index x = 0; x + 1 < kSide; ++x) {
      const Index corner = x + kSide * y;
      mesh.faces.add({corner, corner + 1, corner + kSide + 1});
      mesh.faces.add({corner, corner + kSide + 1, corner + kSide});
    }
  return mesh;
}

Constraint moved(const std::string& name, Index vertex, const Vector3& shift, bool isEnabled = true)
{
  return {name, isEnabled, PointConstraint{AtVertex{vertex}, Move{shift}}};
}

ConstraintList everyKind()
{
  const AxisRotation turn{Vector3::UnitX(), 60, {}};
  return {"",
          {{"held", true, FixedConstraint{{VertexIds{{0, 1}}}}},
           {"turned", true, HandleConstraint{{VertexIds{{14, 15}}}, turn, Vector3::UnitZ(), {}}},
           {"rigid", true, RigidConstraint{{VertexIds{{5, 6, 9}}}}},
           {"in a face", true, PointConstraint{AtFace{4, {0.2, 0.3, 0.5}}, Move{Vector3::UnitZ()}}},
           moved("repeated", 0, Vector3::Zero()),
           moved("in conflict", 1, Vector3::UnitZ()),
           moved("disabled", 3, Vector3::UnitZ(), false)}};
}

}  // namespace

ExampleDocument exampleDocument()
{
  ExampleDocument example{makeModel(sheet(), "example"), everyKind(), {}};
  example.deformation = deform(example.model, example.list);
  return example;
}

}  // namespace holdfast
