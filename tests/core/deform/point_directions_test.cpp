// Points that prescribe one or two coordinates, or stay on planes and lines.

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/operators/operators.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"
#include "support/whole_problem.h"

namespace holdfast {
namespace {

using Goal = decltype(PointConstraint::to);
using testing::ElementsAre;
using testing::HasSubstr;

Constraint pointAt(SurfaceLocation at, Goal to)
{
  return {"", true, PointConstraint{std::move(at), std::move(to)}};
}

Coordinates someCoordinates(std::optional<double> x, std::optional<double> y, std::optional<double> z)
{
  Coordinates result;
  result.values = {x, y, z};
  return result;
}

/// Held points, and points with all sorts of directions along or across the axes of `frame`.
ConstraintList mixedList(test::Random& random, const Mesh& mesh, const Eigen::Matrix3d& frame)
{
  const auto shift = [&] { return test::randomVector(random, 0.2); };
  std::vector<Constraint> all{test::hold({0}), test::moveBy(AtVertex{mesh.vertexCount() - 1}, shift())};
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = frame.col(k);
    const Index vertex = 3 + 4 * k;
    const Vector3 rest = mesh.positions.row(vertex);
    all.push_back(pointAt(AtVertex{vertex}, OnPlane{rest + shift(), -2 * axis, 0.1}));
    all.push_back(pointAt(AtVertex{vertex + 1}, OnLine{rest + shift(), 3 * axis}));
    all.push_back(pointAt(AtFace{mesh.faces.size() - 5 * k - 4, {0.2, 0.3, 0.5}}, OnPlane{{}, axis, 0.05}));
  }
  return test::listOf(std::move(all));
}

Eigen::Matrix3d someFrame(test::Random& random)
{
  return Eigen::Quaterniond(random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))
      .normalized()
      .toRotationMatrix();
}

/// All rows are met, by the shape of least energy: LAPACK's over all coordinates at once. Skips without LAPACK.
void expectLeastEnergy(const Mesh& mesh, const ConstraintList& list, const DeformOptions& options)
{
  const DeformResult result = test::deformed(mesh, list, options);
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
  for (const ConstraintOutcome& outcome : result.report.constraints)
    EXPECT_EQ(outcome.status, ConstraintStatus::Met) << outcome.name;

  const Model model = makeModel(mesh, "mesh");
  const EnergyMatrix A = weightedRows(makeOperators(model.solverMesh, options.weights));
  const ConstraintSystem system = makeConstraintSystem(list, mesh, model.solverMesh, model.locator(), "list");
  const std::optional<Columns3> u =
      test::wholeSolution(Eigen::MatrixXd(A.matrix()), Columns3::Zero(mesh.vertexCount(), 3), system);
  if (!u) GTEST_SKIP() << "LAPACK was not found when the tests were configured (package liblapack-dev)";
  EXPECT_LT(test::distance(result.positions, mesh.positions + *u), 1e-10);
}

TEST(PointDirections, AgreeWithLapackOnAllCoordinatesAtOnce)
{
  for (std::uint32_t seed = 1; seed <= 6; ++seed)
    for (const Backend backend : test::backends()) {
      test::Random random(seed);
      const Mesh mesh = seed % 2 == 0 ? test::icosphere(1) : test::plate(6, 5);
      const Eigen::Matrix3d frame = seed <= 2 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : someFrame(random);
      const ConstraintList list = mixedList(random, mesh, frame);
      const DeformOptions options{Weights::Cotangent, {SolverKind::Hard, backend, 5}};
      expectLeastEnergy(mesh, list, options);
    }
}

TEST(PointDirections, OfARotatedModelGiveTheRotatedResult)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    if (mesh.faces[0].size() != 3) return;
    test::Random random(7);
    const Eigen::Matrix3d turn = someFrame(random);
    const Eigen::Affine3d motion = Eigen::Affine3d(turn);
    const auto listIn = [](const Mesh& its, const Eigen::Matrix3d& frame) {
      const auto place = [&](Index v, const Vector3& by) {
        return Vector3(Vector3(its.positions.row(v)) + frame * by);
      };
      const Index last = its.vertexCount() - 1;
      return test::listOf({test::hold({0}), test::hold({last / 2}),
                           pointAt(AtVertex{last}, OnPlane{place(last, {0, 0, 0.1}), frame.col(2), 0}),
                           pointAt(AtVertex{last - 2}, OnLine{place(last - 2, {0.1, 0.2, 0}), frame.col(0)})});
    };
    const DeformResult straight = test::deformed(mesh, listIn(mesh, Eigen::Matrix3d::Identity()), options);
    const Mesh rotatedMesh = test::transformed(mesh, motion);
    const DeformResult askew = test::deformed(rotatedMesh, listIn(rotatedMesh, turn), options);
    ASSERT_EQ(straight.report.solve.status, askew.report.solve.status);
    const Mesh expected = test::transformed({straight.positions, mesh.faces}, motion);
    EXPECT_LT(test::distance(askew.positions, expected.positions), 1e-10);
  });
}

