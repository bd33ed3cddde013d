#include "support/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace holdfast::test {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void throwErrno(const char* what)
{
  throw std::system_error(errno, std::generic_category(), what);
}

/// Both ends of a pipe that is not inherited by programs.
struct Pipe {
  Pipe()
  {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throwErrno("pipe2");
    reading = ends[0];
    writing = ends[1];
  }
  ~Pipe()
  {
    ::close(reading);
    closeWriting();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeWriting()
  {
    if (writing >= 0) ::close(writing);
    writing = -1;
  }

  int reading = -1;
  int writing = -1;
};

bool limitFiles(const ProcessOptions& options)
{
  if (!options.largestFile) return true;
  const rlimit limit{static_cast<rlim_t>(*options.largestFile), static_cast<rlim_t>(*options.largestFile)};
  return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

/// Root stays root, but without the capability to ignore permissions once it has become another program.
bool submitToPermissions(const ProcessOptions& options)
{
  return !options.obeysPermissions || ::geteuid() != 0 || ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0) == 0;
}

/// Makes `stream` go to the file at `path`, or into `pipe` where there is no path.
bool redirect(int stream, const std::string& path, int pipe)
{
  const int file = path.empty() ? pipe : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  return file >= 0 && ::dup2(file, stream) >= 0;
}

/// Between fork and exec nothing may allocate: `arguments` is made before.
[[noreturn]] void becomeProgram(char* const* arguments, const ProcessOptions& options, int out, int err)
{
  const int nothing = ::open("/dev/null", O_RDONLY);
  const bool isReady = nothing >= 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                       redirect(STDOUT_FILENO, options.outPath, out) && redirect(STDERR_FILENO, options.errPath, err) &&
                       limitFiles(options) && submitToPermissions(options);
  if (isReady) ::execv(arguments[0], arguments);
  ::_exit(kNotStarted);
}

/// Appends what there is to read; false at the end.
bool takeFrom(int file, std::string& text)
{
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(file, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

/// Reads both streams to their ends, sends the signal that was asked for, and kills what takes too long.
void follow(pid_t child, const ProcessOptions& options, int out, int err, ProcessResult& result)
{
  const auto deadline = Clock::now() + options.timeout;
  bool isSignalDue = options.signal != 0;
  std::array<pollfd, 2> files{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    const int ready = ::poll(files.data(), files.size(), static_cast<int>(std::max<long>(left, 0)));
    if (ready == 0) {
      result.isTimedOut = true;
      ::kill(child, SIGKILL);
      return;
    }
    if (ready < 0) continue;
    if (files[0].revents != 0 && !takeFrom(out, result.out)) files[0].fd = -1;
    if (files[1].revents != 0 && !takeFrom(err, result.err)) files[1].fd = -1;
    if (isSignalDue && result.err.find(options.signalAt) != std::string::npos) {
      ::kill(child, options.signal);
      isSignalDue = false;
    }
  }
}

}  // namespace

ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options)
{
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Pipe out;
  Pipe err;
  const pid_t child = ::fork();
  if (child < 0) throwErrno("fork");
  if (child == 0) becomeProgram(arguments.data(), options, out.writing, err.writing);
  out.closeWriting();
  err.closeWriting();

  ProcessResult result;
  follow(child, options, out.reading, err.reading, result);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throwErrno("waitpid");
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

}  // namespace holdfast::test
