// OpenBLAS takes memory before `main`. Where the address space is limited (ulimit -v) and too little, it asks for more
// for ever, in every thread that it starts, and the program cannot end.

#include <cstdio>
#include <cstring>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace holdfast::batch {
namespace {

constexpr const char* kVariable = "OPENBLAS_NUM_THREADS=";
constexpr const char* kOneThread = "OPENBLAS_NUM_THREADS=1";

constexpr rlim_t kMebibyte = 1U << 20U;

// Two pieces of 128 MiB, which version 0.3.29 takes even for one thread, and what libraries need to begin with.
constexpr rlim_t kRoom = 288 * kMebibyte;

// Exit code: numerical failures, and too little memory for them.
constexpr int kOutOfMemory = 5;

rlim_t limitOfAddressSpace()
{
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

bool hasRoom()
{
  void* const room = ::mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, kRoom);
  return true;
}

[[noreturn]] void refuse(rlim_t limit)
{
  ::dprintf(STDERR_FILENO,
            "holdfast-batch: error: there is not enough memory to begin: the address space is limited to %llu MiB "
            "(ulimit -v); allow 500 or more\n",
            static_cast<unsigned long long>(limit / kMebibyte));
  ::_exit(kOutOfMemory);
}

/// Begins the program anew with OpenBLAS on one thread, all that it ever uses; if that fails, goes on as it is.
void keepBlasFromThreads(int /*argc*/, char** argv, char** environment)
{
  const rlim_t limit = limitOfAddressSpace();
  if (limit == RLIM_INFINITY) return;
  if (!hasRoom()) refuse(limit);
  std::vector<char*> changed;
  for (char** entry = environment; *entry != nullptr; ++entry) {
    if (std::strcmp(*entry, kOneThread) == 0) return;
    if (std::strncmp(*entry, kVariable, std::strlen(kVariable)) != 0) changed.push_back(*entry);
  }
  changed.push_back(const_cast<char*>(kOneThread));
  changed.push_back(nullptr);
  ::execve("/proc/self/exe", argv, changed.data());
}

// Runs before the constructors of all libraries.
[[gnu::section(".preinit_array"), gnu::used]] void (*const beforeLibraries)(int, char**, char**) = keepBlasFromThreads;

}  // namespace
}  // namespace holdfast::batch
