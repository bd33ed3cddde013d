// Surfaces that stay their own mirror images.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/mirror_pairs.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Constraint mirrorAcross(const Vector3& point, const Vector3& normal)
{
  return {"mirror", true, MirrorConstraint{point, normal, {}, {holdfast::AllOf{}}, {}}};
}

/// A slab with the same triangles on both sides of x = 0.
Mesh symmetricSlab()
{
  Mesh mesh;
  mesh.positions.resize(9 * 7, 3);
  for (Index j = 0; j < 7; ++j)
    for (Index i = 0; i < 9; ++i) {
      const double x = static_cast<double>(i) - 4;
      mesh.positions.row(9 * j + i) << x + 0.05 * x * static_cast<double>(j % 3), static_cast<double>(j),
          0.1 * x * x + 0.05 * static_cast<double>(j * j);
    }
  const auto at = [](Index i, Index j) { return static_cast<int>(9 * j + i); };
  for (Index j = 0; j < 6; ++j)
    for (Index i = 0; i < 4; ++i) {
      mesh.faces.add(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.add(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      mesh.faces.add(std::array{at(8 - i, j), at(7 - i, j + 1), at(7 - i, j)});
      mesh.faces.add(std::array{at(8 - i, j), at(8 - i, j + 1), at(7 - i, j + 1)});
    }
  return mesh;
}

Index partner(Index vertex)
{
  return vertex - vertex % 9 + 8 - vertex % 9;
}

Vector3 image(const Vector3& place)
{
  return {-place.x(), place.y(), place.z()};
}

/// How far the vertices are from being images of their partners.
double asymmetry(const Positions& positions)
{
  double largest = 0;
  for (Index v = 0; v < positions.rows(); ++v)
    largest = std::max(largest, (image(positions.row(v)) - Vector3(positions.row(partner(v)))).cwiseAbs().maxCoeff());
  return largest;
}

TEST(MirrorPairs, AreMutuallyNearest)
{
  const Mesh mesh = symmetricSlab();
  std::vector<Index> all;
  for (Index v = 0; v < mesh.vertexCount(); ++v) all.push_back(v);
  const MirrorPairs found = mirrorPairs(mesh.positions, all, Vector3::Zero(), Vector3(2, 0, 0), 1e-9);
  EXPECT_EQ(found.pairs.size(), 28U);
  EXPECT_EQ(found.onPlane.size(), 7U);
  EXPECT_TRUE(found.unpaired.empty());
  for (const auto& [a, b] : found.pairs) EXPECT_EQ(partner(a), b);
  for (const Index v : found.onPlane) EXPECT_EQ(partner(v), v);
}

TEST(MirrorPairs, AreMissingWhereTheSurfaceIsNotSymmetric)
{
  Mesh mesh = symmetricSlab();
  mesh.positions(3, 2) += 0.01;
  const std::vector<Index> some{3, 4, 12};
  const MirrorPairs found = mirrorPairs(mesh.positions, some, Vector3::Zero(), Vector3::UnitX(), 1e-3);
  EXPECT_THAT(found.unpaired, ElementsAre(3));
  EXPECT_THAT(found.onPlane, ElementsAre(4));
  EXPECT_THAT(found.pairs, ElementsAre(std::array<Index, 2>{12, 14}));
  EXPECT_TRUE(mirrorPairs(mesh.positions, some, Vector3::Zero(), Vector3::UnitX(), 0.02).unpaired.empty());
}

TEST(MirrorPairs, TellThePlaneOfSymmetry)
{
  const std::optional<MirrorConstraint> ofSlab = symmetryOf(symmetricSlab().positions, 1e-6);
  ASSERT_TRUE(ofSlab);
  EXPECT_EQ(ofSlab->normal, Vector3::UnitX());
  EXPECT_EQ(ofSlab->point, Vector3::Zero());
  const Mesh apart = test::moved(symmetricSlab(), {5, 0, 0});
  EXPECT_EQ(symmetryOf(apart.positions, 1e-6)->point.x(), 5);
  EXPECT_FALSE(symmetryOf(test::plate(6, 7).positions, 1e-6));
}

/// Constraints on both sides, each the image of one on the other; or those of one side alone and a mirror.
ConstraintList sided(bool isMirrored, const RotationSource source)
{
  const Mesh mesh = symmetricSlab();
  std::vector<Constraint> list{test::hold({0, 1, 2, 3, 4, 5, 6, 7, 8})};
  const Vector3 shift(0.3, -0.2, 0.4);
  list.push_back(test::moveBy(AtVertex{37}, shift));
  if (!isMirrored) list.push_back(test::moveBy(AtVertex{43}, image(shift)));
  list.push_back(
      {"", true, HandleConstraint{{VertexIds{{54, 55, 45}}}, AxisRotation{{1, 2, 3}, 40, {}}, {0.1, 0.2, 0.5}, {}}});
  if (!isMirrored)
    list.push_back(
        {"", true,
         HandleConstraint{{VertexIds{{62, 61, 53}}}, AxisRotation{{1, -2, -3}, 40, {}}, {-0.1, 0.2, 0.5}, {}}});
  const auto regions = source == RotationSource::Given;
  if (regions) {
    list.push_back(test::rigid({19, 20, 28, 29}));
    if (!isMirrored) list.push_back(test::rigid({24, 25, 33, 34}));
  }
  if (isMirrored) list.push_back(mirrorAcross(Vector3::Zero(), Vector3::UnitX()));
  return test::listOf(std::move(list));
}

TEST(MirrorConstraint, MakesOneSideWhatConstraintsOnBothWouldMake)
{
  const Mesh mesh = symmetricSlab();
  for (const RotationSource source : {RotationSource::Given, RotationSource::Found})
    for (const Weights weights : test::allWeights())
      for (const Backend backend : test::backends()) {
        DeformOptions options{weights, {SolverKind::Hard, backend, 5}};
        options.rotations.source = source;
        const DeformResult both = test::deformed(mesh, sided(false, source), options);
        const DeformResult one = test::deformed(mesh, sided(true, source), options);
        EXPECT_EQ(both.report.solve.status, SolveStatus::Ok) << both.report.solve.message;
        EXPECT_EQ(one.report.solve.status, SolveStatus::Ok) << one.report.solve.message;
        const double same = source == RotationSource::Given ? 1e-12 : 1e-6;
        EXPECT_LT(test::distance(one.positions, both.positions), same);
        EXPECT_LT(asymmetry(one.positions), 1e-13);
        EXPECT_LT((one.rotations - both.rotations).cwiseAbs().maxCoeff(), same);
      }
}

TEST(MirrorConstraint, HandsRotationsOnAsAxialVectors)
{
  const DeformResult result = test::deformed(symmetricSlab(), sided(true, RotationSource::Given), {});
  for (Index v = 0; v < result.rotations.rows(); ++v) {
    const Vector3 q = result.rotations.row(v);
    const Vector3 other = result.rotations.row(partner(v));
    EXPECT_LT((other - Vector3(q.x(), -q.y(), -q.z())).norm(), 1e-13);
    EXPECT_LT((rotationMatrix(other) * image(Vector3(1, 2, 3)) - image(rotationMatrix(q) * Vector3(1, 2, 3))).norm(),
              1e-12);
  }
}

TEST(MirrorConstraint, HandsRigidRegionsOnWithWhatTheyHaveOnThePlane)
{
  // Vertex 22 lies on the plane.
  const ConstraintList list = test::listOf({test::rigid({20, 22}), mirrorAcross(Vector3::Zero(), Vector3::UnitX())});
  const Model model = makeModel(symmetricSlab(), "slab");
  KnownPlaces places;
  for (int again = 0; again < 2; ++again) {
    const ConstraintSystem system =
        makeConstraintSystem(list, model.mesh, model.solverMesh, model.locator(), "list", places);
    EXPECT_THAT(system.rigidRegions, ElementsAre(ElementsAre(20, 22), ElementsAre(22, 24)));
  }
}

TEST(MirrorConstraint, FindsPartnersAnewWhereItIsAnother)
{
  ConstraintList list = test::listOf({test::hold({0}), mirrorAcross(Vector3::Zero(), Vector3::UnitX())});
  const Model model = makeModel(symmetricSlab(), "slab");
  KnownPlaces places;
  const auto rows = [&] {
    return makeConstraintSystem(list, model.mesh, model.solverMesh, model.locator(), "list", places).rows.size();
  };
  EXPECT_EQ(rows(), 1U + 2 * 28 + 7);
  auto& mirror = std::get<MirrorConstraint>(list.constraints[1].what);
  mirror.select = {VertexIds{{0, 4}}};
  EXPECT_EQ(rows(), 1U + 2 + 1);
  mirror.select = {holdfast::AllOf{}};
  EXPECT_EQ(rows(), 1U + 2 * 28 + 7);
}

TEST(MirrorConstraint, KeepsWhatIsOnThePlaneOnIt)
{
  const DeformResult result =
      test::deformed(symmetricSlab(),
                     test::listOf({test::hold({0, 1}), test::moveBy(AtVertex{60}, {0.2, 0.1, 0.5}),
                                   mirrorAcross(Vector3::Zero(), Vector3::UnitX())}),
                     {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (Index v = 4; v < 63; v += 9) EXPECT_EQ(result.positions(v, 0), 0);
}

TEST(MirrorConstraint, WorksAcrossAnyPlane)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.translate(Vector3(3, -2, 1)).rotate(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  const DeformResult upright =
      test::deformed(symmetricSlab(),
                     test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{60}, {0.2, 0.1, 0.5}),
                                   mirrorAcross(Vector3::Zero(), Vector3::UnitX())}),
                     {});
  const DeformResult oblique = test::deformed(
      test::transformed(symmetricSlab(), motion),
      test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{60}, motion.linear() * Vector3(0.2, 0.1, 0.5)),
                    mirrorAcross(motion * Vector3(0, 7, 3), motion.linear() * Vector3(5, 0, 0))}),
      {});
  EXPECT_EQ(oblique.report.solve.status, SolveStatus::Ok) << oblique.report.solve.message;
  EXPECT_LE(oblique.report.solve.maxResidualRelative, 1e-14);
  for (Index v = 0; v < upright.positions.rows(); ++v)
    EXPECT_LT((motion * Vector3(upright.positions.row(v)) - Vector3(oblique.positions.row(v))).norm(), 1e-11);
}

