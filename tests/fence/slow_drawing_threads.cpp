#include "slow_drawing_threads.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <string_view>
#include <thread>

#include <dlfcn.h>
#include <pthread.h>

namespace holdfast::test {
namespace {

std::atomic<std::chrono::microseconds> heldUpFor{};
std::atomic<long> heldUp = 0;
std::atomic<long> destroyedWhileHeld = 0;

bool isDrawingThread()
{
  std::array<char, 16> name{};
  return ::pthread_getname_np(::pthread_self(), name.data(), name.size()) == 0 &&
         std::string_view(name.data()).starts_with("llvmpipe-");
}

/// The function of the system that one below stands before. glibc has an older condition variable under the same name.
template <class Function>
Function* systemFunction(const char* name)
{
  void* found = ::dlvsym(RTLD_NEXT, name, "GLIBC_2.3.2");
  return reinterpret_cast<Function*>(found != nullptr ? found : ::dlsym(RTLD_NEXT, name));
}

}  // namespace

void holdUpDrawingThreads(std::chrono::microseconds time)
{
  heldUpFor = time;
}

long drawingThreadsHeldUp()
{
  return heldUp;
}

long locksDestroyedWhileHeld()
{
  return destroyedWhileHeld;
}

}  // namespace holdfast::test

// The linker takes those of the program before those of the system's libraries, for Mesa as well.

extern "C" __attribute__((visibility("default"))) int pthread_cond_broadcast(pthread_cond_t* condition) noexcept
{
  using namespace holdfast::test;
  static auto* const kBroadcast = systemFunction<int(pthread_cond_t*)>("pthread_cond_broadcast");
  const int result = kBroadcast(condition);
  const std::chrono::microseconds time = heldUpFor;
  if (time.count() > 0 && isDrawingThread()) {
    ++heldUp;
    std::this_thread::sleep_for(time);
  }
  return result;
}

extern "C" __attribute__((visibility("default"))) int pthread_mutex_destroy(pthread_mutex_t* mutex) noexcept
{
  using namespace holdfast::test;
  static auto* const kDestroy = systemFunction<int(pthread_mutex_t*)>("pthread_mutex_destroy");
  const int result = kDestroy(mutex);
  if (result != EBUSY) return result;
  ++destroyedWhileHeld;
  ::pthread_mutex_lock(mutex);
  ::pthread_mutex_unlock(mutex);
  return kDestroy(mutex);
}
