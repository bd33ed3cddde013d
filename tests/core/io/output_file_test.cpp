#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <holdfast/io/files/output_file.h>
#include <holdfast/words/error.h>

#include "support/temporary_folder.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using test::bytesOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

mode_t permissionsOf(const fs::path& path)
{
  struct stat info = {};
  EXPECT_EQ(::stat(path.c_str(), &info), 0);
  return info.st_mode & 07777;
}

/// What `OutputError` says when `bytes` are written to `path`; "written" where it does not come.
std::string complaint(const fs::path& path, std::string_view bytes)
{
  try {
    OutputFile(path, bytes).commit();
    return "written";
  } catch (const OutputError& error) {
    return error.what();
  }
}

/// Tells whether `holds` is true in a child process, whose limits and user are its own.
bool holdsInChild(const std::function<bool()>& holds)
{
  const pid_t child = ::fork();
  if (child == 0) ::_exit(holds() ? 0 : 1);
  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Gives up the rights of root, for whom no file is read-only. Meant for a child process.
bool becomeNobody()
{
  constexpr uid_t kNobody = 65534;
  return ::geteuid() != 0 || ::setuid(kNobody) == 0;
}

class OutputFileTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(OutputFileTest, NothingStandsAtThePathBeforeCommit)
{
  OutputFile output(folder_.path() / "a.obj", "bytes");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.obj"));
  output.commit();
  EXPECT_EQ(bytesOf(folder_.path() / "a.obj"), "bytes");
  EXPECT_THAT(folder_.names(), ElementsAre("a.obj"));
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStays)
{
  const fs::path path = folder_.file("a.obj", "old");
  {
    const OutputFile output(path, "new");
  }
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_THAT(folder_.names(), ElementsAre("a.obj"));
}

TEST_F(OutputFileTest, AMovedFromOutputRemovesNothing)
{
  OutputFile first(folder_.path() / "a", "bytes");
  OutputFile second(std::move(first));
  second.commit();
  EXPECT_EQ(bytesOf(folder_.path() / "a"), "bytes");
}

TEST_F(OutputFileTest, AReaderOfTheOldFileKeepsIt)
{
  const fs::path path = folder_.file("a", "old");
  std::ifstream reader(path);
  OutputFile(path, "new").commit();
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_F(OutputFileTest, PermissionsOfTheReplacedFileAreKept)
{
  const fs::path path = folder_.file("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  OutputFile(path, "new").commit();
  EXPECT_EQ(permissionsOf(path), 0640U);
}

TEST_F(OutputFileTest, ANewFileFollowsTheUmask)
{
  const mode_t before = ::umask(027);
  OutputFile(folder_.path() / "a", "new").commit();
  ::umask(before);
  EXPECT_EQ(permissionsOf(folder_.path() / "a"), 0640U);
}

TEST_F(OutputFileTest, SymbolicLinksAreFollowed)
{
  fs::create_directory(folder_.path() / "data");
  const fs::path file = folder_.file("data/a.obj", "old");
  fs::create_symlink("data/a.obj", folder_.path() / "link");
  fs::create_symlink("link", folder_.path() / "link to link");
  OutputFile(folder_.path() / "link to link", "new").commit();
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_EQ(bytesOf(file), "new");
}

TEST_F(OutputFileTest, AFileIsMadeAtTheEndOfADanglingLink)
{
  fs::create_symlink("later.obj", folder_.path() / "link");
  OutputFile(folder_.path() / "link", "new").commit();
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_EQ(bytesOf(folder_.path() / "later.obj"), "new");
}

TEST_F(OutputFileTest, LinksInACircleAreNamed)
{
  fs::create_symlink("b", folder_.path() / "a");
  fs::create_symlink("a", folder_.path() / "b");
  EXPECT_THAT(complaint(folder_.path() / "a", "x"), HasSubstr("symbolic links lead in a circle"));
}

TEST_F(OutputFileTest, AMissingFolderIsNamed)
{
  const fs::path path = folder_.path() / "none" / "a.obj";
  EXPECT_EQ(complaint(path, "x"), path.string() +
                                      ": cannot be written (No such file or directory): make the folder first, or "
                                      "name another");
}

TEST_F(OutputFileTest, ADirectoryIsRefused)
{
  EXPECT_THAT(complaint(folder_.path(), "x"), HasSubstr("is a directory: name a file in it"));
}

TEST_F(OutputFileTest, WhatCannotBePutInPlaceIsRemoved)
{
  OutputFile output(folder_.path() / "a", "x");
  fs::create_directory(folder_.path() / "a");
  EXPECT_THROW(output.commit(), OutputError);
  EXPECT_THAT(folder_.names(), ElementsAre("a"));
}

TEST_F(OutputFileTest, TheLongestNameIsWritten)
{
  const fs::path path = folder_.path() / (std::string(251, 'n') + ".obj");
  EXPECT_EQ(complaint(path, "x"), "written");
  EXPECT_THAT(complaint(folder_.path() / std::string(256, 'n'), "x"), HasSubstr("choose a shorter name"));
  EXPECT_EQ(folder_.names().size(), 1U);
}

TEST_F(OutputFileTest, AReadOnlyFileIsNotReplaced)
{
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  const fs::path path = folder_.file("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  EXPECT_TRUE(holdsInChild([&] {
    return becomeNobody() && complaint(path, "new").find("must not be replaced (Permission denied)") < 1000;
  }));
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_THAT(folder_.names(), ElementsAre("a"));
}

TEST_F(OutputFileTest, AFolderThatIsNotWritableIsNamed)
{
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0555), 0);
  EXPECT_TRUE(holdsInChild([&] {
    const std::string message = becomeNobody() ? complaint(folder_.path() / "a", "new") : "";
    return message.find("cannot be written (Permission denied): change the permissions") < message.size();
  }));
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
  EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(OutputFileTest, AFullDiskLeavesTheOldFileAndNothingElse)
{
  const fs::path path = folder_.file("a.obj", "old");
  EXPECT_TRUE(holdsInChild([&] {
    const rlimit limit{1000, 1000};
    if (std::signal(SIGXFSZ, SIG_IGN) == SIG_ERR || ::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    const std::string message = complaint(path, std::string(100000, 'x'));
    return message.find("cannot be written (File too large): raise the limit") < message.size();
  }));
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_THAT(folder_.names(), ElementsAre("a.obj"));
}

TEST_F(OutputFileTest, AFullDeviceIsNamed)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_EQ(complaint("/dev/full", "x"),
            "/dev/full: cannot be written (No space left on device): free some space, or write to another disk");
}

