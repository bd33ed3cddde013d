// Points that come near enough to their targets, or as near as that is worth.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

// Of coordinates up to 16.
constexpr double kRoundingOfPlaces = 4e-15;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Constraint near(SurfaceLocation at, const Vector3& target, PointTolerance within)
{
  return {"", true, PointConstraint{std::move(at), Target{target}, std::move(within)}};
}

DeformOptions given(Weights weights = Weights::Cotangent, Backend backend = Backend::Holdfast)
{
  return {weights, {SolverKind::Hard, backend, 5}};
}

/// The plate is held along one side and measured all over, with noise.
struct Measured {
  Mesh mesh = test::plate(14, 10);
  std::vector<Constraint> list{test::hold({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14})};

  Measured(PointTolerance within, int count, double noise)
  {
    test::Random random(11);
    for (int k = 0; k < count; ++k) {
      const Index face = 40 + k * ((mesh.faces.size() - 41) / count);
      const Vector3 at = mesh.positions(mesh.faces[face], Eigen::all).colwise().mean();
      const Vector3 wanted = at + Vector3(0.1 * at.y(), 0, 0.02 * at.y() * at.y()) + test::randomVector(random, noise);
      list.push_back(near(AtFace{face, {1.0 / 3, 1.0 / 3, 1 - 2 * (1.0 / 3)}}, wanted, within));
    }
  }

  [[nodiscard]] DeformResult result(const DeformOptions& options = given()) const
  {
    return test::deformed(mesh, test::listOf(list), options);
  }
};

/// Half of the energy in diagonals: what the forces have done on the way from rest, as the energy is a square of u.
double energyOf(const Mesh& mesh, const DeformResult& result)
{
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  const Columns3 u = result.positions - mesh.positions;
  return result.multipliers().cwiseProduct(u).sum() / boundingBoxDiagonal(mesh.positions) / 2;
}

Vector3 offsetOf(const DeformResult& result, std::size_t tolerant)
{
  const TolerantRow& row = result.details->system.tolerant[tolerant];
  return result.details->system.rows[row.row].target - row.target;
}

Vector3 forceOf(const DeformResult& result, std::size_t tolerant)
{
  return result.details->multipliers.get().ofRows.row(result.details->system.tolerant[tolerant].row);
}

TEST(PointTolerances, OfBallsAreMetWithTheLeastEnergy)
{
  const double radius = 0.05;
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends()) {
      const Measured measured(WithinBall{radius}, 60, 0.04);
      const DeformResult result = measured.result(given(weights, backend));
      ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
      EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
      double largest = 0;
      for (std::size_t k = 0; k < 60; ++k) largest = std::max(largest, forceOf(result, k).norm());
      int atBound = 0;
      for (std::size_t k = 0; k < 60; ++k) {
        const Vector3 offset = offsetOf(result, k);
        const Vector3 force = forceOf(result, k);
        const ConstraintOutcome& outcome = result.report.constraints[k + 1];
        EXPECT_LE(offset.norm(), radius + kRoundingOfPlaces);
        EXPECT_NEAR(*outcome.offTarget, offset.norm(), 1e-15);
        if (*outcome.isAtBound) {
          ++atBound;
          EXPECT_NEAR(offset.norm(), radius, kRoundingOfPlaces);
          // The surface would go farther out, and the point pulls it back towards its target.
          EXPECT_LT((force / force.norm() + offset / offset.norm()).norm(), 1e-5) << k;
        } else {
          EXPECT_LT(force.norm(), 1e-9 * largest) << k;
        }
      }
      EXPECT_GT(atBound, 3);
      EXPECT_LT(atBound, 57);
    }
}

TEST(PointTolerances, CostLessThanExactPointsAndLessTheWiderTheyAre)
{
  double before = energyOf(Measured(Exactly{}, 40, 0.04).mesh, Measured(Exactly{}, 40, 0.04).result());
  for (const double radius : {0.001, 0.01, 0.03, 0.1, 1.0}) {
    const Measured measured(WithinBall{radius}, 40, 0.04);
    const double energy = energyOf(measured.mesh, measured.result());
    EXPECT_LT(energy, before) << radius;
    before = energy;
  }
}

