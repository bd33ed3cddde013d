#include "holdfast/base/retired_threads.h"

#include <algorithm>
#include <utility>

namespace holdfast {

RetiredThreads::~RetiredThreads()
{
  // A thread may leave another one behind before it ends.
  while (std::optional<std::thread> thread = takeOne()) thread->join();
}

std::optional<std::thread> RetiredThreads::takeOne()
{
  const std::scoped_lock lock(mutex_);
  if (threads_.empty()) return std::nullopt;
  std::optional<std::thread> thread = std::move(threads_.back().thread);
  threads_.pop_back();
  return thread;
}

void RetiredThreads::add(std::thread thread, std::shared_ptr<const std::atomic<bool>> hasEnded)
{
  const std::scoped_lock lock(mutex_);
  threads_.push_back({std::move(thread), std::move(hasEnded)});
  const auto ended = std::stable_partition(threads_.begin(), threads_.end(),
                                           [](const Retired& retired) { return !retired.hasEnded->load(); });
  std::for_each(ended, threads_.end(), [](Retired& retired) { retired.thread.join(); });
  threads_.erase(ended, threads_.end());
}

RetiredThreads& retiredThreads()
{
  static RetiredThreads threads;
  return threads;
}

}  // namespace holdfast
