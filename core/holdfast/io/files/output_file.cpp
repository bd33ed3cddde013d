#include "holdfast/io/files/output_file.h"

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <optional>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <holdfast/io/files/file_descriptor.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

enum class SlotState { Free, Claimed, Tracked };

struct Slot {
  std::atomic<SlotState> state{SlotState::Free};
  std::array<char, PATH_MAX> path{};
};

// A signal handler may neither lock nor allocate: fixed storage, and states that change in one step.
static_assert(std::atomic<SlotState>::is_always_lock_free);
std::array<Slot, kTrackedOutputs> slots;

/// The slot of `path`; -1 where all are taken or the path is too long. Thread-safe.
int trackUnfinishedFile(const std::string& path) noexcept
{
  if (path.size() >= PATH_MAX) return -1;
  for (int i = 0; i < kTrackedOutputs; ++i) {
    SlotState expected = SlotState::Free;
    if (!slots[i].state.compare_exchange_strong(expected, SlotState::Claimed)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state = SlotState::Tracked;
    return i;
  }
  return -1;
}

namespace fs = std::filesystem;

using FileInfo = struct stat;

constexpr mode_t kPermissionBits = 07777;

const char* remedy(int code)
{
  if (code == ENOENT || code == ENOTDIR) return "make the folder first, or name another";
  if (code == EACCES || code == EPERM || code == EROFS) return "change the permissions, or write to another folder";
  if (code == ENOSPC || code == EDQUOT) return "free some space, or write to another disk";
  if (code == EFBIG) return "raise the limit on the size of files (ulimit -f)";
  if (code == ENAMETOOLONG) return "choose a shorter name";
  if (code == ELOOP) return "the symbolic links lead in a circle; remove one";
  if (code == EPIPE) return "the reader of the pipe has closed it; let it read to the end";
  return "nothing was changed; try another place";
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, int code)
{
  throw OutputError(path.string(), fmt::format("{} ({}): {}", what, std::strerror(code), remedy(code)));
}

std::optional<FileInfo> infoOf(const fs::path& path)
{
  FileInfo info{};
  if (::stat(path.c_str(), &info) != 0) return std::nullopt;
  return info;
}

/// Standard output or standard error, where `file` is what it goes to; -1 otherwise. A rename would put another file
/// in its place, and what the program still writes to the stream would be lost.
int standardStream(const FileInfo& file)
{
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    FileInfo info{};
    if (::fstat(stream, &info) == 0 && info.st_dev == file.st_dev && info.st_ino == file.st_ino) return stream;
  }
  return -1;
}

/// The end need not exist.
fs::path withLinksFollowed(const fs::path& path)
{
  constexpr int kMostLinks = 40;  // as many as Linux follows
  fs::path end = path;
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code error;
    const fs::path next = fs::read_symlink(end, error);
    if (error) return end;
    end = next.is_absolute() ? next : end.parent_path() / next;
  }
  fail(path, "cannot be written", ELOOP);
}

constexpr std::string_view kTemporaryBegin = ".part";
constexpr std::size_t kTemporaryDigits = 16;

/// A name in `folder` that no other program will think of. Short, so that no name of a file makes it too long.
fs::path temporaryName(const fs::path& folder, const fs::path& extension)
{
  constexpr std::size_t kLongestExtension = 16;
  std::random_device random;
  return folder / fmt::format("{}{}.{:08x}{:08x}", kTemporaryBegin, extension.string().substr(0, kLongestExtension),
                              random(), random());
}

bool isTemporaryName(const std::string& name)
{
  const std::size_t dot = name.rfind('.');
  return name.starts_with(kTemporaryBegin) && name.size() - dot == 1 + kTemporaryDigits &&
         name.find_first_not_of("0123456789abcdef", dot + 1) == std::string::npos;
}

/// Removes the temporary files of programs that were killed. Without locks in the file system they stay.
void removeAbandoned(const fs::path& folder)
{
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!isTemporaryName(entry->path().filename().string())) continue;
    const FileDescriptor file(::open(entry->path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file.isOpen() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(entry->path().c_str());
  }
}

/// Locks a new temporary file. False where another program has taken it for an abandoned one before; it holds the lock
/// until it has removed the file.
bool isKept(const FileDescriptor& file)
{
  while (::flock(file.get(), LOCK_EX) != 0 && errno == EINTR) {
  }
  FileInfo info{};
  return ::fstat(file.get(), &info) != 0 || info.st_nlink > 0;
}