TEST(PointDirections, CopyTheCoordinatesThatTheyHold)
{
  const Mesh mesh = test::plate(8, 8);
  const double third = 1.0 / 3;
  const ConstraintList list = test::listOf({test::hold({0, 1}), pointAt(AtVertex{40}, someCoordinates({}, third, {})),
                                            pointAt(AtVertex{50}, OnPlane{Vector3(0, 0, 0.7), {0, 0, -3}, 0}),
                                            pointAt(AtVertex{60}, someCoordinates(third, {}, -third))});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_EQ(result.positions(40, 1), third);
  EXPECT_EQ(result.positions(50, 2), 0.7);
  EXPECT_EQ(result.positions(60, 0), third);
  EXPECT_EQ(result.positions(60, 2), -third);
  EXPECT_NE(result.positions(40, 0), mesh.positions(40, 0)) << "it is free along x";
}

TEST(PointDirections, AreMetWhereRotationsAreFound)
{
  const Mesh mesh = test::plate(8, 8);
  test::Random random(3);
  const ConstraintList list = mixedList(random, mesh, someFrame(random));
  for (const RotationSource source : {RotationSource::FoundSmooth, RotationSource::Found}) {
    DeformOptions options;
    options.rotations.source = source;
    const DeformResult result = test::deformed(mesh, list, options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-13);
  }
}

TEST(PointDirections, OfADragAreAsIfSolvedAnew)
{
  const Mesh mesh = test::plate(8, 8);
  test::Random random(5);
  ConstraintList list = mixedList(random, mesh, someFrame(random));
  Deformer deformer(makeModel(mesh, "mesh"), {}, DeformerMode::Interactive);
  for (int frame = 0; frame < 5; ++frame) {
    auto& point = std::get<PointConstraint>(list.constraints[1].what);
    std::get<Move>(point.to).shift += Vector3(0.01, 0.02, -0.01);
    auto& plane = std::get<OnPlane>(std::get<PointConstraint>(list.constraints[4].what).to);
    plane.offset += 0.01;
    const DeformResult result = deformer.deformFrame(list);
    EXPECT_LT(test::distance(result.positions, test::deformed(mesh, list, {}).positions), 1e-11);
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
  }
}

TEST(PointDirections, OfEditsAreAsIfSolvedAnew)
{
  const Mesh mesh = test::plate(8, 8);
  test::Random random(6);
  const ConstraintList all = mixedList(random, mesh, Eigen::Matrix3d::Identity());
  ConstraintList list = test::listOf({all.constraints[0], all.constraints[1]});
  Deformer deformer(makeModel(mesh, "mesh"), {}, DeformerMode::Interactive);
  static_cast<void>(deformer.deformFrame(list));
  for (std::size_t c = 2; c < all.constraints.size(); ++c) {
    list.constraints.push_back(all.constraints[c]);
    const DeformResult result = deformer.deformFrame(list);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(test::distance(result.positions, test::deformed(mesh, list, {}).positions), 1e-10);
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-13);
  }
}

/// What conflicts with what, by name.
std::vector<std::string> conflictsOf(const DeformResult& result)
{
  std::vector<std::string> texts;
  for (const ConstraintOutcome& outcome : result.report.constraints)
    for (const ConflictSet& set : outcome.conflictSets) {
      if (!set.isConflict) continue;
      std::string text = outcome.name + " with";
      for (const std::string& name : set.with) text += ' ' + name;
      texts.push_back(text);
    }
  return texts;
}

