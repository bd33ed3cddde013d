// A part as it is exported with shared corners and with copies of them is the same part: no mean counts a corner twice.

#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using Motion = decltype(HandleConstraint::motion);

// A few roundings of numbers up to 10.
constexpr double kRoundingOfMeans = 1e-14;

/// The vertices whose x is in a range, in the order of the file.
std::vector<Index> between(const Mesh& mesh, double low, double high)
{
  std::vector<Index> ids;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions(v, 0) >= low && mesh.positions(v, 0) <= high) ids.push_back(v);
  return ids;
}

/// A grid whose corners belong to one, two, three and six triangles.
Mesh sharedCorners()
{
  return test::grid(5, 3);
}

/// One end of it is fixed, the other is a handle with that motion; `makeMotion` gets its vertices.
template <class MakeMotion>
ConstraintSystem handleSystem(const Mesh& mesh, const MakeMotion& makeMotion)
{
  const std::vector<Index> end = between(mesh, 4, 5);
  return test::systemOf(mesh, test::listOf({test::hold(between(mesh, 0, 1)),
                                            test::handle(end, makeMotion(mesh, end), Vector3(-1, 2, 0.5))}));
}

using Place = std::tuple<double, double, double>;

/// By place at rest: where its unknown goes.
std::map<Place, Vector3> targetsOf(const ConstraintSystem& system)
{
  std::map<Place, Vector3> result;
  for (const ConstraintRow& row : system.rows) {
    const Vector3 rest = row.target - row.shift;
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    result[{rounded(rest.x()), rounded(rest.y()), rounded(rest.z())}] = row.target;
  }
  return result;
}

template <class MakeMotion>
void expectSameWithCopies(const MakeMotion& makeMotion)
{
  const ConstraintSystem shared = handleSystem(sharedCorners(), makeMotion);
  const ConstraintSystem copied = handleSystem(test::soup(sharedCorners()), makeMotion);
  const auto expected = targetsOf(shared);
  const auto actual = targetsOf(copied);
  ASSERT_EQ(expected.size(), 16U);
  ASSERT_EQ(actual.size(), expected.size());
  for (const auto& [place, target] : expected) EXPECT_LT((actual.at(place) - target).norm(), kRoundingOfMeans);
  ASSERT_EQ(copied.rotations.size(), shared.rotations.size());
  EXPECT_LT((copied.rotations.back().q - shared.rotations.back().q).norm(), kRoundingOfMeans);
}

Motion aboutAxis(const Mesh& /*mesh*/, const std::vector<Index>& /*vertices*/)
{
  return AxisRotation{{1, 2, 3}, 70, std::nullopt};
}

Motion betweenFrames(const Mesh& /*mesh*/, const std::vector<Index>& /*vertices*/)
{
  FrameMotion motion;
  motion.to = Frame{std::nullopt, {0, 1, 0}, {-1, 0, 0.3}};
  return motion;
}

Motion aboutFixed(const Mesh& /*mesh*/, const std::vector<Index>& /*vertices*/)
{
  return RotationAboutFixed{};
}

/// Stretched unevenly, so that the rotation that fits depends on how often a corner counts.
Motion toPlaces(const Mesh& mesh, const std::vector<Index>& vertices)
{
  VertexTargets targets;
  for (const Index v : vertices) {
    const Vector3 p = mesh.positions.row(v);
    targets.places.emplace_back(p.x() + 0.1 * p.y() * p.y(), p.y() - 0.3 * p.x() * p.y(), 0.2 * p.x() * p.y() * p.y());
  }
  return targets;
}

TEST(CopiesOfCorners, DoNotMoveTheDefaultCentreOfAHandle)
{
  expectSameWithCopies(aboutAxis);
}

TEST(CopiesOfCorners, DoNotMoveTheOriginOfFrames)
{
  expectSameWithCopies(betweenFrames);
}

TEST(CopiesOfCorners, DoNotMoveTheCentroidsThatAHandleTurnsBetween)
{
  expectSameWithCopies(aboutFixed);
}

TEST(CopiesOfCorners, CountOnceInTheRotationThatFitsTargets)
{
  expectSameWithCopies(toPlaces);
}

}  // namespace
}  // namespace holdfast
