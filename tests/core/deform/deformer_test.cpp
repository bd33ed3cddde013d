#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// Remembers the stages, and cancels at the one that begins with `cancelAt`.
class Recorder final : public Progress {
 public:
  void step(std::string_view description) override
  {
    if (!cancelAt.empty() && description.starts_with(cancelAt)) throw Cancelled();
    stages.emplace_back(description);
  }

  std::vector<std::string> stages;
  std::string cancelAt;
};

bool hasStep(const Recorder& recorder, std::string_view start)
{
  return std::any_of(recorder.stages.begin(), recorder.stages.end(),
                     [&](const std::string& step) { return step.starts_with(start); });
}

ConstraintList dragged(double degrees, const Vector3& shift)
{
  HandleConstraint handle;
  handle.select = {VertexIds{{30, 31, 32}}};
  handle.motion = AxisRotation{Vector3(1, 1, 0), degrees, Vector3(0, 0, 0)};
  handle.translate = shift;
  ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveBy(AtFace{9, {0.2, 0.3, 0.5}}, shift / 2)});
  list.constraints.push_back({"handle", true, handle});
  return list;
}

/// Where the surface has been moved away since, a second tree of closest points would find another point.
TEST(Deformer, MakesOneTreeOfClosestPointsForAllFrames)
{
  const auto model = std::make_shared<Model>(makeModel(test::plate(6, 5)));
  // The point comes first in later frames: where it was located is known for its place in the list alone.
  const Constraint held = test::hold({0, 1, 2});
  const auto point = [](double height) { return test::moveTo(AtNear{Vector3(3.3, 2.6, 1)}, Vector3(3, 3, height)); };
  Deformer deformer(model);
  const FewTerms first = deformer.deform(test::listOf({held, point(1)})).details->system.rows.back().terms;
  model->mesh.positions.rowwise() += Eigen::RowVector3d(50, 20, 0);
  EXPECT_EQ(deformer.deform(test::listOf({point(2), held})).details->system.rows.front().terms, first);
  const SurfaceLocator another(model->mesh, model->triangulation);
  EXPECT_FALSE(another.locate(AtNear{Vector3(3.3, 2.6, 1)}, {}).terms == first)
      << "a tree made now finds another point";
}

/// What is selected by places at rest: vertex 30, which moves up, is not.
ConstraintList heldAndMoved(Selection selection)
{
  return test::listOf({{"", true, FixedConstraint{std::move(selection)}}, test::moveBy(AtVertex{30}, {0, 0, 1})});
}

Selection outside(const Selection& selection)
{
  return {NotIn{std::make_shared<const Selection>(selection)}};
}

TEST(Deformer, SelectsVerticesOnceForAllFrames)
{
  const auto model = std::make_shared<Model>(makeModel(test::plate(6, 5)));
  const ConstraintList list = heldAndMoved({InBox{{-1, -1, -1}, {1.5, 9, 1}}});
  Deformer deformer(model);
  const std::size_t rows = deformer.deform(list).details->system.rows.size();
  model->mesh.positions.rowwise() += Eigen::RowVector3d(50, 20, 0);
  EXPECT_EQ(deformer.deform(list).details->system.rows.size(), rows);
  EXPECT_THROW(static_cast<void>(Deformer(model).deform(list)), InputError) << "none is selected there now";
}

TEST(Deformer, FactorisesNothingWhenOnlyTargetsAndRotationsChange)
{
  const Model model = makeModel(test::plate(6, 5), "mesh");
  for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange}) {
    const DeformOptions options{Weights::Cotangent, {kind, Backend::Holdfast, 5}};
    Deformer deformer(model, options);
    Recorder first;
    static_cast<void>(deformer.deform(dragged(20, Vector3::UnitZ()), "list", first));
    EXPECT_TRUE(hasStep(first, "factorising"));
    EXPECT_TRUE(hasStep(first, "solving the rotation field"));
    Recorder second;
    const DeformResult again = deformer.deform(dragged(200, Vector3::UnitX()), "list", second);
    EXPECT_EQ(second.stages, (std::vector<std::string>{"solving"}));
    NoProgress progress;
    const DeformResult fresh = deform(model, dragged(200, Vector3::UnitX()), "list", options, progress);
    EXPECT_EQ(again.positions, fresh.positions) << "bit for bit";
    EXPECT_EQ(again.rotations, fresh.rotations);
  }
}

