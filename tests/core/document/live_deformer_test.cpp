#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/live_deformer.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/threads/long_step.h>

#include "core/document/live_witness.h"
#include "support/law_meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using Kind = LiveEvent::Kind;
using test::End;
using test::Gate;
using test::kLastStep;
using test::Latch;
using test::Witness;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::shared_ptr<const Model> plateModel()
{
  return std::make_shared<const Model>(makeModel(test::plate(6, 5), "mesh"));
}

std::shared_ptr<const DocumentState> stateOf(ConstraintList list, DeformOptions options = {})
{
  return std::make_shared<const DocumentState>(DocumentState{std::move(list), options});
}

std::shared_ptr<const DocumentState> dragged(double height)
{
  return stateOf(test::listOf({test::hold({0, 1, 2}), test::moveBy(AtFace{9, {0.2, 0.3, 0.5}}, {0, 0, height})}));
}

std::shared_ptr<const DocumentState> unusable()
{
  return stateOf(test::listOf({test::hold({100000})}));
}

Positions freshly(const Model& model, const DocumentState& state)
{
  NoProgress progress;
  return deform(model, state.list, "list", state.options, progress).positions;
}

TEST(LiveDeformer, GivesTheDeformationThatIsAskedFor)
{
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  live.submit(1, dragged(0.5), "list", Supersede::AtNextStep);
  const std::vector<LiveEvent> events = witness.eventsTo(1);
  EXPECT_EQ(events.front().kind, Kind::Started);
  EXPECT_EQ(events[1].kind, Kind::Step);
  EXPECT_THAT(events[1].message, HasSubstr("ordering"));
  ASSERT_EQ(events.back().kind, Kind::Done);
  EXPECT_EQ(events.back().deformation->positions, freshly(*model, *dragged(0.5)));
}

TEST(LiveDeformer, LooksAtAResultThatNothingNewerFollows)
{
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  live.submit(1, dragged(0.5), "list", Supersede::AtNextStep);
  const std::shared_ptr<const Report> report = witness.examined(1);
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->result.crossingFaces, 0);
  const LiveEvent done = witness.eventsTo(1).back();
  EXPECT_EQ(done.deformation->report.result.status, ResultStatus::NotMeasured) << "what was done is not changed";
}

TEST(LiveDeformer, FindsRotationsFrameByFrameWhileADragRestsAndAnewForAnEdit)
{
  const auto model = plateModel();
  DeformOptions finding;
  finding.rotations.source = RotationSource::Found;
  finding.rotations.change = 1e-9;
  const auto state = stateOf(dragged(2)->list, finding);
  Witness witness;
  LiveDeformer live(model, witness.listener());
  live.submit(1, state, "list", Supersede::WhenDone);
  const std::vector<LiveEvent> events = witness.eventsTo(1);
  EXPECT_GT(std::ranges::count(events, Kind::Iterate, &LiveEvent::kind), 1);
  for (const LiveEvent& event : events)
    if (event.kind == Kind::Iterate) {
      EXPECT_FALSE(event.deformation->report.solve.iterations->isConverged);
      EXPECT_LE(event.deformation->report.solve.maxResidualRelative, kPromisedResidual);
    }
  ASSERT_EQ(events.back().kind, Kind::Done);
  EXPECT_TRUE(events.back().deformation->report.solve.iterations->isConverged);
  live.submit(2, state, "list", Supersede::AtNextStep);
  EXPECT_EQ(witness.eventsTo(2).back().deformation->positions, freshly(*model, *state));
}

TEST(LiveDeformer, AFrameWhoseRotationsAreBeingFoundGivesWayToTheNext)
{
  DeformOptions finding;
  finding.rotations.source = RotationSource::Found;
  finding.rotations.change = 1e-9;
  Witness witness(Gate{1, Kind::Iterate, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, stateOf(dragged(2)->list, finding), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, stateOf(dragged(2.1)->list, finding), "list", Supersede::WhenDone);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Done), End(2, Kind::Done)));
}

TEST(LiveDeformer, AnEditGivesUpTheWorkUnderWayAndTellsNothingOfItsEnd)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::AtNextStep);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, dragged(2), "list", Supersede::AtNextStep);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(2, Kind::Done)));
}

