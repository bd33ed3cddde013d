#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/document/live_deformer.h>

namespace holdfast {
namespace {

/// Threads whose owners are gone may still be inside a factorisation: the program waits for them at its end, so that
/// none runs while its memory is torn down.
class RetiredThreads {
 public:
  ~RetiredThreads()
  {
    for (std::thread& thread : threads_) thread.join();
  }

  void add(std::thread thread)
  {
    const std::scoped_lock lock(mutex_);
    threads_.push_back(std::move(thread));
  }

 private:
  std::mutex mutex_;
  std::vector<std::thread> threads_;
};

RetiredThreads& retiredThreads()
{
  static RetiredThreads threads;
  return threads;
}

struct Job {
  std::uint64_t revision = 0;
  std::shared_ptr<const DocumentState> state;
  std::string source;
};

class StoppableProgress final : public Progress {
 public:
  StoppableProgress(std::function<bool()> isUnwanted, std::function<void(std::string_view)> tell)
      : isUnwanted_(std::move(isUnwanted)), tell_(std::move(tell))
  {
  }

  void stage(std::string_view description) override
  {
    if (isUnwanted_()) throw Cancelled();
    tell_(description);
  }

 private:
  std::function<bool()> isUnwanted_;
  std::function<void(std::string_view)> tell_;
};

}  // namespace

struct LiveDeformer::Shared {
  explicit Shared(std::shared_ptr<const Model> itsModel, Listener itsListener)
      : model(std::move(itsModel)), listener(std::move(itsListener))
  {
  }

  void run();
  std::optional<Job> nextJob();
  void work(const Job& job);
  void tell(const LiveEvent& event);

  const std::shared_ptr<const Model> model;
  std::thread thread;

  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  std::optional<Job> waiting;
  bool isStopping = false;    // the owner is gone
  bool isCancelled = false;   // the owner wants the work under way to stop
  bool isSuperseded = false;  // a newer state wants it to stop

  std::mutex telling;  // held while the listener is called: its owner waits for that alone
  Listener listener;

  // The worker's own.
  std::unique_ptr<Deformer> deformer;
  DeformOptions deformerOptions;
};

void LiveDeformer::Shared::tell(const LiveEvent& event)
{
  const std::scoped_lock lock(telling);
  if (listener) listener(event);
}

std::optional<Job> LiveDeformer::Shared::nextJob()
{
  std::unique_lock lock(mutex);
  changed.wait(lock, [this] { return isStopping || waiting; });
  if (isStopping) return std::nullopt;
  isCancelled = false;
  isSuperseded = false;
  return std::exchange(waiting, std::nullopt);
}

void LiveDeformer::Shared::run()
{
  while (const auto job = nextJob()) work(*job);
  deformer.reset();
}

void LiveDeformer::Shared::work(const Job& job)
{
  using Kind = LiveEvent::Kind;
  StoppableProgress progress(
      [this] {
        const std::scoped_lock lock(mutex);
        return isStopping || isCancelled || isSuperseded;
      },
      [&](std::string_view stage) {
        tell({Kind::Stage, job.revision, std::string(stage), nullptr});
      });
  tell({Kind::Started, job.revision, "", nullptr});
  try {
    if (deformer == nullptr || deformerOptions != job.state->options) {
      deformer = std::make_unique<Deformer>(*model, job.state->options);
      deformerOptions = job.state->options;
    }
    auto result = std::make_shared<const Deformation>(deformer->deform(job.state->list, job.source, progress));
    tell({Kind::Done, job.revision, "", std::move(result)});
  } catch (const Cancelled&) {
    const bool isTold = [this] {
      const std::scoped_lock lock(mutex);
      return isCancelled;
    }();
    if (isTold) tell({Kind::Cancelled, job.revision, "", nullptr});
  } catch (const InputError& error) {
    tell({Kind::Unusable, job.revision, error.what(), nullptr});
  } catch (const std::exception& error) {
    tell({Kind::Broken, job.revision, error.what(), nullptr});
  }
}

LiveDeformer::LiveDeformer(std::shared_ptr<const Model> model, Listener listener)
    : shared_(std::make_shared<Shared>(std::move(model), std::move(listener)))
{
  // The list of retired threads is made before the first of them, so that it outlives all.
  retiredThreads();
  shared_->thread = std::thread([shared = shared_] { shared->run(); });
}

LiveDeformer::~LiveDeformer()
{
  {
    const std::scoped_lock lock(shared_->telling);
    shared_->listener = nullptr;
  }
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->isStopping = true;
  }
  shared_->changed.notify_all();
  retiredThreads().add(std::move(shared_->thread));
}

void LiveDeformer::submit(std::uint64_t revision, std::shared_ptr<const DocumentState> state, std::string source,
                          Supersede supersede)
{
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->waiting = Job{revision, std::move(state), std::move(source)};
    if (supersede == Supersede::AtNextStage) shared_->isSuperseded = true;
  }
  shared_->changed.notify_all();
}

void LiveDeformer::cancel()
{
  const std::scoped_lock lock(shared_->mutex);
  shared_->waiting.reset();
  shared_->isCancelled = true;
}

}  // namespace holdfast
