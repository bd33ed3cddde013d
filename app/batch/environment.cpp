// What the C library and OpenBLAS read from the environment before `main`.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace holdfast::batch {
namespace {

struct Variable {
  const char* text;  // NAME=value
  bool isUsers;      // a value that is there already stays

  [[nodiscard]] std::string_view name() const
  {
    const std::string_view whole = text;
    return whole.substr(0, whole.find('=') + 1);
  }
};

constexpr std::array kVariables{
    // All that is ever used. Where the address space is limited and too little, OpenBLAS asks for more for ever, in
    // every thread that it starts, and the program cannot end.
    Variable{"OPENBLAS_NUM_THREADS=1", false},
    // To take pages of 4 KiB is up to a quarter of a run. What one thread has freed serves all: with a heap for each,
    // memory grows by an eighth.
    Variable{"GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.arena_max=1", true}};

constexpr rlim_t kMebibyte = 1U << 20U;

// Of a file. With less to read, what is won by pages of 2 MiB is lost by beginning anew.
constexpr off_t kMuch = kMebibyte / 2;

// Two pieces of 128 MiB, which OpenBLAS 0.3.29 takes even for one thread, and what libraries need to begin with.
constexpr rlim_t kRoom = 288 * kMebibyte;

// Exit code: numerical failures, and too little memory for them.
constexpr int kOutOfMemory = 5;

bool hasRoom()
{
  void* const room = ::mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, kRoom);
  return true;
}

/// Ends the program where it is limited to less than libraries need.
bool isAddressSpaceLimited()
{
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  if (hasRoom()) return true;
  ::dprintf(STDERR_FILENO,
            "holdfast-batch: error: there is not enough memory to begin: the address space is limited to %llu MiB "
            "(ulimit -v); allow 500 or more\n",
            static_cast<unsigned long long>(limit.rlim_cur / kMebibyte));
  ::_exit(kOutOfMemory);
}

bool isLargeFile(const char* path)
{
  struct stat about {};
  return ::stat(path, &about) == 0 && about.st_size > kMuch;
}

/// Begins the program anew with these variables; if that fails, goes on as it is.
void setEnvironment(int argc, char** argv, char** environment)
{
  if (!isAddressSpaceLimited() && std::none_of(argv + 1, argv + std::max(argc, 1), isLargeFile)) return;
  std::vector<char*> changed;
  for (char** entry = environment; *entry != nullptr; ++entry) changed.push_back(*entry);
  bool isChanged = false;
  for (const Variable& variable : kVariables) {
    const auto found = std::ranges::find_if(
        changed, [&](const char* entry) { return std::string_view(entry).starts_with(variable.name()); });
    if (found != changed.end() && (variable.isUsers || variable.text == std::string_view(*found))) continue;
    if (found != changed.end()) changed.erase(found);
    changed.push_back(const_cast<char*>(variable.text));
    isChanged = true;
  }
  if (!isChanged) return;
  changed.push_back(nullptr);
  ::execve("/proc/self/exe", argv, changed.data());
}

// Runs before the constructors of all libraries.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeLibraries)(int, char**, char**) = setEnvironment;

}  // namespace
}  // namespace holdfast::batch