/// Frames in which a point moves, goes elsewhere, changes places in the list, is disabled and comes back.
std::vector<ConstraintList> changedFrames()
{
  const auto frame = [](std::vector<SurfaceLocation> places, double height) {
    std::vector<Constraint> constraints{test::hold({0, 1, 2})};
    for (SurfaceLocation& at : places) constraints.push_back(test::moveBy(std::move(at), {0, 0, height}));
    return test::listOf(std::move(constraints));
  };
  const SurfaceLocation face = AtFace{9, {0.2, 0.3, 0.5}};
  const SurfaceLocation inside = AtFace{9, {0.5, 0.3, 0.2}};
  const SurfaceLocation vertex = AtVertex{30};
  std::vector<ConstraintList> frames{frame({face, vertex}, 1),   frame({face, vertex}, 2), frame({inside, vertex}, 2),
                                     frame({vertex, inside}, 2), frame({vertex}, 3),       frame({vertex, face}, 3)};
  frames[4].constraints[1].isEnabled = false;
  return frames;
}

/// Frames in which vertices are selected by other numbers, in another way, and as before.
std::vector<ConstraintList> changedSelections()
{
  const Selection narrow{InBox{{-1, -1, -1}, {0.5, 9, 1}}};
  const Selection wide{InBox{{-1, -1, -1}, {1.5, 9, 1}}};
  const Selection low{InHalfSpace{{0, 0.5, 0}, {0, -1, 0}}};
  const Selection ball{InSphere{{0, 0, 0}, 1.2}};
  std::vector<ConstraintList> frames;
  for (const Selection& selection :
       {narrow, wide, wide, low, Selection{InHalfSpace{{0, 1.5, 0}, {0, -1, 0}}}, ball,
        Selection{InSphere{{0, 0, 0}, 2.1}}, Selection{VertexIds{{0, 1}}}, Selection{VertexIds{{0, 2}}},
        Selection{AnyOf{{narrow, low}}}, Selection{AnyOf{{wide, low}}}, Selection{AllOf{{wide, low}}},
        Selection{AllOf{{narrow, low}}}, outside(outside(narrow)), outside(outside(wide)), outside(outside(wide)),
        narrow})
    frames.push_back(heldAndMoved(selection));
  return frames;
}

void expectRowsOfFreshOnes(const std::vector<ConstraintList>& frames)
{
  const Model model = makeModel(test::plate(6, 5), "mesh");
  Deformer deformer(model);
  for (const ConstraintList& list : frames) {
    const DeformResult result = deformer.deform(list);
    const DeformResult fresh = deform(model, list);
    EXPECT_EQ(result.positions, fresh.positions);
    ASSERT_EQ(result.details->system.rows.size(), fresh.details->system.rows.size());
    for (std::size_t r = 0; r < fresh.details->system.rows.size(); ++r) {
      EXPECT_EQ(result.details->system.rows[r].terms, fresh.details->system.rows[r].terms);
      EXPECT_EQ(result.details->system.rows[r].target, fresh.details->system.rows[r].target);
    }
  }
}

TEST(Deformer, HasTheRowsOfAFreshOneWhateverPointsAndSelectionsChanged)
{
  expectRowsOfFreshOnes(changedFrames());
  expectRowsOfFreshOnes(changedSelections());
}

TEST(Deformer, HasTheVerdictsOfAFreshOneWhateverTargetsChanged)
{
  const auto frame = [](double first, double repeated, double apart) {
    const SurfaceLocation face = AtFace{9, {0.2, 0.3, 0.5}};
    return test::listOf({test::hold({0, 1, 2}), test::moveBy(face, {0, 0, first}), test::moveBy(face, {0, 0, repeated}),
                         test::moveBy(AtVertex{30}, {0, 0, apart})});
  };
  const std::vector<ConstraintList> frames{frame(1, 1, 1), frame(1, 1, 2), frame(1, 2, 2),
                                           frame(1, 2, 3), frame(2, 2, 3), frame(3, 2, 3)};
  for (const double place : {0.0, 1e6}) {  // limits depend on all targets far from the origin
    Mesh mesh = test::plate(6, 5);
    mesh.positions.array() += place;
    const Model model = makeModel(mesh, "mesh");
    Deformer deformer(model);
    for (const ConstraintList& list : frames) {
      const Report report = deformer.deform(list).report;
      const Report fresh = deform(model, list).report;
      ASSERT_EQ(report.constraints.size(), fresh.constraints.size());
      for (std::size_t k = 0; k < fresh.constraints.size(); ++k) {
        EXPECT_EQ(report.constraints[k].status, fresh.constraints[k].status);
        EXPECT_EQ(report.constraints[k].gap, fresh.constraints[k].gap);
        EXPECT_EQ(report.constraints[k].limit, fresh.constraints[k].limit);
      }
    }
  }
}