TEST(LiveDeformer, AnEditDuringTheLastStageKeepsTheOlderResultToItself)
{
  Witness witness(Gate{2, Kind::Step, kLastStep});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::AtNextStep);
  ASSERT_THAT(witness.endsTo(1), ElementsAre(End(1, Kind::Done)));
  live.submit(2, dragged(2), "list", Supersede::AtNextStep);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(3, dragged(3), "list", Supersede::AtNextStep);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(3), ElementsAre(End(1, Kind::Done), End(3, Kind::Done)));
}

TEST(LiveDeformer, AFrameOfADragIsFinishedBeforeTheNext)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Done), End(2, Kind::Done)));
}

TEST(LiveDeformer, OfStatesThatWaitOnlyTheNewestIsDeformed)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  for (std::uint64_t revision = 2; revision <= 9; ++revision)
    live.submit(revision, dragged(static_cast<double>(revision)), "list", Supersede::WhenDone);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(9), ElementsAre(End(1, Kind::Done), End(9, Kind::Done)));
  for (const LiveEvent& event : witness.eventsTo(9)) EXPECT_TRUE(event.revision == 1 || event.revision == 9);
}

TEST(LiveDeformer, TheNextFrameOfADragIsOfWhatIsNewestWhenTheLastIsSeen)
{
  Witness witness;
  LiveDeformer live(plateModel(), witness.listener());
  std::uint64_t last = 1;
  // Longer pauses than a frame waits for are no test.
  for (std::chrono::steady_clock::duration taken = std::chrono::hours(1); taken > std::chrono::milliseconds(50);) {
    live.submit(last, dragged(1), "list", Supersede::WhenDone);
    EXPECT_EQ(witness.endsTo(last).back(), End(last, Kind::Done));
    const auto start = std::chrono::steady_clock::now();
    live.submit(last + 1, dragged(2), "list", Supersede::WhenDone);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    last += 2;
    live.submit(last, dragged(3), "list", Supersede::WhenDone);
    live.resultIsSeen();
    taken = std::chrono::steady_clock::now() - start;
  }
  const std::vector<End> ends = witness.endsTo(last);
  EXPECT_EQ(ends.back(), End(last, Kind::Done));
  EXPECT_EQ(ends.at(ends.size() - 2), End(last - 2, Kind::Done)) << "the state between was not asked for any more";
}

TEST(LiveDeformer, AnEditStandsWhereADragGoesOn)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, dragged(2), "list", Supersede::AtNextStep);
  live.submit(3, dragged(3), "list", Supersede::WhenDone);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(3), ElementsAre(End(3, Kind::Done)));
}

TEST(LiveDeformer, CancelEndsWhatIsUnderWayAndWhatWaits)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  live.cancel();
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Cancelled), End(2, Kind::Cancelled)));
}

TEST(LiveDeformer, CancelDuringTheLastStageKeepsTheResultToItself)
{
  Witness witness(Gate{2, Kind::Step, kLastStep});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_THAT(witness.endsTo(1), ElementsAre(End(1, Kind::Done)));
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.cancel();
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Done), End(2, Kind::Cancelled)));
}

TEST(LiveDeformer, CancelDoesNotReachWhatIsSubmittedAfterIt)
{
  Witness witness(Gate{1, Kind::Step, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.cancel();
  live.submit(2, dragged(2), "list", Supersede::AtNextStep);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Cancelled), End(2, Kind::Done)));
}

TEST(LiveDeformer, CancelWithNothingToDoIsForgotten)
{
  Witness witness;
  LiveDeformer live(plateModel(), witness.listener());
  live.cancel();
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  EXPECT_THAT(witness.endsTo(1), ElementsAre(End(1, Kind::Done)));
  live.cancel();
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(1, Kind::Done), End(2, Kind::Done)));
}

