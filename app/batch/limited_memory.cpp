// OpenBLAS starts threads before `main`. Each asks for memory for ever where the address space is limited (ulimit -v),
// and the program cannot end while one does.

#include <cstring>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

namespace holdfast::batch {
namespace {

constexpr const char* kVariable = "OPENBLAS_NUM_THREADS=";
constexpr const char* kOneThread = "OPENBLAS_NUM_THREADS=1";

bool isAddressSpaceLimited()
{
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// Begins the program anew with OpenBLAS on one thread, which is all that it ever uses. Where that cannot be done the
/// program goes on as it is.
void keepBlasFromThreads(int /*argc*/, char** argv, char** environment)
{
  if (!isAddressSpaceLimited()) return;
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