TEST(PointTolerances, SmallerThanTheSpacingOfDoublesEnd)
{
  const Vector3 far(1e6, -2e6, 3e6);
  const Mesh mesh = test::moved(test::plate(6, 5), far);
  const Vector3 rest = mesh.positions.row(30);
  const DeformResult result = test::deformed(
      mesh, test::listOf({test::hold({0, 1, 2}), near(AtVertex{30}, rest + Vector3(0.1, 0.2, 0.3), WithinBall{1e-11})}),
      {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT(offsetOf(result, 0).norm(), 1e-9);
}

TEST(PointTolerances, ThatReachToRestLeaveTheSurfaceThere)
{
  Mesh mesh = test::plate(8, 6);
  const Vector3 rest = mesh.positions.row(40);
  const DeformResult result = test::deformed(
      mesh, test::listOf({test::hold({0, 1, 2}), near(AtVertex{40}, rest + Vector3(0.1, 0.1, 0), WithinBall{0.2})}),
      {});
  EXPECT_LT((result.positions - mesh.positions).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_FALSE(*result.report.constraints[1].isAtBound);
}

TEST(PointTolerances, OfBoxesAndSlabsHaveForcesAcrossTheirBounds)
{
  const Measured boxes(WithinBox{{0.02, 0.05, 0.03}}, 40, 0.05);
  const DeformResult inBoxes = boxes.result();
  ASSERT_EQ(inBoxes.report.solve.status, SolveStatus::Ok) << inBoxes.report.solve.message;
  const Vector3 half(0.02, 0.05, 0.03);
  double largest = 0;
  for (std::size_t k = 0; k < 40; ++k) largest = std::max(largest, forceOf(inBoxes, k).norm());
  int atBound = 0;
  for (std::size_t k = 0; k < 40; ++k)
    for (Index axis = 0; axis < 3; ++axis) {
      const double offset = offsetOf(inBoxes, k)[axis];
      const double force = forceOf(inBoxes, k)[axis];
      EXPECT_LE(std::abs(offset), half[axis] + kRoundingOfPlaces);
      if (std::abs(force) < 1e-8 * largest) continue;
      ++atBound;
      EXPECT_NEAR(std::abs(offset), half[axis], 1e-9);
      EXPECT_LT(offset * force, 0);
    }
  EXPECT_GT(atBound, 10);

  const Vector3 normal(1, 2, -2);
  const Measured slabs(WithinSlab{-0.02, 0.01, normal}, 40, 0.05);
  const DeformResult inSlabs = slabs.result();
  ASSERT_EQ(inSlabs.report.solve.status, SolveStatus::Ok) << inSlabs.report.solve.message;
  for (std::size_t k = 0; k < 40; ++k) {
    const double along = normal.normalized().dot(offsetOf(inSlabs, k));
    EXPECT_GE(along, -0.02 - kRoundingOfPlaces);
    EXPECT_LE(along, 0.01 + kRoundingOfPlaces);
    const Vector3 force = forceOf(inSlabs, k);
    EXPECT_LT(force.cross(normal.normalized()).norm(), 1e-8 * largest) << "it is free in the slab";
  }
}

TEST(PointTolerances, OfOneSideOnlyPushOneWay)
{
  Mesh mesh = test::grid(10, 6);
  const Index corner = mesh.vertexCount() - 1;
  const auto height = [&](double low, double high, double normal = 1) {
    const WithinSlab slab{low, high, Vector3(0, 0, normal)};
    const DeformResult result = test::deformed(
        mesh,
        test::listOf({test::hold({0, 11, 22, 33, 44, 55, 66}), test::moveBy(AtVertex{corner - 3}, {0, 0, 1}),
                      near(AtVertex{corner}, mesh.positions.row(corner), slab)}),
        {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    return result.positions(corner, 2);
  };
  const double free = height(-10, kInfinite);
  EXPECT_NEAR(height(-kInfinite, free + 0.1, 3), free, 1e-9);
  EXPECT_NEAR(height(free + 0.5, kInfinite), free + 0.5, kRoundingOfPlaces);
  EXPECT_NEAR(height(-kInfinite, 0.25), 0.25, kRoundingOfPlaces);
  EXPECT_NEAR(height(-kInfinite, 0), 0, kRoundingOfPlaces) << "the target lies at the bound";
  EXPECT_NEAR(height(0.125, 0.25), 0.25, kRoundingOfPlaces);
}

/// All points soft: the soft solver is an oracle.
TEST(PointTolerances, OfWeightsAreThoseOfSoftConstraints)
{
  for (const Weights weights : test::allWeights())
    for (const double weight : {0.5, 5.0, 80.0}) {
      Measured measured(Weighted{weight}, 30, 0.05);
      measured.list.erase(measured.list.begin());
      const DeformResult result = measured.result(given(weights));
      ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
      for (Constraint& constraint : measured.list) std::get<PointConstraint>(constraint.what).within = Exactly{};
      const DeformResult soft = measured.result({weights, {SolverKind::Soft, Backend::Holdfast, weight}});
      EXPECT_LT(test::distance(result.positions, soft.positions), 1e-8) << name(weights) << ", " << weight;
      EXPECT_GT(*result.report.constraints[0].offTarget, 1e-6);
    }
}

TEST(PointTolerances, HoldBesideExactConstraintsOfAllKinds)
{
  Measured measured(WithinBall{0.02}, 20, 0.03);
  measured.list.push_back(test::rigid({70, 71, 85, 86}));
  measured.list.push_back(
      {"", true, SlideConstraint{{VertexIds{{150, 151, 152, 153}}}, OnPlane{{}, {0, 0, 1}, 0.1}, false}});
  measured.list.push_back({"", true, CoincidentConstraint{AtVertex{30}, AtVertex{31}}});
  measured.list.push_back(near(AtVertex{100}, measured.mesh.positions.row(100), Weighted{20}));
  const DeformResult result = measured.result();
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-13);
  for (std::size_t k = 0; k < 20; ++k) EXPECT_LE(offsetOf(result, k).norm(), 0.02 + kRoundingOfPlaces);
}

TEST(PointTolerances, OfRotatedCopiesAreRotated)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.translate(Vector3(3, -2, 1)).rotate(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  Measured plain(WithinBall{0.03}, 25, 0.04);
  plain.list.push_back(near(AtVertex{160}, plain.mesh.positions.row(160), WithinSlab{0.1, 0.3, Vector3::UnitZ()}));
  Measured askew = plain;
  askew.mesh = test::transformed(plain.mesh, motion);
  for (Constraint& constraint : askew.list)
    if (auto* point = std::get_if<PointConstraint>(&constraint.what)) {
      auto& target = std::get<Target>(point->to);
      target.place = motion * target.place;
      if (auto* slab = std::get_if<WithinSlab>(&point->within)) slab->normal = motion.linear() * *slab->normal;
    }
  const DeformResult a = plain.result();
  const DeformResult b = askew.result();
  double largest = 0;
  for (Index v = 0; v < a.positions.rows(); ++v)
    largest = std::max(largest, (motion * Vector3(a.positions.row(v)) - Vector3(b.positions.row(v))).norm());
  EXPECT_LT(largest, 1e-8);
}

/// Holds one side. The corners of face 50 come near places above it.
std::vector<Constraint> withCornersLifted(const Mesh& mesh)
{
  std::vector<Constraint> list{test::hold({0, 1, 2, 3})};
  for (const Index v : mesh.faces[50])
    list.push_back(near(AtVertex{v}, Vector3(mesh.positions.row(v)) + Vector3(0, 0, 1), WithinBall{0.2}));
  return list;
}

TEST(PointTolerances, OfPointsThatFollowFromOthersHold)
{
  // Three corners of a face and a point in it: the fourth follows from the three.
  const Mesh mesh = test::plate(8, 6);
  const Vector3 middle = mesh.positions(mesh.faces[50], Eigen::all).colwise().mean();
  std::vector<Constraint> list = withCornersLifted(mesh);
  list.push_back(
      near(AtFace{50, {1.0 / 3, 1.0 / 3, 1 - 2 * (1.0 / 3)}}, middle + Vector3(0, 0, 1.25), WithinBall{0.1}));
  const DeformResult result = test::deformed(mesh, test::listOf(list), {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LE(offsetOf(result, k).norm(), (k < 3 ? 0.2 : 0.1) + 1e-13);
  // Out of reach of the three.
  std::get<Target>(std::get<PointConstraint>(list.back().what).to).place += Vector3(0, 0, 1);
  const DeformResult far = test::deformed(mesh, test::listOf(list), {});
  EXPECT_EQ(far.report.solve.status, SolveStatus::Conflicts);
  const ConstraintOutcome& outcome = far.report.constraints.back();
  EXPECT_EQ(outcome.status, ConstraintStatus::Conflicting);
  EXPECT_THAT(outcome.conflictSets.front().with, testing::UnorderedElementsAre("P1", "P2", "P3"));
}

TEST(PointTolerances, OutOfReachOfAFixedVertexNameIt)
{
  const Mesh mesh = test::plate(8, 6);
  const Vector3 rest = mesh.positions.row(2);
  for (const double reach : {0.5, 0.2}) {
    const DeformResult result =
        test::deformed(mesh,
                       test::listOf({test::hold({0, 1}), test::hold({2}), test::moveBy(AtVertex{40}, {0, 0, 0.1}),
                                     near(AtVertex{2}, rest + Vector3(0, 0, 0.4), WithinBall{reach})}),
                       {});
    const bool reaches = reach > 0.4;
    EXPECT_EQ(result.report.solve.status, reaches ? SolveStatus::Ok : SolveStatus::Conflicts);
    if (reaches) continue;
    EXPECT_EQ(result.report.constraints[3].status, ConstraintStatus::Conflicting);
    EXPECT_THAT(result.report.constraints[3].conflictSets.front().with, testing::ElementsAre("P1"));
    EXPECT_NEAR(result.report.constraints[3].conflictSets.front().gap.norm(), 0.2, 1e-12);
    const Report checked = diagnoseConstraints(
        makeModel(mesh, "mesh"),
        test::listOf({test::hold({2}), near(AtVertex{2}, rest + Vector3(0, 0, 0.4), WithinBall{0.5})}));
    EXPECT_NE(checked.constraints[1].status, ConstraintStatus::Conflicting);
  }
}

TEST(PointTolerances, AreExactWhereAnExactPointComesLater)
{
  const Mesh mesh = test::plate(8, 6);
  const Vector3 middle = mesh.positions(mesh.faces[50], Eigen::all).colwise().mean();
  std::vector<Constraint> list = withCornersLifted(mesh);
  list.push_back(test::moveTo(AtFace{50, {1.0 / 3, 1.0 / 3, 1 - 2 * (1.0 / 3)}}, middle + Vector3(0.05, 0, 1.1)));
  const DeformResult result = test::deformed(mesh, test::listOf(list), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(offsetOf(result, k).norm(), 0.2 + 1e-13);
}

TEST(PointTolerances, AreDraggedByOneFactor)
{
  const Measured measured(WithinBall{0.05}, 20, 0.04);
  Deformer live(makeModel(measured.mesh, "mesh"), given(), DeformerMode::Interactive);
  ConstraintList list = test::listOf(measured.list);
  for (int step = 0; step < 5; ++step) {
    std::get<Target>(std::get<PointConstraint>(list.constraints[3].what).to).place += Vector3(0, 0, 0.05);
    const DeformResult dragged = live.deform(list);
    const DeformResult anew = test::deformed(measured.mesh, list, given());
    EXPECT_EQ(dragged.report.solve.status, SolveStatus::Ok) << dragged.report.solve.message;
    EXPECT_LT(test::distance(dragged.positions, anew.positions), 1e-9);
  }
}

TEST(PointTolerances, HoldWithRotationsThatAreFound)
{
  Measured measured(WithinBall{0.05}, 20, 0.04);
  DeformOptions options = given();
  options.rotations.source = RotationSource::Found;
  const DeformResult result = measured.result(options);
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (std::size_t k = 0; k < 20; ++k) EXPECT_LE(offsetOf(result, k).norm(), 0.05 + kRoundingOfPlaces);
}

TEST(PointTolerances, ThatMakeNoSenseAreRefused)
{
  const auto refusal = [](const Constraint& constraint) -> std::string {
    try {
      static_cast<void>(test::deformed(test::plate(4, 4), test::listOf({test::hold({0, 1}), constraint}), {}));
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, WithinBall{0})), HasSubstr(".within.ball"));
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, WithinBox{{1, -1, 1}})), HasSubstr(".within.box"));
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, WithinSlab{1, 1, Vector3::UnitZ()})), HasSubstr("1 is not below 1"));
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, WithinSlab{-1, 1, Vector3(0, 0, 0)})), HasSubstr(".within.normal"));
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, Weighted{-5})), HasSubstr(".weight"));
  EXPECT_THAT(refusal(near(AtVertex{9}, {0, 0, 0}, WithinSlab{-1, 1, {}})), HasSubstr("needs a \"normal\""));
  EXPECT_THAT(refusal({"", true, PointConstraint{AtVertex{9}, OnLine{}, WithinBox{{1, 1, 1}}}}),
              HasSubstr("goes to one place"));
  EXPECT_THAT(refusal({"", true, PointConstraint{AtVertex{9}, OnLine{}, WithinSlab{0, 1, {}}}}),
              HasSubstr("lies in no slab"));
  EXPECT_THAT(refusal({"", true, PointConstraint{AtVertex{9}, OnPlane{}, WithinSlab{0, 1, Vector3(0, 0, 1)}}}),
              HasSubstr("leave its normal out"));
}