TEST(LiveDeformer, EveryCancelledRevisionEndsOnceWhateverTheTiming)
{
  Witness witness;
  LiveDeformer live(plateModel(), witness.listener());
  for (std::uint64_t revision = 1; revision <= 200; ++revision) {
    live.submit(revision, dragged(static_cast<double>(revision)), "list", Supersede::WhenDone);
    live.cancel();
    const std::vector<End> ends = witness.endsTo(revision);
    ASSERT_EQ(ends.size(), revision);
    EXPECT_EQ(ends.back().first, revision);
  }
}

/// Steps that were left behind and go on until this ends.
class LeftBehind {
 public:
  explicit LeftBehind(int count)
  {
    NoProgress progress;
    for (int k = 0; k < count; ++k) StepThread().start([mayEnd = mayEnd_] { EXPECT_TRUE(mayEnd->wait()); }, progress);
  }
  ~LeftBehind() { end(); }
  LeftBehind(const LeftBehind&) = delete;
  LeftBehind& operator=(const LeftBehind&) = delete;

  void end() { mayEnd_->open(); }

 private:
  std::shared_ptr<Latch> mayEnd_ = std::make_shared<Latch>();
};

TEST(LiveDeformer, FactorisesBesideWhatIsLeftBehind)
{
  LeftBehind factorisation(1);
  Witness witness;
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::AtNextStep);
  EXPECT_THAT(witness.endsTo(1), ElementsAre(End(1, Kind::Done)));
}

TEST(LiveDeformer, CancelWaitsForNoFactorisation)
{
  LeftBehind factorisations(2);  // so that no other begins
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.hasStep(1, "ordering"));
  live.cancel();
  EXPECT_THAT(witness.endsTo(1), ElementsAre(End(1, Kind::Cancelled)));
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.hasStep(2, "ordering"));
  live.submit(3, dragged(3), "list", Supersede::AtNextStep);
  ASSERT_TRUE(witness.hasStep(3, "ordering"));
  factorisations.end();
  EXPECT_THAT(witness.endsTo(3), ElementsAre(End(1, Kind::Cancelled), End(3, Kind::Done)));
  EXPECT_EQ(witness.eventsTo(3).back().deformation->positions, freshly(*model, *dragged(3)));
}

TEST(LiveDeformer, SaysWhichStateADeformationIsOf)
{
  Latch isDone;
  std::shared_ptr<const DocumentState> told;
  LiveDeformer live(plateModel(), [&](const LiveEvent& event) {
    if (event.kind != Kind::Done) return;
    told = event.state;
    isDone.open();
  });
  const auto state = dragged(1);
  live.submit(1, state, "list", Supersede::WhenDone);
  ASSERT_TRUE(isDone.wait());
  EXPECT_EQ(told, state);
}

TEST(LiveDeformer, SaysWhyAListIsUnusableAndGoesOn)
{
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  live.submit(1, unusable(), "part.json", Supersede::AtNextStep);
  const LiveEvent refused = witness.eventsTo(1).back();
  EXPECT_EQ(refused.kind, Kind::Unusable);
  EXPECT_THAT(refused.message, HasSubstr("part.json"));
  EXPECT_THAT(refused.message, HasSubstr("there is no vertex 100000"));
  EXPECT_EQ(refused.deformation, nullptr);
  live.submit(2, dragged(1), "part.json", Supersede::AtNextStep);
  EXPECT_EQ(witness.eventsTo(2).back().deformation->positions, freshly(*model, *dragged(1)));
}

TEST(LiveDeformer, AnUnusableListThatANewerOneReplacedIsNotToldOf)
{
  Witness witness(Gate{1, Kind::Started, ""});
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, unusable(), "list", Supersede::WhenDone);
  ASSERT_TRUE(witness.isAtGate());
  live.submit(2, dragged(1), "list", Supersede::AtNextStep);
  witness.openGate();
  EXPECT_THAT(witness.endsTo(2), ElementsAre(End(2, Kind::Done)));
}

TEST(LiveDeformer, FramesOfADragAreBitEqualToFreshDeformations)
{
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  for (std::uint64_t revision = 1; revision <= 20; ++revision) {
    const auto state = dragged(0.1 * static_cast<double>(revision));
    live.submit(revision, state, "list", Supersede::WhenDone);
    const LiveEvent end = witness.eventsTo(revision).back();
    ASSERT_EQ(end.kind, Kind::Done);
    EXPECT_EQ(end.deformation->positions, freshly(*model, *state)) << "frame " << revision;
  }
}

