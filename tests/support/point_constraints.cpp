#include "support/point_constraints.h"

#include <utility>

namespace holdfast::test {
namespace {

/// `count` positive multiples of 1/16 of sum 1.
std::vector<double> sixteenths(Random& random, std::size_t count)
{
  std::vector<double> weights(count, 1.0 / 16);
  for (auto left = 16 - static_cast<long>(count); left > 0; --left)
    weights[random.integer(0, static_cast<long>(count) - 1)] += 1.0 / 16;
  return weights;
}

}  // namespace

Constraint moveBy(SurfaceLocation at, const Vector3& shift)
{
  return {"", true, PointConstraint{std::move(at), Move{shift}}};
}

Constraint moveTo(SurfaceLocation at, const Vector3& target)
{
  return {"", true, PointConstraint{std::move(at), Target{target}}};
}

Constraint hold(std::vector<Index> vertices)
{
  return {"", true, FixedConstraint{{VertexIds{std::move(vertices)}}}};
}

Constraint rigid(std::vector<Index> vertices)
{
  return {"", true, RigidConstraint{{VertexIds{std::move(vertices)}}}};
}

Constraint handle(std::vector<Index> vertices, decltype(HandleConstraint::motion) motion, const Vector3& translate)
{
  return {"", true, HandleConstraint{{VertexIds{std::move(vertices)}}, std::move(motion), translate, {}}};
}

ConstraintList listOf(std::vector<Constraint> constraints)
{
  ConstraintList list{"", std::move(constraints)};
  for (std::size_t c = 0; c < list.constraints.size(); ++c) list.constraints[c].name = "P" + std::to_string(c);
  return list;
}

SurfaceLocation randomPlace(Random& random, const Mesh& mesh)
{
  const Index f = random.integer(0, mesh.faces.size() - 1);
  const auto face = mesh.faces[f];
  const auto count = static_cast<long>(face.size());
  const long k = random.integer(0, count - 1);
  switch (random.integer(0, 2)) {
    case 0:
      return AtVertex{face[k]};
    case 1:
      return AtEdge{face[k], face[(k + 1) % count], static_cast<double>(random.integer(1, 15)) / 16};
    default:
      return AtFace{f, sixteenths(random, face.size())};
  }
}

ConstraintList randomMoves(Random& random, const Mesh& mesh, int count, double size)
{
  std::vector<Constraint> constraints;
  for (int c = 0; c < count; ++c) {
    SurfaceLocation place = randomPlace(random, mesh);
    constraints.push_back(moveBy(std::move(place), randomVector(random, size)));
  }
  return listOf(std::move(constraints));
}

Vector3 randomVector(Random& random, double size)
{
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {x, y, z};
}

}  // namespace holdfast::test
