#include "holdfast/document/live_deformer.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <holdfast/deform/deformer.h>
#include <holdfast/threads/background_threads.h>
#include <holdfast/threads/thread_priority.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

// From so many unknowns on, a factorisation takes longer than a hand waits.
constexpr Index kLargeMesh = 20000;

constexpr std::chrono::milliseconds kLongestUnseen(100);

// A hand that drags makes a longer pause only where it rests.
constexpr std::chrono::milliseconds kRest(200);

// While frames wait for one another, so much of their time goes into looking at results.
constexpr double kLookedShare = 0.03;

using Clock = std::chrono::steady_clock;

}  // namespace

struct LiveDeformer::Shared {
  using Kind = LiveEvent::Kind;

  struct Job {
    std::uint64_t revision = 0;
    std::shared_ptr<const DocumentState> state;
    std::string source;
    Supersede supersede = Supersede::AtNextStep;
    bool isCancelled = false;  // before its work began
  };

  enum class StopRequest { GoOn, GiveUp, GiveUpAndTell };

  Shared(std::shared_ptr<const Model> itsModel, Listener itsListener)
      : model(std::move(itsModel)), listener(std::move(itsListener))
  {
  }

  void run()
  {
    while (const auto job = nextJob()) lookAt(work(*job));
    deformer.reset();
  }

  static bool isFrame(const Job& job) { return job.supersede == Supersede::WhenDone && !job.isCancelled; }

