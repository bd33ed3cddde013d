#include "bench/paper/limited.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <new>
#include <system_error>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace holdfast::paper {
namespace {

constexpr rlim_t kGigabyte = 1'000'000'000;

[[noreturn]] void fail(const char* what)
{
  throw std::system_error(errno, std::generic_category(), what);
}

/// Memory that this process and its copies share.
class SharedBytes {
 public:
  explicit SharedBytes(std::size_t size)
      : size_(size), data_(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if (data_ == MAP_FAILED) fail("memory for the result of another process");
  }
  ~SharedBytes() { munmap(data_, size_); }
  SharedBytes(const SharedBytes&) = delete;
  SharedBytes& operator=(const SharedBytes&) = delete;

  [[nodiscard]] std::span<std::byte> bytes() const { return {static_cast<std::byte*>(data_), size_}; }

 private:
  std::size_t size_;
  void* data_;
};

void limit(int resource, rlim_t most, rlim_t grace = 0)
{
  const rlimit value{most, most + grace};
  if (setrlimit(resource, &value) != 0) _exit(static_cast<int>(Ending::Failed));
}

[[noreturn]] void runAndExit(const Limits& limits, std::span<std::byte> result,
                             const std::function<Ending(std::span<std::byte>)>& compute)
{
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds, 1);  // without grace it is SIGKILL that ends it, as where the system has no memory
  limit(RLIMIT_AS, limits.gigabytes * kGigabyte);
  try {
    _exit(static_cast<int>(compute(result)));
  } catch (const std::bad_alloc&) {
    _exit(static_cast<int>(Ending::LacksMemory));
  } catch (...) {
    _exit(static_cast<int>(Ending::Failed));
  }
}

/// What `wait` tells of an ended process.
std::string failureOf(int status, const Limits& limits)
{
  const auto hasEnded = [&](Ending ending) {
    return WIFEXITED(status) && WEXITSTATUS(status) == static_cast<int>(ending);
  };
  if (hasEnded(Ending::Done)) return "";
  if (hasEnded(Ending::LacksMemory)) return fmt::format("out of memory at {} GB", limits.gigabytes);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return fmt::format("stopped after {} s", limits.seconds);
  return "fails";
}

}  // namespace

std::string limited(const Limits& limits, std::span<std::byte> result,
                    const std::function<Ending(std::span<std::byte>)>& compute)
{
  const SharedBytes shared(result.size());
  const pid_t copy = fork();
  if (copy < 0) fail("another process");
  if (copy == 0) runAndExit(limits, shared.bytes(), compute);
  int status = 0;
  while (waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) fail("the end of another process");
  std::ranges::copy(shared.bytes(), result.begin());
  return failureOf(status, limits);
}

}  // namespace holdfast::paper