TEST(TolerancesInFiles, HaveTheirKeys)
{
  const auto parsed = [](const std::string& keys) {
    return parseConstraintsJson(
        R"({"format": "holdfast-constraints", "version": 2, "constraints": [{"type": "point", "at": {"vertex": 3}, )" +
            keys + "}]}",
        "f.json");
  };
  const std::string target = R"("target": [1, 2, 3], )";
  for (const std::string tolerance :
       {R"("within": {"ball": 0.5})", R"("within": {"box": [1, 2, 3]})",
        R"("within": {"slab": [-0.5, null], "normal": [0, 0, 2]})", R"("weight": 12.5)"}) {
    const std::string written = constraintsToJson(parsed(target + tolerance));
    EXPECT_EQ(constraintsToJson(parseConstraintsJson(written, "again.json")), written);
    EXPECT_THAT(written, HasSubstr(tolerance));
    EXPECT_THAT(written, HasSubstr("\"version\": 2"));
  }
  for (const auto& [keys, element] :
       {std::pair(target + R"("within": {"ball": 0})", "constraints[0].within.ball"),
        std::pair(target + R"("within": {"ball": 1, "box": [1, 1, 1]})", "constraints[0].within"),
        std::pair(target + R"("within": {"slab": [1, 0], "normal": [0, 0, 1]})", "constraints[0].within.slab"),
        std::pair(target + R"("within": {"slab": [0, 1]})", "constraints[0].within"),
        std::pair(target + R"("within": {"ball": 1}, "weight": 1)", "constraints[0].weight"),
        std::pair(std::string(R"("target": [1, null, 3], "within": {"box": [1, 1, 1]})"), "constraints[0].within.box")})
    try {
      parsed(keys);
      FAIL() << keys;
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().element, element) << error.what();
    }
}

}  // namespace
}  // namespace holdfast