TEST_F(OutputFileTest, APipeIsWrittenAtCommit)
{
  const fs::path path = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  OutputFile output(path, "bytes");
  std::array<char, 16> received{};
  EXPECT_EQ(::read(reader, received.data(), received.size()), 0);
  output.commit();
  EXPECT_EQ(::read(reader, received.data(), received.size()), 5);
  EXPECT_EQ(std::string(received.data()), "bytes");
  ::close(reader);
}

TEST_F(OutputFileTest, StandardOutputInAFileIsContinuedNotReplaced)
{
  const fs::path path = folder_.file("log", "");
  EXPECT_TRUE(holdsInChild([&] {
    const int file = ::open(path.c_str(), O_WRONLY);
    if (::dup2(file, STDOUT_FILENO) < 0 || ::write(STDOUT_FILENO, "a", 1) != 1) return false;
    if (complaint("/dev/stdout", "b") != "written" || complaint(path, "c") != "written") return false;
    return ::write(STDOUT_FILENO, "d", 1) == 1;
  }));
  EXPECT_EQ(bytesOf(path), "abcd");
}

TEST_F(OutputFileTest, AnInterruptLeavesNothingUnfinished)
{
  OutputFile done(folder_.path() / "done", "x");
  done.commit();
  OutputFile first(folder_.path() / "first", "x");
  const OutputFile second(folder_.path() / "second", "x");
  EXPECT_EQ(folder_.names().size(), 3U);
  removeUnfinishedOutputs();
  EXPECT_THAT(folder_.names(), ElementsAre("done"));
  EXPECT_THROW(first.commit(), OutputError);
}

TEST_F(OutputFileTest, WhatAKilledProgramHasLeftIsRemovedByTheNext)
{
  const fs::path own = folder_.file(".part.obj", "somebody's own");
  const OutputFile underWay(folder_.path() / "under way.obj", "x");
  EXPECT_TRUE(holdsInChild([&] {
    // Ends without destructors, as by SIGKILL.
    static_cast<void>(new OutputFile(folder_.path() / "a.obj", "x"));
    return true;
  }));
  EXPECT_EQ(folder_.names().size(), 3U);
  OutputFile(folder_.path() / "b.obj", "x").commit();
  EXPECT_EQ(folder_.names().size(), 3U);
  OutputFile(folder_.path() / "c.obj", "x").commit();
  EXPECT_THAT(folder_.names(), testing::Contains("b.obj"));
  EXPECT_THAT(folder_.names(), testing::Contains(".part.obj"));
  EXPECT_EQ(folder_.names().size(), 4U);
}

TEST_F(OutputFileTest, SlotsOfFinishedOutputsAreUsedAgain)
{
  for (int i = 0; i < 3 * kTrackedOutputs; ++i) OutputFile(folder_.path() / "a", "x").commit();
  const OutputFile last(folder_.path() / "b", "x");
  removeUnfinishedOutputs();
  EXPECT_THAT(folder_.names(), ElementsAre("a"));
}

TEST_F(OutputFileTest, MoreOutputsThanAreTrackedAreStillWhole)
{
  std::vector<OutputFile> outputs;
  for (int i = 0; i < 2 * kTrackedOutputs; ++i)
    outputs.emplace_back(folder_.path() / std::to_string(i), std::to_string(i));
  for (OutputFile& output : outputs) output.commit();
  for (int i = 0; i < 2 * kTrackedOutputs; ++i)
    EXPECT_EQ(bytesOf(folder_.path() / std::to_string(i)), std::to_string(i));
}

}  // namespace
}  // namespace holdfast
