// Edits that are answered by the factor of an earlier list, bordered by the rows that differ.

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/threads/long_step.h>

#include "support/latch.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

constexpr char kBordered[] = "an earlier factor, bordered by the rows that differ";

ConstraintList turnedEnd(const Mesh& mesh)
{
  const Index last = mesh.vertexCount() - 1;
  ConstraintList list = test::listOf({test::hold({0, 1, 2, 3})});
  list.constraints.push_back(
      {"handle", true,
       HandleConstraint{
           {VertexIds{{last, last - 1, last - 2}}}, AxisRotation{Vector3(1, 1, 0), 40, {}}, Vector3(0, 0, 1), {}}});
  return list;
}

/// Adds, moves, removes, disables or enables a point.
void edit(ConstraintList& list, test::Random& random, const Mesh& mesh)
{
  const auto size = static_cast<Index>(list.constraints.size());
  const Index choice = random.integer(0, size < 6 ? 1 : 4);
  Constraint& other = list.constraints[size > 2 ? random.integer(2, size - 1) : 0];
  if (choice <= 1)
    list.constraints.push_back(test::moveBy(test::randomPlace(random, mesh), test::randomVector(random, 0.2)));
  else if (choice == 2)
    list.constraints.erase(list.constraints.begin() + random.integer(2, size - 1));
  else if (choice == 3)
    std::get<PointConstraint>(other.what).at = test::randomPlace(random, mesh);
  else
    other.isEnabled = !other.isEnabled;
}

void expectAsFresh(const DeformResult& edited, const Mesh& mesh, const ConstraintList& list,
                   const DeformOptions& options)
{
  const DeformResult fresh = test::deformed(mesh, list, options);
  EXPECT_EQ(edited.report.solve.status, fresh.report.solve.status) << edited.report.solve.message;
  EXPECT_LT(test::distance(edited.positions, fresh.positions), 1e-11);
  EXPECT_LE(edited.report.solve.maxResidualRelative, std::max(1e-14, fresh.report.solve.maxResidualRelative));
  EXPECT_LT(edited.report.solve.accuracy, 1e-9);
  for (std::size_t c = 0; c < list.constraints.size(); ++c)
    EXPECT_EQ(edited.report.constraints[c].status, fresh.report.constraints[c].status) << c;
}

