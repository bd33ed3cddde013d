#include <cstddef>
#include <mutex>
#include <new>

#include <dlfcn.h>
#include <sys/mman.h>

#include <holdfast/threads/one_thread_internal.h>
#include <holdfast/threads/parallel.h>

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
  static auto* const kSet = loaded<void(int)>("omp_set_max_active_levels");
  if (kSet != nullptr) kSet(levels);
}

int activeLevels() noexcept
{
  static auto* const kGet = loaded<int()>("omp_get_max_active_levels");
  return kGet == nullptr ? 0 : kGet();
}

void requireRoom(std::size_t bytes)
{
  void* const room = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, bytes);
}

/// OpenBLAS gives memory back to itself, never to the system: one piece for each thread that computes at a time.
void takeBlasMemory()
{
  auto* const allocate = loaded<void*(int)>("blas_memory_alloc");
  auto* const free = loaded<void(void*)>("blas_memory_free");
  if (allocate == nullptr || free == nullptr) return;
  constexpr std::size_t kBlasMemory = std::size_t{144} << 20U;  // 128 MiB in one piece, and what malloc adds
  constexpr int kAnyPlace = 0;
  std::vector<void*> pieces(static_cast<std::size_t>(threadCount()));
  requireRoom(pieces.size() * kBlasMemory);
  for (void*& piece : pieces) piece = allocate(kAnyPlace);
  for (void* const piece : pieces) free(piece);
}

}  // namespace

OneThread::OneThread() : activeLevels_(activeLevels())
{
  static std::once_flag blas;
  std::call_once(blas, [] {
    if (auto* const set = loaded<void(int)>("openblas_set_num_threads")) set(1);
    takeBlasMemory();
  });
  setActiveLevels(0);
}

OneThread::~OneThread()
{
  setActiveLevels(activeLevels_);
}

}  // namespace holdfast
