#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/threads/long_step.h>

#include "support/latch.h"

namespace holdfast {
namespace {

using test::Latch;

/// Work that goes on until its latch is opened.
struct HeldBack {
  std::shared_ptr<Latch> mayEnd = std::make_shared<Latch>();
  std::shared_ptr<std::atomic<int>> begun = std::make_shared<std::atomic<int>>(0);

  int operator()() const
  {
    ++*begun;
    EXPECT_TRUE(mayEnd->wait());
    return 42;
  }
};

/// Cancels as soon as the work has begun.
class UntilBegun final : public Progress {
 public:
  explicit UntilBegun(const HeldBack& work) : begun_(work.begun) {}

  void step(std::string_view /*description*/) override {}
  void proceed(double /*share*/) override
  {
    if (*begun_ > 0) throw Cancelled();
  }

 private:
  std::shared_ptr<const std::atomic<int>> begun_;
};

/// Cancels as soon as it is asked.
class Impatient final : public Progress {
 public:
  void step(std::string_view /*description*/) override {}
  void proceed(double /*share*/) override { throw Cancelled(); }
};

/// Lets work end when it is asked.
class Opening final : public Progress {
 public:
  explicit Opening(const HeldBack& work) : mayEnd_(work.mayEnd) {}

  void step(std::string_view /*description*/) override {}
  void proceed(double /*share*/) override { mayEnd_->open(); }

 private:
  std::shared_ptr<Latch> mayEnd_;
};

TEST(LongStep, GivesWhatItsWorkComesTo)
{
  NoProgress progress;
  LongStep<int> step([] { return 42; });
  EXPECT_FALSE(step.isDone()) << "nothing begins before it is asked for";
  EXPECT_EQ(step.result(progress), 42);
  EXPECT_TRUE(step.isDone());
  EXPECT_EQ(step.result(progress), 42);
}

TEST(LongStep, ThrowsWhatItsWorkThrows)
{
  NoProgress progress;
  LongStep<int> step([]() -> int { throw std::runtime_error("no memory"); });
  EXPECT_THROW(static_cast<void>(step.result(progress)), std::runtime_error);
}

TEST(LongStep, WhoAsksAgainWaitsForTheSameWork)
{
  const HeldBack work;
  LongStep<int> step(work);
  UntilBegun untilBegun(work);
  EXPECT_THROW(static_cast<void>(step.result(untilBegun)), Cancelled) << "while it goes on";
  EXPECT_FALSE(step.isDone());
  Opening opening(work);
  EXPECT_EQ(step.result(opening), 42);
  EXPECT_EQ(*work.begun, 1);
}

TEST(LongStep, LeavesBehindWhatItHolds)
{
  const auto held = std::make_shared<int>(7);
  const HeldBack work;
  {
    LongStep<int> step([work, held] { return work() + *held; });
    UntilBegun untilBegun(work);
    EXPECT_THROW(static_cast<void>(step.result(untilBegun)), Cancelled);
  }
  EXPECT_EQ(held.use_count(), 2) << "it goes on";
  work.mayEnd->open();
}

TEST(LongStep, IsPreparedOnItsOwnThread)
{
  static thread_local bool isPrepared = false;
  LongStep<bool> step([] { return isPrepared; });
  step.start(noProgress(), [] { isPrepared = true; });
  EXPECT_TRUE(step.result(noProgress()));
  EXPECT_FALSE(isPrepared) << "of the calling thread";
}

TEST(LongStep, TellsItsWorkWhenNobodyWaits)
{
  EXPECT_FALSE(currentStep()->isLeftBehind()) << "no step at all";
  const auto hasEnded = std::make_shared<Latch>();
  const HeldBack work;
  {
    LongStep<int> step([work, hasEnded] {
      const std::shared_ptr<const StepState> own = currentStep();
      EXPECT_FALSE(own->isLeftBehind());
      EXPECT_NO_THROW(own->stopIfLeftBehind());
      const int result = work();
      EXPECT_TRUE(own->isLeftBehind());
      EXPECT_THROW(own->stopIfLeftBehind(), LeftBehind);
      hasEnded->open();
      return result;
    });
    UntilBegun untilBegun(work);
    EXPECT_THROW(static_cast<void>(step.result(untilBegun)), Cancelled);
  }
  work.mayEnd->open();
  EXPECT_TRUE(hasEnded->wait());
}

/// Keeps the last share, and lets the work end once it has one.
class Share final : public Progress {
 public:
  explicit Share(const HeldBack& work) : mayEnd_(work.mayEnd) {}

  void step(std::string_view /*description*/) override {}
  void proceed(double share) override
  {
    last = share;
    if (share > 0) mayEnd_->open();
  }

  double last = 0;

 private:
  std::shared_ptr<Latch> mayEnd_;
};

TEST(LongStep, TellsWhoWaitsTheShareThatIsDone)
{
  const HeldBack work;
  LongStep<int> step([work] {
    currentStep()->setShare(0.25);
    return work();
  });
  Share share(work);
  EXPECT_EQ(step.result(share), 42);
  EXPECT_EQ(share.last, 0.25);
}

TEST(StoppableProgress, ReportsEachPercentOnce)
{
  std::vector<std::string> reports;
  StoppableProgress progress([] { return false; }, [&](std::string_view report) { reports.emplace_back(report); });
  progress.step("factorising");
  for (const double share : {0.0, 0.004, 0.01, 0.014, 0.4, 0.3}) progress.proceed(share);
  progress.step("solving");
  progress.proceed(0.01);
  EXPECT_EQ(reports, (std::vector<std::string>{"factorising", "factorising, 1 %", "factorising, 40 %", "solving",
                                               "solving, 1 %"}));
}

TEST(LongStep, OneMoreGoesOnBesideWhatWasLeftBehindAndAThirdWaits)
{
  const HeldBack first;
  const HeldBack second;
  for (const HeldBack& work : {first, second}) {
    LongStep<int> step(work);
    UntilBegun untilBegun(work);
    EXPECT_THROW(static_cast<void>(step.result(untilBegun)), Cancelled) << "it has begun";
  }
  LongStep<int> third([] { return 3; });
  Impatient impatient;
  EXPECT_THROW(static_cast<void>(third.result(impatient)), Cancelled) << "it waits, and can be cancelled";
  EXPECT_FALSE(third.isDone());
  Opening opening(first);
  EXPECT_EQ(third.result(opening), 3) << "one of both has ended";
  second.mayEnd->open();
}

}  // namespace
}  // namespace holdfast