FileDescriptor openDirect(const fs::path& path)
{
  const std::optional<FileInfo> info = infoOf(path);
  const int stream = info ? standardStream(*info) : -1;
  // A duplicate goes on where the stream is; the file opened anew would be written from its beginning.
  return FileDescriptor(stream >= 0 ? ::dup(stream) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
}

/// Gives a new file the permissions of the one that it replaces, and its owner if this is root.
int takeOver(const FileDescriptor& file, const FileInfo& replaced)
{
  static_cast<void>(::fchown(file.get(), replaced.st_uid, replaced.st_gid) == 0);  // not to be ignored otherwise
  return ::fchmod(file.get(), replaced.st_mode & kPermissionBits) == 0 ? 0 : errno;
}

/// 0, or the errno of the first step that failed. `replaced`: the file that stood at the target, if any.
int writeAndFlush(const FileDescriptor& file, std::string_view bytes, const std::optional<FileInfo>& replaced)
{
  int code = replaced ? takeOver(file, *replaced) : 0;
  if (code == 0) code = writeAll(file, bytes);
  // EINVAL: the file system cannot flush single files.
  if (code == 0 && ::fsync(file.get()) != 0 && errno != EINVAL) code = errno;
  // Some file systems tell of a full disk at a close. To close a duplicate keeps the lock.
  const int closing = FileDescriptor(::dup(file.get())).close();
  return code != 0 ? code : closing;
}

/// Makes the rename itself survive a power cut, where the file system can.
void flushFolder(const fs::path& folder)
{
  const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.isOpen()) ::fsync(descriptor.get());
}

}  // namespace

/// A file beside the target; gone with this, unless it was renamed.
struct OutputFile::Temporary {
  explicit Temporary(const fs::path& itsPath) : path(itsPath.string()), slot(trackUnfinishedFile(path)) {}
  ~Temporary()
  {
    ::unlink(path.c_str());
    if (slot >= 0) slots[slot].state = SlotState::Free;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  std::string path;     // absolute
  int slot;             // in the list of unfinished files
  FileDescriptor file;  // locked
};

OutputFile::OutputFile(fs::path path, std::string_view bytes) : path_(std::move(path))
{
  const std::optional<FileInfo> existing = infoOf(path_);
  if (existing && S_ISDIR(existing->st_mode)) throw OutputError(path_.string(), "is a directory: name a file in it");
  if (existing && (!S_ISREG(existing->st_mode) || standardStream(*existing) >= 0)) {
    direct_ = bytes;
    return;
  }
  if (existing && ::access(path_.c_str(), W_OK) != 0) fail(path_, "the file there must not be replaced", errno);
  std::error_code error;
  target_ = fs::absolute(withLinksFollowed(path_), error);
  if (error) fail(path_, "cannot be written", error.value());
  removeAbandoned(target_.parent_path());
  int code = openTemporary(existing.has_value());
  if (code == 0) code = writeAndFlush(temporary_->file, bytes, existing);
  if (code != 0) fail(path_, "cannot be written", code);
}

int OutputFile::openTemporary(bool isReplacing)
{
  // Others must not read the new contents of a protected file, not even for a moment.
  const mode_t permissions = isReplacing ? 0600 : 0666;
  do {
    temporary_ = std::make_unique<Temporary>(temporaryName(target_.parent_path(), target_.extension()));
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
    temporary_->file = FileDescriptor(::open(temporary_->path.c_str(), flags, permissions));
    if (!temporary_->file.isOpen()) return errno;
  } while (!isKept(temporary_->file));
  return 0;
}

OutputFile::~OutputFile() = default;
OutputFile::OutputFile(OutputFile&&) noexcept = default;

void OutputFile::commit()
{
  if (isDirect()) {
    FileDescriptor file = openDirect(path_);
    if (!file.isOpen()) fail(path_, "cannot be opened for writing", errno);
    if (const int code = writeAndClose(std::move(file), direct_); code != 0) fail(path_, "cannot be written", code);
    return;
  }
  const int code = ::rename(temporary_->path.c_str(), target_.c_str()) == 0 ? 0 : errno;
  temporary_.reset();
  if (code != 0) fail(path_, "cannot be put in place", code);
  flushFolder(target_.parent_path());
}

void removeUnfinishedOutputs() noexcept
{
  for (const Slot& slot : slots)
    if (slot.state == SlotState::Tracked) ::unlink(slot.path.data());
}

}  // namespace holdfast
