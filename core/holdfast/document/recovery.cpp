#include "holdfast/document/recovery.h"

#include <cstdlib>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <holdfast/io/files/output_file.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;

// Each document has a folder of its own, so that nothing of it stays behind, not even a copy that was cut short.
constexpr const char* kLockName = "lock";
constexpr const char* kCopyName = "copy.holdfast";

[[noreturn]] void fail(const fs::path& path, int code)
{
  throw OutputError(path.string(), fmt::format("no copy against a crash can be kept here ({}); save the session, and "
                                               "check the permissions and the space there",
                                               std::error_code(code, std::generic_category()).message()));
}

/// Makes `folder` and what is above it, for this user alone where it is new.
void makeFolder(const fs::path& folder)
{
  std::error_code error;
  const bool isNew = fs::create_directories(folder, error);
  if (error) fail(folder, error.value());
  if (isNew) fs::permissions(folder, fs::perms::owner_all, error);
}

fs::path newPlace(const fs::path& folder)
{
  makeFolder(folder);
  std::random_device random;
  fs::path place = folder / fmt::format("{:08x}{:08x}", random(), random());
  std::error_code error;
  if (!fs::create_directory(place, error)) fail(place, error ? error.value() : EEXIST);
  fs::permissions(place, fs::perms::owner_all, error);
  return place;
}

/// The open file, locked: programs that look whether it is locked hold their own locks for a moment only.
FileDescriptor lockedFile(const fs::path& path)
{
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (!file.isOpen()) fail(path, errno);
  while (::flock(file.get(), LOCK_EX) != 0)
    if (errno != EINTR) fail(path, errno);
  return file;
}

/// Tells whether no program holds the lock. Shared, so that two that look at once do not take one another for its
/// owner.
bool isAbandoned(const fs::path& place)
{
  const FileDescriptor file(::open((place / kLockName).c_str(), O_RDWR | O_CLOEXEC));
  if (!file.isOpen()) return errno == ENOENT;
  return ::flock(file.get(), LOCK_SH | LOCK_NB) == 0;
}

std::optional<fs::path> fromEnvironment(const char* variable)
{
  const char* const value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

fs::path absoluteMesh(const MeshReference& mesh, const fs::path& originalPath)
{
  if (!mesh.absolutePath.empty()) return mesh.absolutePath;
  return fs::absolute(originalPath.parent_path() / mesh.path).lexically_normal();
}

Recoverable described(const fs::path& path)
{
  Recoverable copy;
  copy.path = path;
  std::error_code ignored;
  if (const fs::file_time_type time = fs::last_write_time(path, ignored); !ignored)
    copy.time =
        std::chrono::time_point_cast<std::chrono::system_clock::duration>(fs::file_time_type::clock::to_sys(time));
  try {
    const SessionFile session = readSession(path);
    copy.original = session.original;
    copy.mesh = session.mesh.path;
  } catch (const InputError&) {
    copy.name = path.filename().string();  // opening it says what is wrong with it
    return copy;
  }
  copy.name = (copy.original.empty() ? copy.mesh : copy.original).filename().string();
  return copy;
}

}  // namespace

std::optional<fs::path> recoveryFolder()
{
  std::optional<fs::path> state = fromEnvironment("XDG_STATE_HOME");
  if (const auto home = fromEnvironment("HOME"); !state && home) state = *home / ".local" / "state";
  if (!state) return std::nullopt;
  return *state / "holdfast" / "recovery";
}

void RecoveryFile::write(SessionFile session, const fs::path& originalPath)
{
  session.original = originalPath.empty() ? "" : fs::absolute(originalPath).lexically_normal().generic_string();
  session.mesh.path = absoluteMesh(session.mesh, originalPath).generic_string();
  session.mesh.absolutePath.clear();
  const std::string text = sessionToJson(session);
  std::error_code ignored;
  if (place_.empty() || !fs::exists(place_, ignored)) {  // the folder may have been removed
    const fs::path place = newPlace(folder_);
    lock_ = lockedFile(place / kLockName);
    place_ = place;
  }
  OutputFile(place_ / kCopyName, text).commit();
}

void RecoveryFile::clear() noexcept
{
  if (place_.empty()) return;
  // The copy goes before the lock: without one it would look abandoned.
  std::error_code ignored;
  fs::remove(place_ / kCopyName, ignored);
  fs::remove_all(place_, ignored);
  place_.clear();
  static_cast<void>(lock_.close());
}

std::vector<Recoverable> recoverable(const fs::path& folder)
{
  std::vector<Recoverable> copies;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    const fs::path copy = entry->path() / kCopyName;
    if (fs::is_regular_file(copy, ignored) && isAbandoned(entry->path())) copies.push_back(described(copy));
  }
  std::sort(copies.begin(), copies.end(), [](const Recoverable& a, const Recoverable& b) {
    return std::pair(b.time, b.path) < std::pair(a.time, a.path);
  });
  return copies;
}

void discard(const Recoverable& copy) noexcept
{
  std::error_code ignored;
  if (copy.path.filename() == kCopyName) fs::remove_all(copy.path.parent_path(), ignored);
}

}  // namespace holdfast