TEST(MirrorConstraint, TakesPartnersThatAreListed)
{
  test::Random random(7);
  Mesh mesh = symmetricSlab();
  for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.positions.row(v) += test::randomVector(random, 0.05).transpose();
  MirrorConstraint mirror;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (v <= partner(v)) mirror.pairs.push_back({partner(v), v});
  const DeformResult result =
      test::deformed(mesh, test::listOf({test::moveBy(AtVertex{60}, {0.2, 0.1, 0.5}), {"mirror", true, mirror}}), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT(asymmetry(result.positions), 1e-14) << "what is not symmetric at rest becomes so";
}

TEST(MirrorConstraint, TakesAPartWhoseImageIsAnotherPart)
{
  const Mesh left = test::moved(test::plate(4, 4), {-10, 0, 0});
  Mesh right = left;
  right.positions.col(0) *= -1;
  const Mesh mesh = test::merged(left, right);
  const Index half = left.vertexCount();
  const DeformResult result =
      test::deformed(mesh,
                     test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{half - 1}, {0.2, 0.1, 0.5}),
                                   mirrorAcross(Vector3::Zero(), Vector3::UnitX())}),
                     {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (Index v = 0; v < half; ++v)
    EXPECT_LT((image(result.positions.row(v)) - Vector3(result.positions.row(v + half))).norm(), 1e-14);
  // A mirror alone places neither part.
  const DeformResult alone = test::deformed(mesh, test::listOf({mirrorAcross(Vector3::Zero(), Vector3::UnitX())}), {});
  EXPECT_EQ(alone.report.solve.status, SolveStatus::Ok) << alone.report.solve.message;
  EXPECT_LT((alone.positions - mesh.positions).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(MirrorConstraint, TwoPlanesMakeAQuarterEnough)
{
  const Mesh box = test::box({2, 2, 6}, 4);
  const Vector3 middle = (box.positions.colwise().minCoeff() + box.positions.colwise().maxCoeff()).transpose() / 2;
  Index corner = 0;
  (box.positions.rowwise().sum()).maxCoeff(&corner);
  std::vector<Index> foot;
  for (Index v = 0; v < box.vertexCount(); ++v)
    if (box.positions(v, 2) == box.positions.col(2).minCoeff()) foot.push_back(v);
  // A box whose triangles are not symmetric is still met: its places are.
  const DeformResult result =
      test::deformed(box,
                     test::listOf({test::hold(foot), test::moveBy(AtVertex{corner}, {0.5, 0.25, 1}),
                                   mirrorAcross(middle, Vector3::UnitX()), mirrorAcross(middle, Vector3::UnitY())}),
                     {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  const Vector3 moved = Vector3(result.positions.row(corner)) - middle;
  for (const Vector3& signs : {Vector3(-1, 1, 1), Vector3(1, -1, 1), Vector3(-1, -1, 1)}) {
    const Vector3 before = middle + signs.cwiseProduct(Vector3(box.positions.row(corner)) - middle);
    Index v = 0;
    (box.positions.rowwise() - before.transpose()).rowwise().norm().minCoeff(&v);
    EXPECT_LT((Vector3(result.positions.row(v)) - middle - signs.cwiseProduct(moved)).norm(), 1e-13);
  }
}

TEST(MirrorConstraint, ThatTwoPointsContradictIsNamedWithThem)
{
  std::vector<Constraint> three{test::moveTo(AtVertex{45}, {-4, 5, 3}), test::moveTo(AtVertex{53}, {4, 5, 3.5}),
                                mirrorAcross(Vector3::Zero(), Vector3::UnitX())};
  std::vector<int> order{0, 1, 2};
  do {
    ConstraintList list{"", {{"base", true, FixedConstraint{{VertexIds{{0, 1, 2}}}}}}};
    const std::array names{"left", "right", "mirror"};
    for (const int k : order) {
      list.constraints.push_back(three[k]);
      list.constraints.back().name = names[k];
    }
    const DeformResult result = test::deformed(symmetricSlab(), list, {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
    const ConstraintOutcome& last = result.report.constraints.back();
    EXPECT_EQ(last.status, ConstraintStatus::Conflicting);
    ASSERT_FALSE(last.conflictSets.empty());
    EXPECT_THAT(last.conflictSets.front().with, testing::UnorderedElementsAre(names[order[0]], names[order[1]]));
    EXPECT_NEAR(last.conflictSets.front().gap.norm(), 0.5, 1e-12);
  } while (std::ranges::next_permutation(order).found);
}

TEST(MirrorConstraint, NamesVerticesWithoutPartners)
{
  Mesh mesh = symmetricSlab();
  mesh.positions(30, 2) += 0.1;
  const DeformResult result =
      test::deformed(mesh, test::listOf({test::hold({0, 1}), mirrorAcross(Vector3::Zero(), Vector3::UnitX())}), {});
  ASSERT_EQ(result.details->system.notes.size(), 1U);
  EXPECT_EQ(result.details->system.notes[0].kind, "unpaired_vertices");
  EXPECT_THAT(result.details->system.notes[0].message, HasSubstr("2 of 63 vertices"));
  EXPECT_THAT(result.details->system.notes[0].message, HasSubstr("30, 32;"));
}

TEST(MirrorConstraint, ThatMakesNoSenseIsRefused)
{
  const auto refusal = [](MirrorConstraint mirror) -> std::string {
    try {
      static_cast<void>(test::deformed(symmetricSlab(), test::listOf({{"M", true, std::move(mirror)}}), {}));
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal({{100, 0, 0}, {1, 0, 0}, {}, {holdfast::AllOf{}}, {}}), HasSubstr("no vertex has a partner"));
  EXPECT_THAT(refusal({{0, 0, 0}, {0, 0, 0}, {}, {holdfast::AllOf{}}, {}}), HasSubstr("direction is zero"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {}, {holdfast::AllOf{}}, {{0, 8}, {63, 1}}}),
              AllOf(HasSubstr(".pairs[1]"), HasSubstr("63")));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {}, {holdfast::AllOf{}}, {{0, 8}, {8, 1}}}),
              HasSubstr("pairs[0] has a vertex of it already"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {}, {VertexIds{{1}}}, {{0, 8}}}), HasSubstr("leave one of both out"));
}

TEST(MirrorInFiles, HasItsKeys)
{
  const auto parsed = [](const std::string& keys) {
    return parseConstraintsJson(
        R"({"format": "holdfast-constraints", "version": 2, "constraints": [{"type": "mirror", "plane": )" + keys +
            "}]}",
        "f.json");
  };
  const ConstraintList plain = parsed(R"({"point": [1, 2, 3], "normal": [0, 2, 0]})");
  EXPECT_EQ(std::get<MirrorConstraint>(plain.constraints[0].what).normal, Vector3(0, 2, 0));
  EXPECT_THAT(constraintsToJson(plain), AllOf(HasSubstr("\"version\": 2"), testing::Not(HasSubstr("select"))));
  const std::string some =
      R"({"point": [1, 2, 3], "normal": [0, 2, 0]}, "tolerance": 0.5, "select": {"vertices": [1]})";
  EXPECT_EQ(std::get<MirrorConstraint>(parsed(some).constraints[0].what).tolerance, 0.5);
  EXPECT_THAT(constraintsToJson(parsed(some)), HasSubstr(some.substr(1, 20)));
  const std::string plane = R"({"point": [1, 2, 3], "normal": [0, 2, 0]})";
  for (const auto& [keys, element] :
       {std::pair(plane + R"(, "tolerance": -1)", "constraints[0].tolerance"),
        std::pair(plane + R"(, "pairs": [[1, 2, 3]])", "constraints[0].pairs[0]"),
        std::pair(plane + R"(, "pairs": [[1, 2]], "select": {"vertices": [1]})", "constraints[0].pairs"),
        std::pair(std::string(R"({"point": [1, 2, 3], "normal": [0, 0, 0]})"), "constraints[0].plane.normal")})
    try {
      parsed(keys);
      FAIL() << keys;
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().element, element);
    }
}

}  // namespace
}  // namespace holdfast