TEST(LiveDeformer, AFrameAfterTheFirstFactorisesNothing)
{
  Witness witness;
  LiveDeformer live(plateModel(), witness.listener());
  live.submit(1, dragged(1), "list", Supersede::WhenDone);
  static_cast<void>(witness.eventsTo(1));
  live.submit(2, dragged(2), "list", Supersede::WhenDone);
  for (const LiveEvent& event : witness.eventsTo(2)) {
    if (event.revision == 1 || event.kind != Kind::Step) continue;
    EXPECT_THAT(event.message, StartsWith("solving"));
  }
}

TEST(LiveDeformer, OtherOptionsMakeAnotherDeformation)
{
  const auto model = plateModel();
  Witness witness;
  LiveDeformer live(model, witness.listener());
  DeformOptions options;
  std::uint64_t revision = 0;
  for (const Weights weights : {Weights::Cotangent, Weights::Uniform, Weights::Cotangent}) {
    options.weights = weights;
    const auto state = stateOf(dragged(1)->list, options);
    live.submit(++revision, state, "list", Supersede::AtNextStep);
    EXPECT_EQ(witness.eventsTo(revision).back().deformation->positions, freshly(*model, *state));
  }
}

TEST(LiveDeformer, TheDestructorDoesNotWaitForTheWorkerAndSilencesIt)
{
  Latch isHeld;
  Latch isReleased;
  Latch isGone;
  // The worker is held back where it lets go of the first state, outside the listener.
  std::shared_ptr<const DocumentState> holding(new DocumentState(*dragged(1)), [&](const DocumentState* state) {
    delete state;
    isHeld.open();
    EXPECT_TRUE(isReleased.wait()) << "the destructor waits for the worker";
  });
  std::shared_ptr<const Model> model(new Model(*plateModel()), [&](const Model* dying) {
    delete dying;
    isGone.open();
  });
  Witness witness;
  {
    LiveDeformer live(std::move(model), witness.listener());
    live.submit(1, std::move(holding), "list", Supersede::WhenDone);
    static_cast<void>(witness.eventsTo(1));
    ASSERT_TRUE(isHeld.wait());
    live.submit(2, dragged(2), "list", Supersede::WhenDone);
  }
  const std::size_t told = witness.count();
  isReleased.open();
  ASSERT_TRUE(isGone.wait()) << "the worker ends";
  EXPECT_EQ(witness.count(), told);
}

TEST(LiveDeformer, TheDestructorWaitsForTheListenerThatIsBeingCalled)
{
  Latch isCalled;
  Latch isReleased;
  bool hasReturned = false;
  auto live = std::make_unique<LiveDeformer>(plateModel(), [&](const LiveEvent&) {
    isCalled.open();
    EXPECT_TRUE(isReleased.wait());
    hasReturned = true;
  });
  live->submit(1, dragged(1), "list", Supersede::WhenDone);
  ASSERT_TRUE(isCalled.wait());
  std::future<void> gone = std::async(std::launch::async, [&] { live.reset(); });
  isReleased.open();
  gone.get();
  EXPECT_TRUE(hasReturned);
}

TEST(LiveDeformer, MayGoAsSoonAsItHasCome)
{
  for (int k = 0; k < 50; ++k) {
    Latch isGone;
    std::shared_ptr<const Model> model(new Model(*plateModel()), [&](const Model* dying) {
      delete dying;
      isGone.open();
    });
    Witness witness;
    Latch hasBegun;
    {
      LiveDeformer live(std::move(model), [&, tell = witness.listener()](const LiveEvent& event) {
        tell(event);
        hasBegun.open();
      });
      live.submit(1, dragged(1), "list", Supersede::WhenDone);
      // Before its work begins, and in the middle of it.
      ASSERT_TRUE(k % 2 == 0 || hasBegun.wait());
    }
    const std::size_t told = witness.count();
    ASSERT_TRUE(isGone.wait()) << "the worker ends";
    EXPECT_EQ(witness.count(), told);
  }
}

}  // namespace
}  // namespace holdfast