/// Outcomes and forces are made when somebody looks at them, which may be after the next frame, or the end.
TEST(Deformer, TellsOfEachFrameWhenAskedWhateverCameAfterIt)
{
  const auto model = std::make_shared<const Model>(makeModel(test::plate(6, 5)));
  std::vector<ConstraintList> lists;
  for (int frame = 0; frame < 5; ++frame) lists.push_back(dragged(10 * frame, Vector3(0, 0, 0.1 * frame)));
  lists.back().constraints.erase(lists.back().constraints.begin() + 1);
  std::vector<DeformResult> frames;
  {
    Deformer deformer(model, {}, DeformerMode::Interactive);
    for (const ConstraintList& list : lists) frames.push_back(deformer.deform(list));
  }
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const DeformResult fresh = Deformer(model).deform(lists[frame]);
    const ConstraintOutcomes told = frames[frame].report.constraints;
    ASSERT_EQ(told.size(), lists[frame].constraints.size());
    for (std::size_t c = 0; c < told.size(); ++c) {
      EXPECT_EQ(told[c].name, fresh.report.constraints[c].name);
      EXPECT_EQ(told[c].status, ConstraintStatus::Met);
      EXPECT_NEAR(*told[c].multiplier, *fresh.report.constraints[c].multiplier, 1e-12);
    }
    EXPECT_LT((frames[frame].multipliers() - fresh.multipliers()).norm(), 1e-12);
  }
}

TEST(ConstraintOutcomes, AreMadeOnceForAllCopiesWhereSomebodyLooks)
{
  std::atomic<int> made = 0;
  const ConstraintOutcomes outcomes([&] {
    ++made;
    return std::vector<ConstraintOutcome>(2);
  });
  const ConstraintOutcomes copy = outcomes;
  EXPECT_EQ(made, 0);
  std::thread other([&] { EXPECT_EQ(copy.size(), 2U); });
  EXPECT_EQ(&outcomes[1], &copy[1]);
  other.join();
  EXPECT_EQ(made, 1);
}

TEST(Deformer, StartsAnewWhenTheStructureChanges)
{
  const Model model = makeModel(test::plate(6, 5), "mesh");
  Deformer deformer(model, {});
  NoProgress progress;
  static_cast<void>(deformer.deform(dragged(20, Vector3::UnitZ()), "list", progress));
  ConstraintList other = dragged(20, Vector3::UnitZ());
  std::get<PointConstraint>(other.constraints[1].what).at = AtFace{9, {0.2, 0.4, 0.4}};
  Recorder recorder;
  const DeformResult result = deformer.deform(other, "list", recorder);
  EXPECT_TRUE(hasStep(recorder, "factorising"));
  EXPECT_FALSE(hasStep(recorder, "building operators"));
  EXPECT_EQ(result.positions, deform(model, other, "list", {}, progress).positions);
}

TEST(Deformer, IsUsableAfterItWasCancelled)
{
  const Model model = makeModel(test::plate(6, 5), "mesh");
  for (const std::string step : {"ordering", "building", "eliminating", "factorising", "solving the", "solving"}) {
    Deformer deformer(model, {});
    Recorder cancelling;
    cancelling.cancelAt = step;
    EXPECT_THROW(static_cast<void>(deformer.deform(dragged(20, Vector3::UnitZ()), "list", cancelling)), Cancelled);
    NoProgress progress;
    EXPECT_EQ(deformer.deform(dragged(20, Vector3::UnitZ()), "list", progress).positions,
              deform(model, dragged(20, Vector3::UnitZ()), "list", {}, progress).positions)
        << step;
  }
}

TEST(Deformer, TakesNewTargetsWithoutANewList)
{
  const ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveTo(AtVertex{30}, {5, 5, 5})});
  ConstraintList moved = list;
  std::get<PointConstraint>(moved.constraints[1].what).to = Target{{6, 5, 4}};
  Deformer deformer(makeModel(test::plate(6, 5)));
  deformer.setConstraints(list);
  const DeformResult first = deformer.deform();
  EXPECT_EQ(first.positions.row(30), Eigen::RowVector3d(5, 5, 5));
  deformer.setTarget("P1", {6, 5, 4});
  Recorder recorder;
  EXPECT_EQ(deformer.deform(recorder).positions, deform(deformer.model(), moved).positions);
  EXPECT_FALSE(hasStep(recorder, "eliminating") || hasStep(recorder, "factorising"));
}

TEST(Deformer, RefusesTargetsOfWhatHasNone)
{
  Deformer deformer(makeModel(test::plate(6, 5)));
  deformer.setConstraints(test::listOf({test::hold({0, 1, 2})}));
  EXPECT_THROW(deformer.setTarget("nonesuch", {0, 0, 0}), InputError);
  EXPECT_EQ(deformer.constraint("P0").name, "P0");
  EXPECT_THROW(deformer.setTarget("P0", {0, 0, 0}), InputError) << "it is fixed";
}

}  // namespace
}  // namespace holdfast
