#include <mutex>

#include <dlfcn.h>

#include <holdfast/base/one_thread_internal.h>

namespace holdfast {
namespace {

/// A function of a library that the program has loaded; null where there is none.
template <class Function>
Function* loaded(const char* name) noexcept
{
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

void setActiveLevels(int levels) noexcept
{
  static auto* const set = loaded<void(int)>("omp_set_max_active_levels");
  if (set != nullptr) set(levels);
}

int activeLevels() noexcept
{
  static auto* const get = loaded<int()>("omp_get_max_active_levels");
  return get == nullptr ? 0 : get();
}

}  // namespace

OneThread::OneThread() noexcept : activeLevels_(activeLevels())
{
  static std::once_flag blas;
  std::call_once(blas, [] {
    if (auto* const set = loaded<void(int)>("openblas_set_num_threads")) set(1);
  });
  setActiveLevels(0);
}

OneThread::~OneThread()
{
  setActiveLevels(activeLevels_);
}

}  // namespace holdfast