TEST(PointDirections, ThatContradictAPinAreNamed)
{
  const Mesh mesh = test::plate(6, 6);
  const Vector3 rest = mesh.positions.row(20);
  const Constraint pin = test::moveBy(AtVertex{20}, Vector3::Zero());
  const Constraint plane = pointAt(AtVertex{20}, OnPlane{{}, {1, 2, 2}, 0.3});
  const DeformResult result = test::deformed(mesh, test::listOf({test::hold({0}), pin, plane}), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
  EXPECT_THAT(conflictsOf(result), ElementsAre("P2 with P1"));
  EXPECT_NEAR(*result.report.constraints[2].gap, 0.3, 1e-14);
  const DeformResult exchanged = test::deformed(mesh, test::listOf({test::hold({0}), plane, pin}), {});
  EXPECT_THAT(conflictsOf(exchanged), ElementsAre("P2 with P1"));
  EXPECT_NEAR((Vector3(exchanged.positions.row(20)) - rest).dot(Vector3(1, 2, 2).normalized()), 0.3, 1e-14)
      << "the earlier one holds";
}

TEST(PointDirections, OfThreePlanesAndALineAreNamedInEveryOrder)
{
  const Mesh mesh = test::plate(6, 6);
  const Vector3 rest = mesh.positions.row(20);
  std::array<Goal, 4> goals{OnPlane{rest, Vector3::UnitX(), 0.1}, OnPlane{rest, Vector3::UnitY(), 0},
                            OnPlane{rest, Vector3::UnitZ(), 0}, OnLine{rest, Vector3::UnitZ()}};
  std::array order{0, 1, 2, 3};
  do {
    std::vector<Constraint> list{test::hold({0})};
    for (const int k : order) list.push_back(pointAt(AtVertex{20}, goals[k]));
    const DeformResult result = test::deformed(mesh, test::listOf(std::move(list)), {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
    const auto placeOfGoal = [&](int goal) { return std::ranges::find(order, goal) - order.begin() + 1; };
    const auto [first, second] = std::minmax({placeOfGoal(0), placeOfGoal(3)});
    EXPECT_THAT(conflictsOf(result), ElementsAre(fmt::format("P{} with P{}", second, first)));
  } while (std::ranges::next_permutation(order).found);
}

TEST(PointDirections, ThatRepeatAPinAreRedundant)
{
  const Mesh mesh = test::plate(6, 6);
  const DeformResult result =
      test::deformed(mesh,
                     test::listOf({test::hold({0}), test::moveBy(AtVertex{20}, {0, 0, 1}),
                                   pointAt(AtVertex{20}, OnLine{Vector3(mesh.positions.row(20)), Vector3::UnitZ()})}),
                     {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok);
  EXPECT_EQ(result.report.constraints[2].status, ConstraintStatus::Redundant);
}

TEST(PointDirections, OfLengthZeroAreRefused)
{
  const ConstraintList list = test::listOf({test::hold({0}), pointAt(AtVertex{20}, OnPlane{{}, Vector3::Zero(), 0})});
  EXPECT_THROW(static_cast<void>(test::deformed(test::plate(6, 6), list, {})), InputError);
}

/// Rows of all sorts, none of which fits the directions of another.
ConstraintList listAtOdds(test::Random& random, const Mesh& mesh)
{
  std::vector<Constraint> all{test::hold({0}), test::moveBy(AtVertex{mesh.vertexCount() - 1}, {0.1, -0.1, 0.2})};
  for (int k = 0; k < 4; ++k) {
    const Index vertex = 3 + 4 * k;
    const Vector3 rest = Vector3(mesh.positions.row(vertex)) + test::randomVector(random, 0.2);
    all.push_back(pointAt(AtVertex{vertex}, OnPlane{rest, test::randomVector(random, 1), 0.1}));
    all.push_back(pointAt(AtVertex{vertex + 1}, OnLine{rest, test::randomVector(random, 1)}));
    all.push_back(pointAt(AtFace{mesh.faces.size() - 5 * k - 4, {0.2, 0.3, 0.5}},
                          OnPlane{{}, test::randomVector(random, 1), 0.05}));
  }
  all.push_back(
      {"", true, SlideConstraint{{VertexIds{{20, 21}}}, OnPlane{{}, test::randomVector(random, 1), 0.1}, true}});
  return test::listOf(std::move(all));
}

TEST(DirectionsAtOdds, AgreeWithLapackOnAllCoordinatesAtOnce)
{
  for (std::uint32_t seed = 1; seed <= 6; ++seed)
    for (const Backend backend : test::backends()) {
      test::Random random(seed);
      const Mesh mesh = seed % 2 == 0 ? test::icosphere(1) : test::plate(6, 5);
      const ConstraintList list = listAtOdds(random, mesh);
      const DeformOptions options{Weights::Cotangent, {SolverKind::Hard, backend, 5}};
      const Model model = makeModel(mesh, "mesh");
      EXPECT_GT(makeConstraintSystem(list, mesh, model.solverMesh, model.locator(), "list").tolerant.size(), 10U);
      expectLeastEnergy(mesh, list, options);
    }
}

TEST(DirectionsAtOdds, LeaveTheAxesToMostRows)
{
  const Mesh mesh = test::plate(8, 8);
  const ConstraintList list = test::listOf(
      {test::hold({0, 1}),
       pointAt(AtVertex{40}, OnPlane{{}, {1, 1, 0.2}, 0.1}),
       {"", true, SlideConstraint{{VertexIds{{50, 51, 52, 53}}}, OnPlane{Vector3(0, 0, 0.5), {0, 0, 2}, 0}, false}}});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  ASSERT_EQ(result.details->system.tolerant.size(), 1U);
  for (const Index v : {50, 51, 52, 53}) EXPECT_EQ(result.positions(v, 2), 0.5) << "copied bit for bit";
}

TEST(DirectionsAtOdds, AreOneProblemWhereNoAxisHasManyRows)
{
  test::Random random(4);
  const Mesh mesh = test::plate(8, 8);
  std::vector<Constraint> all{test::hold({0, 1, 2})};
  for (const Index v : {20, 30, 40, 50, 60})
    all.push_back(pointAt(AtVertex{v}, OnPlane{{}, test::randomVector(random, 1), 0.1}));
  EXPECT_EQ(test::deformed(mesh, test::listOf(all), {}).details->system.tolerant.size(), 5U) << "those of no axis";
  // A side that is square to none of the coordinate axes keeps its own.
  all.push_back(
      {"", true,
       SlideConstraint{{VertexIds{{70, 71, 72, 73, 74, 75, 76, 77, 78, 79}}}, OnPlane{{}, {0, 1, 1}, 0}, false}});
  EXPECT_EQ(test::deformed(mesh, test::listOf(all), {}).details->system.tolerant.size(), 5U);
}

TEST(DirectionsAtOdds, OfThreePlanesAndOneMoreAreNamedInEveryOrder)
{
  test::Random random(5);
  const Mesh mesh = test::plate(8, 8);
  const Vector3 meet = Vector3(mesh.positions.row(40)) + Vector3(0.1, 0.2, 0.3);
  std::vector<Constraint> planes;
  for (int k = 0; k < 4; ++k) {
    const Vector3 normal = test::randomVector(random, 1);
    planes.push_back(pointAt(AtVertex{40}, OnPlane{meet + (k == 3 ? 0.05 : 0) * normal.normalized(), normal, 0}));
  }
  std::vector<int> order{0, 1, 2, 3};
  do {
    std::vector<Constraint> all{test::hold({0, 1, 2})};
    for (const int k : order) all.push_back(planes[static_cast<std::size_t>(k)]);
    const ConstraintList list = test::listOf(std::move(all));
    const DeformResult result = test::deformed(mesh, list, {});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
    EXPECT_EQ(result.report.constraints[4].status, ConstraintStatus::Conflicting);
    ASSERT_FALSE(result.report.constraints[4].conflictSets.empty());
    EXPECT_THAT(result.report.constraints[4].conflictSets.front().with,
                testing::UnorderedElementsAre("P1", "P2", "P3"));
    for (std::size_t c = 1; c < 4; ++c) EXPECT_LE(*result.report.constraints[c].residual, 1e-14);
    const Report checked = diagnoseConstraints(makeModel(mesh, "mesh"), list);
    EXPECT_THAT(checked.constraints[4].conflictSets.front().with, testing::UnorderedElementsAre("P1", "P2", "P3"));
  } while (std::ranges::next_permutation(order).found);
}

TEST(DirectionsAtOdds, AreDraggedAndFoundWithRotations)
{
  test::Random random(2);
  const Mesh mesh = test::plate(6, 5);
  ConstraintList list = listAtOdds(random, mesh);
  Deformer live(makeModel(mesh, "mesh"), {}, DeformerMode::Interactive);
  for (int step = 0; step < 4; ++step) {
    std::get<Move>(std::get<PointConstraint>(list.constraints[1].what).to).shift += Vector3(0, 0, 0.1);
    const DeformResult dragged = live.deform(list);
    EXPECT_EQ(dragged.report.solve.status, SolveStatus::Ok) << dragged.report.solve.message;
    EXPECT_LT(test::distance(dragged.positions, test::deformed(mesh, list, {}).positions), 1e-10);
  }
  DeformOptions found;
  found.rotations.source = RotationSource::Found;
  const DeformResult result = test::deformed(mesh, list, found);
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
}

TEST(DirectionsAtOdds, OfTooManyRowsAreRefusedWithTheirNumber)
{
  test::Random random(9);
  const Mesh mesh = test::grid(60, 60);
  std::vector<Constraint> all{test::hold({0, 1, 2})};
  for (Index v = 100; v < 2300; ++v)
    all.push_back(pointAt(AtVertex{v}, OnPlane{{}, test::randomVector(random, 1), 0.1}));
  try {
    static_cast<void>(test::deformed(mesh, test::listOf(std::move(all)), {}));
    ADD_FAILURE() << "it was solved";
  } catch (const InputError& error) {
    EXPECT_THAT(error.reason(), HasSubstr("2199 rows of the list are so, and more than 2000"));
  }
}

TEST(PointDirections, OfFilesAreReadAndWrittenAsVersionTwo)
{
  const std::string text = R"({"format": "holdfast-constraints", "version": 2, "constraints": [
    {"type": "point", "at": {"vertex": 1}, "target": [1.5, null, -0.25]},
    {"type": "point", "at": {"vertex": 2}, "on": {"plane": {"point": [1, 2, 3], "normal": [0, 0, 2], "offset": 0.5}}},
    {"type": "point", "at": {"vertex": 3}, "on": {"line": {"direction": [1, 0, 0]}}}]})";
  const ConstraintList list = parseConstraintsJson(text, "c.json");
  const auto goal = [&](std::size_t c) { return std::get<PointConstraint>(list.constraints[c].what).to; };
  const Vector3 rest(7, 8, 9);
  EXPECT_EQ(std::get<Coordinates>(goal(0)).placeFrom(rest), Vector3(1.5, 8, -0.25));
  EXPECT_EQ(std::get<OnPlane>(goal(1)).placeFrom(rest), Vector3(7, 8, 3.5));
  EXPECT_EQ(std::get<OnLine>(goal(2)).placeFrom(rest), rest);
  const std::string written = constraintsToJson(list);
  EXPECT_THAT(written, HasSubstr("\"version\": 2,"));
  EXPECT_THAT(written, HasSubstr("\"target\": [1.5, null, -0.25]"));
  EXPECT_EQ(constraintsToJson(parseConstraintsJson(written, "c.json")), written);
  EXPECT_THAT(constraintsToJson(test::listOf({test::hold({0})})), HasSubstr("\"version\": 1,"));
}

TEST(PointDirections, OfFilesThatMakeNoSenseAreRefused)
{
  const auto expectRefused = [](const std::string& goal, const std::string& key, const std::string& words) {
    SCOPED_TRACE(goal);
    try {
      static_cast<void>(parseConstraintsJson(R"({"format": "holdfast-constraints", "version": 2, "constraints": [
          {"type": "point", "at": {"vertex": 1}, )" +
                                                 goal + "}]}",
                                             "c.json"));
      ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().element, "constraints[0]" + key);
      EXPECT_THAT(error.reason(), HasSubstr(words));
    }
  };
  expectRefused(R"("target": [null, null, null])", ".target", "no coordinate is given");
  expectRefused(R"("target": [1, null])", ".target", "[x, y, z]");
  expectRefused(R"("on": {"plane": {"point": [0, 0, 0]}})", ".on.plane", "\"normal\" is missing");
  expectRefused(R"("on": {"plane": {"normal": [0, 0, 0]}})", ".on.plane.normal", "cannot be zero");
  expectRefused(R"("on": {"line": {"direction": [0, 0, 1], "offset": 1}})", ".on.line.offset", "offset");
  expectRefused(R"("on": {})", ".on", "plane");
  expectRefused(R"("on": {"plane": {"normal": [0, 0, 1]}, "line": {"direction": [0, 0, 1]}})", ".on", "line");
  expectRefused(R"("on": {"plane": {"normal": [0, 0, 1]}}, "move": [0, 0, 1])", "", "move");
}

}  // namespace
}  // namespace holdfast
