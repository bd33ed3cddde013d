#include "support/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
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
    closeReading();
    closeWriting();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeReading()
  {
    if (reading >= 0) ::close(reading);
    reading = -1;
  }
  void closeWriting()
  {
    if (writing >= 0) ::close(writing);
    writing = -1;
  }

  int reading = -1;
  int writing = -1;
};

/// What the program is to have open, by `posix_spawn`.
class Streams {
 public:
  Streams(const ProcessOptions& options, int out, int err)
  {
    check(::posix_spawn_file_actions_init(&actions_));
    check(::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0));
    send(STDOUT_FILENO, options.outPath, out);
    send(STDERR_FILENO, options.errPath, err);
  }
  ~Streams() { ::posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* get() const noexcept { return &actions_; }

 private:
  /// Makes `stream` go to the file at `path`, or into `pipe` where there is no path.
  void send(int stream, const std::string& path, int pipe)
  {
    check(path.empty() ? ::posix_spawn_file_actions_adddup2(&actions_, pipe, stream)
                       : ::posix_spawn_file_actions_addopen(&actions_, stream, path.c_str(), O_WRONLY, 0));
  }
  static void check(int error)
  {
    if (error != 0) throw std::system_error(error, std::generic_category(), "posix_spawn");
  }

  posix_spawn_file_actions_t actions_{};
};

/// `command` under the limits that `options` ask for.
std::vector<std::string> limited(const std::vector<std::string>& command, const ProcessOptions& options)
{
  std::vector<std::string> words;
  if (options.largestFile) words = {"prlimit", "--fsize=" + std::to_string(*options.largestFile), "--"};
  if (options.addressSpace)
    words.insert(words.end(), {"prlimit", "--as=" + std::to_string(*options.addressSpace), "--"});
  // Root stays root, but without the capability to ignore permissions once it has become another program.
  if (options.obeysPermissions && ::geteuid() == 0)
    words.insert(words.end(), {"setpriv", "--bounding-set=-dac_override", "--"});
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

/// Starts the program. Not by `fork`, before which libraries tidy up: that of OpenBLAS ends its threads, and a
/// factorisation that is under way on another thread waits for them for ever.
pid_t start(const std::vector<std::string>& command, const ProcessOptions& options, int out, int err)
{
  std::vector<std::string> words = limited(command, options);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const Streams streams(options, out, err);
  pid_t child = 0;
  if (const int error = ::posix_spawnp(&child, arguments[0], streams.get(), nullptr, arguments.data(), environ))
    throw std::system_error(error, std::generic_category(), words[0]);
  return child;
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
  Pipe out;
  Pipe err;
  if (options.isOutUnread) out.closeReading();
  const pid_t child = start(command, options, out.writing, err.writing);
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
