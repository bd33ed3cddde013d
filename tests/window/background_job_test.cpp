#include <QApplication>
#include <QDialog>
#include <QProgressDialog>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <holdfast/window/files/progress_dialog.h>
#include <holdfast/window/model/background_job.h>

#include "dialogs.h"
#include "gestures.h"

namespace holdfast {
namespace {

/// Work that goes from stage to stage until it is cancelled.
BackgroundJob::Finish forever(Progress& progress)
{
  while (true) progress.step("turning the wheel");
}

TEST(BackgroundJob, FinishesOnTheThreadThatStartedIt)
{
  BackgroundJob job;
  std::thread::id finishedOn;
  std::thread::id workedOn;
  job.start([&](Progress&) {
    workedOn = std::this_thread::get_id();
    return [&] { finishedOn = std::this_thread::get_id(); };
  });
  EXPECT_TRUE(job.isRunning());
  ASSERT_TRUE(test::waitUntil([&] { return !job.isRunning(); }));
  EXPECT_EQ(finishedOn, std::this_thread::get_id());
  EXPECT_NE(workedOn, finishedOn);
}

TEST(BackgroundJob, OfSeveralTheNewestAloneIsHeardOf)
{
  BackgroundJob job;
  int finished = 0;
  std::promise<void> hold;
  job.start([&, held = hold.get_future().share()](Progress&) {
    held.wait();
    return [&] { finished += 1; };
  });
  job.start([&](Progress&) { return [&] { finished += 10; }; });
  hold.set_value();
  ASSERT_TRUE(test::waitUntil([&] { return !job.isRunning(); }));
  EXPECT_EQ(finished, 10);
}

TEST(BackgroundJob, FailuresAreHanded)
{
  BackgroundJob job;
  std::string reason;
  QObject::connect(&job, &BackgroundJob::failed, &job, [&](const std::exception_ptr& error) {
    try {
      std::rethrow_exception(error);
    } catch (const std::runtime_error& problem) {
      reason = problem.what();
    }
  });
  job.start([](Progress&) -> BackgroundJob::Finish { throw std::runtime_error("no paper"); });
  ASSERT_TRUE(test::waitUntil([&] { return !job.isRunning(); }));
  EXPECT_EQ(reason, "no paper");
}

TEST(BackgroundJob, EndsWithItsOwnerInTheMiddleOfWork)
{
  auto job = std::make_unique<BackgroundJob>();
  int heard = 0;
  const auto hear = [&] { ++heard; };
  QObject::connect(job.get(), &BackgroundJob::stepChanged, hear);
  QObject::connect(job.get(), &BackgroundJob::ended, hear);
  QObject::connect(job.get(), &BackgroundJob::failed, hear);
  std::promise<void> hasBegun;
  std::atomic<bool> hasEnded = false;
  job->start([&](Progress& progress) -> BackgroundJob::Finish {
    progress.step("turning the wheel");
    hasBegun.set_value();
    try {
      return forever(progress);
    } catch (...) {
      // Late enough for an owner who does not wait to be found out.
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      hasEnded = true;
      throw;
    }
  });
  hasBegun.get_future().wait();
  job.reset();
  EXPECT_TRUE(hasEnded) << "the thread is gone with its owner";
  QApplication::processEvents();
  EXPECT_EQ(heard, 0);
}

TEST(ProgressDialog, TellsTheStepAndCancels)
{
  QWidget window;
  ASSERT_TRUE(test::showAndWait(window));
  BackgroundJob job;
  std::atomic<bool> isSeen = false;
  job.start([&](Progress& progress) -> BackgroundJob::Finish {
    progress.step("turning the wheel");
    while (!isSeen) std::this_thread::yield();
    return forever(progress);
  });
  showProgress(job, &window, "Opening a mill");
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("progress") != nullptr; }));
  auto* dialog = qobject_cast<QProgressDialog*>(test::findDialog("progress"));
  EXPECT_EQ(dialog->labelText(), "turning the wheel");
  EXPECT_EQ(dialog->windowModality(), Qt::NonModal);
  EXPECT_TRUE(dialog->testAttribute(Qt::WA_ShowWithoutActivating)) << "keys stay where they are typed";
  test::clickButton(*dialog, "Cancel");
  EXPECT_FALSE(job.isRunning());
  isSeen = true;
  EXPECT_TRUE(test::waitUntil([] { return test::findDialog("progress") == nullptr; }));
}

/// Two jobs that run until they are cancelled, over one window.
class ProgressOfWindow : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(test::showAndWait(window)); }

  void begin(BackgroundJob& running, const char* title)
  {
    running.start(forever);
    showProgress(running, &window, title);
  }

  [[nodiscard]] static bool waitForProgress(const char* title)
  {
    return test::waitUntil([=] {
      QDialog* seen = test::findDialog("progress");
      return seen != nullptr && seen->windowTitle() == title;
    });
  }

  QWidget window;
  BackgroundJob job;
  BackgroundJob other;
};

TEST_F(ProgressOfWindow, HidesWhileAnotherDialogIsOpenAndComesBack)
{
  begin(job, "Opening a mill");
  ASSERT_TRUE(waitForProgress("Opening a mill"));
  for (const Qt::WindowModality modality : {Qt::WindowModal, Qt::ApplicationModal}) {
    QDialog question(&window);
    question.setWindowModality(modality);
    ASSERT_TRUE(test::showAndWait(question));
    EXPECT_EQ(test::findDialog("progress"), nullptr);
    test::passProgressDelay();
    EXPECT_EQ(test::findDialog("progress"), nullptr);
    question.hide();
    EXPECT_TRUE(waitForProgress("Opening a mill"));
  }
}

TEST_F(ProgressOfWindow, OfWorkThatBeginsDuringADialogComesAfterIt)
{
  QDialog question(&window);
  question.setWindowModality(Qt::WindowModal);
  ASSERT_TRUE(test::showAndWait(question));
  begin(job, "Opening a mill");
  test::passProgressDelay();
  EXPECT_EQ(test::findDialog("progress"), nullptr);
  question.hide();
  EXPECT_TRUE(waitForProgress("Opening a mill"));
}

TEST_F(ProgressOfWindow, ShowsOneJobAfterTheOther)
{
  begin(job, "Opening a mill");
  begin(other, "Writing a mill");
  ASSERT_TRUE(waitForProgress("Opening a mill"));
  test::passProgressDelay();
  const auto all = window.findChildren<QProgressDialog*>();
  EXPECT_EQ(std::ranges::count_if(all, [](const QWidget* dialog) { return dialog->isVisible(); }), 1);
  job.cancel();
  EXPECT_TRUE(waitForProgress("Writing a mill"));
}

TEST_F(ProgressOfWindow, NeverComesOnceTheWorkHasEnded)
{
  int seen = 0;
  QObject::connect(&job, &BackgroundJob::ended, [&] {
    // A message waits so, in a loop of its own.
    test::passProgressDelay();
    seen += test::findDialog("progress") == nullptr ? 0 : 1;
  });
  begin(job, "Opening a mill");
  job.cancel();
  EXPECT_EQ(seen, 0);
  test::passProgressDelay();
  EXPECT_EQ(test::findDialog("progress"), nullptr);
}

}  // namespace
}  // namespace holdfast