  std::optional<Job> nextJob()
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return isStopping || waiting; });
    changed.wait_for(lock, kLongestUnseen, [this] { return isStopping || !isUnseen || !isFrame(*waiting); });
    if (isStopping) return std::nullopt;
    request = StopRequest::GoOn;
    return std::exchange(waiting, std::nullopt);
  }

  /// Returns the result that was told, if there is one.
  LiveEvent work(const Job& job)
  {
    if (job.isCancelled) {
      tell({Kind::Cancelled, job.revision, "", nullptr});
      return {};
    }
    tell({Kind::Started, job.revision, "", nullptr});
    const Clock::time_point start = Clock::now();
    LiveEvent end = endOf(job);
    sinceLook += Clock::now() - start;
    const StopRequest last = finish(job);
    // A superseded result must not appear, even where no step was left to stop it at.
    if (last == StopRequest::GiveUpAndTell) end = {Kind::Cancelled, job.revision, "", nullptr};
    if (last == StopRequest::GiveUp) end = {};
    if (last != StopRequest::GiveUp) tell(end);
    return end;
  }

  StopRequest finish(const Job& job)
  {
    const std::scoped_lock lock(mutex);
    isUnseen = isFrame(job);
    return isStopping ? StopRequest::GiveUp : request;
  }

  LiveEvent endOf(const Job& job)
  {
    try {
      return {Kind::Done, job.revision, "", std::make_shared<const DeformResult>(deformed(job)), job.state};
    } catch (const Cancelled&) {
      return {Kind::Cancelled, job.revision, "", nullptr};
    } catch (const InputError& error) {
      return {Kind::Unusable, job.revision, error.what(), nullptr};
    } catch (const std::exception& error) {
      deformer.reset();  // in whatever state it was left
      return {Kind::Broken, job.revision, error.what(), nullptr};
    }
  }

  DeformResult deformed(const Job& job)
  {
    if (deformer == nullptr || deformerOptions != job.state->options) {
      const bool isLarge = model->solverMesh.unknownCount() >= kLargeMesh;
      deformer = std::make_unique<Deformer>(model, job.state->options,
                                            isLarge ? DeformerMode::Interactive : DeformerMode::Repeatable);
      deformerOptions = job.state->options;
    }
    StoppableProgress progress([this] { return stopRequest() != StopRequest::GoOn; },
                               [&](std::string_view step) {
                                 tell({Kind::Step, job.revision, std::string(step), nullptr});
                               });
    const bool isFrame =
        job.supersede == Supersede::WhenDone && deformerOptions.rotations.source != RotationSource::Given;
    if (!isFrame) return deformer->deform(job.state->list, job.source, progress);
    DeformResult result = deformer->deformFrame(job.state->list, job.source, progress);
    for (int k = 0; k < deformerOptions.rotations.mostIterations && isToGoOn(result); ++k) {
      tell({Kind::Iterate, job.revision, "", std::make_shared<const DeformResult>(std::move(result)), job.state});
      result = deformer->deformFrame(job.state->list, job.source, progress);
    }
    return result;
  }

  /// Looks at a result while its picture is drawn, and once more, with care, if nothing newer comes for a while.
  void lookAt(const LiveEvent& result)
  {
    if (result.deformation == nullptr) return;
    if (isWantedBefore(std::chrono::milliseconds(0)) && lastLook > kLookedShare * sinceLook) return;
    StoppableProgress progress([this] { return isWantedBefore(std::chrono::milliseconds(0)); },
                               [](std::string_view) {});
    try {
      const Clock::time_point start = Clock::now();
      tellReport(result.revision, deformer->checked(*result.deformation));
      lastLook = Clock::now() - start;
      sinceLook = Clock::duration(0);
      if (!isWantedBefore(kRest)) tellReport(result.revision, deformer->examined(*result.deformation, progress));
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception&) {
      deformer.reset();  // in whatever state it was left; the result is as good as before
    }
  }

  void tellReport(std::uint64_t revision, Report report)
  {
    tell({Kind::Examined, revision, "", nullptr, nullptr, std::make_shared<const Report>(std::move(report))});
  }

  /// Tells whether there is other work, or comes within `time`.
  bool isWantedBefore(std::chrono::milliseconds time)
  {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, time, [this] { return isStopping || waiting.has_value(); });
  }

  /// Tells whether more iterations make the result of a frame better, and nothing newer waits.
  bool isToGoOn(const DeformResult& result)
  {
    const std::optional<RotationIterations>& iterations = result.report.solve.iterations;
    if (!iterations || iterations->isConverged || result.report.solve.status == SolveStatus::Failed) return false;
    const std::scoped_lock lock(mutex);
    return !waiting;
  }

  void tell(const LiveEvent& event)
  {
    const std::scoped_lock lock(telling);
    if (listener) listener(event);
  }

  StopRequest stopRequest()
  {
    const std::scoped_lock lock(mutex);
    return isStopping ? StopRequest::GiveUp : request;
  }

  const std::shared_ptr<const Model> model;

  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  std::optional<Job> waiting;
  bool isUnseen = false;                    // the last result is of a frame, and not seen
  bool isStopping = false;                  // the owner is gone
  StopRequest request = StopRequest::GoOn;  // of the work under way

  std::mutex telling;  // held while the listener is called: its owner waits for that alone
  Listener listener;

  // The worker's own.
  std::unique_ptr<Deformer> deformer;
  DeformOptions deformerOptions;
  std::chrono::duration<double> lastLook{0};   // how long it took
  std::chrono::duration<double> sinceLook{0};  // what results have taken since
};

LiveDeformer::LiveDeformer(std::shared_ptr<const Model> model, Listener listener)
    : shared_(std::make_shared<Shared>(std::move(model), std::move(listener)))
{
  startBackgroundThread([shared = shared_] {
    computeInBackground();
    shared->run();
  });
}

LiveDeformer::~LiveDeformer()
{
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->isStopping = true;
  }
  shared_->changed.notify_all();
  {
    const std::scoped_lock lock(shared_->telling);
    shared_->listener = nullptr;
  }
}

void LiveDeformer::submit(std::uint64_t revision, std::shared_ptr<const DocumentState> state, std::string source,
                          Supersede supersede)
{
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->waiting = Shared::Job{revision, std::move(state), std::move(source), supersede, false};
    if (supersede == Supersede::AtNextStep && shared_->request == Shared::StopRequest::GoOn)
      shared_->request = Shared::StopRequest::GiveUp;
  }
  shared_->changed.notify_all();
}

void LiveDeformer::cancel()
{
  const std::scoped_lock lock(shared_->mutex);
  if (shared_->waiting) shared_->waiting->isCancelled = true;
  if (shared_->request == Shared::StopRequest::GoOn) shared_->request = Shared::StopRequest::GiveUpAndTell;
}

void LiveDeformer::resultIsSeen()
{
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->isUnseen = false;
  }
  shared_->changed.notify_all();
}

}  // namespace holdfast