/// Waits for what other threads are about to do.
class Patience {
 public:
  [[nodiscard]] bool isLeft() const { return std::chrono::steady_clock::now() - start_ < std::chrono::minutes(1); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

TEST(DeformerEdits, AreAsExactAsFreshDeformations)
{
  const Mesh mesh = test::plate(16, 12);
  for (const Backend backend : test::backends())
    for (const Weights weights : test::allWeights()) {
      const DeformOptions options{weights, {SolverKind::Hard, backend, 5}};
      test::Random random(21);
      Deformer deformer(makeModel(mesh), options, DeformerMode::Interactive);
      ConstraintList list = turnedEnd(mesh);
      static_cast<void>(deformer.deform(list));
      int bordered = 0;
      for (int k = 0; k < 30; ++k) {
        edit(list, random, mesh);
        const DeformResult result = deformer.deform(list);
        bordered += result.report.solve.method == kBordered ? 1 : 0;
        expectAsFresh(result, mesh, list, options);
      }
      if (backend == Backend::Holdfast)
        EXPECT_GT(bordered, 15);
      else
        EXPECT_EQ(bordered, 0);
    }
}

/// An edit of a drag.
struct DragEdit {
  const char* what;
  void (*change)(ConstraintList& list, const Positions& before);
  bool beginsBefore;  // at the solution before it, which one more corrects
};

void addPoint(ConstraintList& list, const Positions& /*before*/)
{
  list.constraints.push_back(test::moveBy(AtFace{301, {0.25, 0.25, 0.5}}, Vector3(0.1, 0, 0.2)));
}

void movePoints(ConstraintList& list, const Positions& before)
{
  addPoint(list, before);
  list.constraints.erase(list.constraints.begin() + 2);
}

void moveHandleAsWell(ConstraintList& list, const Positions& before)
{
  movePoints(list, before);
  std::get<HandleConstraint>(list.constraints[1].what).translate.x() += 0.5;
}

constexpr std::array kDragEdits{
    DragEdit{"a point more", addPoint, true},
    DragEdit{
        "a point fewer",
        [](ConstraintList& list, const Positions& /*before*/) { list.constraints.erase(list.constraints.begin() + 2); },
        true},
    DragEdit{"a point that moves nothing",
             [](ConstraintList& list, const Positions& before) {
               list.constraints.push_back({"there", true, PointConstraint{AtVertex{155}, Target{before.row(155)}}});
             },
             true},
    DragEdit{"one more and one fewer", movePoints, true},
    DragEdit{"the handle moves as well", moveHandleAsWell, false}};

TEST(DeformerEdits, OfADragBeginAtTheSolutionBeforeThem)
{
  // A long strip takes many digits; of 420 points some rows are kept in the system, with multipliers.
  for (const auto& [mesh, points] : {std::pair(test::plate(250, 4), 3), std::pair(test::icosphere(3), 420)})
    for (const auto& [what, change, beginsBefore] : kDragEdits) {
      SCOPED_TRACE(testing::Message() << points << " points, " << what);
      test::Random random(7);
      ConstraintList list = turnedEnd(mesh);
      for (int k = 0; k < points; ++k)
        list.constraints.push_back(
            test::moveBy(AtFace{static_cast<Index>(random.integer(0, static_cast<int>(mesh.faces.size()) - 1)),
                                {0.25, 0.125, 0.625}},
                         Vector3::Zero()));
      const auto handle = [&]() -> HandleConstraint& { return std::get<HandleConstraint>(list.constraints[1].what); };
      Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
      static_cast<void>(deformer.deform(list));
      handle().translate.z() += 0.5;  // the last solution is a sum
      const DeformResult before = deformer.deform(list);
      change(list, before.positions);
      const DeformResult edited = deformer.deform(list);
      EXPECT_EQ(edited.report.solve.method, kBordered);
      EXPECT_EQ(edited.report.solve.refinementSteps == 0, beginsBefore);
      expectAsFresh(edited, mesh, list, {});
      for (int k = 0; k < 3; ++k) {
        handle().motion = AxisRotation{Vector3(1, 1, 0), 41.0 + k, {}};
        expectAsFresh(deformer.deform(list), mesh, list, {});
      }
    }
}

/// A point that an edit takes from one place to another near it: the new row names vertices that the old one frees.
struct ShiftedPoint {
  const char* what;
  SurfaceLocation from;
  SurfaceLocation to;
};

TEST(DeformerEdits, OfPointsThatAreTakenToPlacesNearByKeepTheFactor)
{
  const Mesh mesh = test::plate(16, 12);
  const std::span<const int> corners = mesh.faces[201];
  const std::vector<ShiftedPoint> shifted{
      {"inside its face", AtFace{201, {0.25, 0.25, 0.5}}, AtFace{201, {0.5, 0.25, 0.25}}},
      {"a little", AtFace{201, {0.25, 0.25, 0.5}}, AtFace{201, {0.2501, 0.2499, 0.5}}},
      {"to a corner", AtFace{201, {0.25, 0.25, 0.5}}, AtVertex{corners[1]}},
      {"from a corner", AtVertex{corners[2]}, AtFace{201, {0.125, 0.25, 0.625}}},
      {"to an edge", AtFace{201, {0.25, 0.25, 0.5}}, AtEdge{corners[0], corners[1], 0.25}}};
  for (const auto& [what, from, to] : shifted) {
    SCOPED_TRACE(what);
    ConstraintList list = turnedEnd(mesh);
    list.constraints.push_back(test::moveBy(from, Vector3(0.1, 0, 0.2)));
    list.constraints.push_back(test::moveBy(AtFace{100, {0.25, 0.25, 0.5}}, Vector3(0, 0, 0.1)));
    Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
    static_cast<void>(deformer.deform(list));
    std::get<PointConstraint>(list.constraints[2].what).at = to;
    const DeformResult edited = deformer.deform(list);
    EXPECT_EQ(edited.report.solve.method, kBordered);
    expectAsFresh(edited, mesh, list, {});
  }
}

TEST(DeformerEdits, MayTakeEveryRowOfAnEarlierPointAway)
{
  const Mesh mesh = test::plate(12, 10);
  Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
  ConstraintList list = turnedEnd(mesh);
  for (const Index face : {100, 130, 131, 132})
    list.constraints.push_back(test::moveBy(AtFace{face, {0.2, 0.3, 0.5}}, Vector3(0, 0, 0.2)));
  list.constraints.push_back(test::moveBy(AtVertex{60}, Vector3(0, 0, 0.1)));
  static_cast<void>(deformer.deform(list));
  while (list.constraints.size() > 2) {
    list.constraints.pop_back();
    const DeformResult result = deformer.deform(list);
    expectAsFresh(result, mesh, list, {});
  }
}

/// A plate to which one point was added.
struct EditedPlate {
  EditedPlate() : deformer(makeModel(mesh), {}, DeformerMode::Interactive)
  {
    static_cast<void>(deformer.deform(list));
    list.constraints.push_back(test::moveBy(AtVertex{60}, Vector3(0, 0, 0.1)));
    EXPECT_EQ(deformer.deform(list).report.solve.method, kBordered);
  }

  void expectAFactorOfItsOwnSoon()
  {
    const Patience patience;
    DeformResult result = deformer.deform(list);
    while (result.report.solve.method == kBordered && patience.isLeft()) result = deformer.deform(list);
    EXPECT_NE(result.report.solve.method, kBordered);
    EXPECT_EQ(result.positions, test::deformed(mesh, list, {}).positions) << "bit for bit";
  }

  Mesh mesh = test::plate(12, 10);
  ConstraintList list = turnedEnd(mesh);
  Deformer deformer;
};

TEST(DeformerEdits, GetAFactorOfTheirOwnMeanwhile)
{
  EditedPlate().expectAFactorOfItsOwnSoon();
}

TEST(DeformerEdits, GetAFactorOfTheirOwnAfterAnotherOneWasCancelled)
{
  class Impatient final : public Progress {
    void step(std::string_view /*description*/) override {}
    void proceed(double /*share*/) override { throw Cancelled(); }
  };
  EditedPlate plate;
  const auto mayEnd = std::make_shared<test::Latch>();
  for (int k = 0; k < 2; ++k) {
    LongStep<bool> leftBehind([mayEnd] { return mayEnd->wait(); });
    leftBehind.start(noProgress());
  }
  ConstraintList other = plate.list;
  other.constraints.push_back(test::moveBy(AtVertex{70}, Vector3(0, 0, 0.1)));
  Impatient impatient;
  EXPECT_THROW(static_cast<void>(plate.deformer.deform(other, "list", impatient)), Cancelled);
  mayEnd->open();
  plate.expectAFactorOfItsOwnSoon();
}

TEST(DeformerEdits, GoBackToTheFactorThatTheyBeganWith)
{
  const Mesh mesh = test::plate(12, 10);
  Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
  ConstraintList list = turnedEnd(mesh);
  const DeformResult before = deformer.deform(list);
  list.constraints.push_back(test::moveBy(AtVertex{60}, Vector3(0, 0, 0.1)));
  EXPECT_EQ(deformer.deform(list).report.solve.method, kBordered);
  list.constraints.pop_back();
  const DeformResult after = deformer.deform(list);
  EXPECT_EQ(after.report.solve.method, before.report.solve.method);
  EXPECT_EQ(after.positions, before.positions) << "bit for bit";
}

TEST(DeformerEdits, FactoriseAnewWhereTooMuchDiffers)
{
  const Mesh mesh = test::plate(30, 20);
  Deformer deformer(makeModel(mesh), {}, DeformerMode::Interactive);
  ConstraintList list = turnedEnd(mesh);
  static_cast<void>(deformer.deform(list));
  const auto deformed = [&] { return deformer.deform(list); };
  for (Index vertex = 100; vertex < 500; ++vertex)
    list.constraints.push_back(test::moveBy(AtVertex{vertex}, Vector3(0, 0, 0.1)));
  EXPECT_NE(deformed().report.solve.method, kBordered) << "400 rows more";
  list.constraints[1].isEnabled = false;
  EXPECT_NE(deformed().report.solve.method, kBordered) << "other rotations are given";
  Deformer repeatable(makeModel(mesh));
  static_cast<void>(repeatable.deform(list));
  list.constraints.pop_back();
  EXPECT_NE(repeatable.deform(list).report.solve.method, kBordered) << "not asked for";
}

TEST(DeformerEdits, OfOtherSolversAreFactorisedAnew)
{
  const Mesh mesh = test::plate(8, 6);
  for (const SolverKind kind : {SolverKind::Soft, SolverKind::Lagrange}) {
    const DeformOptions options{Weights::Cotangent, {kind, Backend::Holdfast, 5}};
    Deformer deformer(makeModel(mesh), options, DeformerMode::Interactive);
    ConstraintList list = turnedEnd(mesh);
    static_cast<void>(deformer.deform(list));
    list.constraints.push_back(test::moveBy(AtVertex{30}, Vector3(0, 0, 0.1)));
    EXPECT_EQ(deformer.deform(list).positions, test::deformed(mesh, list, options).positions);
  }
}

}  // namespace
}  // namespace holdfast
