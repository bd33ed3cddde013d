#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <holdfast/document/recovery.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"
#include "support/random.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

SessionFile sessionOf(int constraints)
{
  test::Random random(3);
  SessionFile session;
  session.mesh = {"meshes/part.ply", "", "fnv1a64:0123456789abcdef"};
  session.document.list = test::randomConstraintList(random, constraints);
  return session;
}

/// A program of its own that runs `work` until it is killed. `work` writes to the file it is given when it is ready.
class Victim {
 public:
  explicit Victim(const std::function<void(int ready)>& work)
  {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("no process");
    if (child_ == 0) {
      ::close(ends[0]);
      work(ends[1]);
      while (true) ::pause();
    }
    ::close(ends[1]);
    ready_ = ends[0];
  }
  ~Victim()
  {
    kill();
    ::close(ready_);
  }
  Victim(const Victim&) = delete;
  Victim& operator=(const Victim&) = delete;

  /// Waits for the next byte; false where the program is gone.
  [[nodiscard]] bool isReady() const
  {
    char byte = 0;
    return ::read(ready_, &byte, 1) == 1;
  }

  void kill()
  {
    if (child_ == 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_ = 0;
  int ready_ = -1;
};

void say(int ready)
{
  const char byte = 'r';
  if (::write(ready, &byte, 1) != 1) std::abort();
}

/// Sets a variable of the environment, or takes it away, as long as this is there.
class Variable {
 public:
  Variable(const char* name, const std::optional<std::string>& value) : name_(name)
  {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const std::optional<std::string>& value) const
  {
    if (value)
      ::setenv(name_, value->c_str(), 1);
    else
      ::unsetenv(name_);
  }

  const char* name_;
  std::optional<std::string> before_;
};

TEST(Recovery, WorkOfAKilledProgramIsOfferedWhole)
{
  const test::TemporaryFolder folder;
  const SessionFile session = sessionOf(30);
  Victim victim([&](int ready) {
    RecoveryFile file(folder.path() / "state");
    file.write(session, "/parts/part.holdfast");
    say(ready);
    while (true) ::pause();
  });
  ASSERT_TRUE(victim.isReady());
  EXPECT_THAT(recoverable(folder.path() / "state"), IsEmpty()) << "its program lives";
  victim.kill();

  const std::vector<Recoverable> found = recoverable(folder.path() / "state");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].original, "/parts/part.holdfast");
  EXPECT_EQ(found[0].mesh, "/parts/meshes/part.ply");
  EXPECT_EQ(found[0].name, "part.holdfast");
  const auto age = std::chrono::system_clock::now() - found[0].time;
  EXPECT_LT(age, std::chrono::hours(1));
  EXPECT_GT(age, -std::chrono::hours(1));
  const SessionFile again = readSession(found[0].path);
  EXPECT_TRUE(test::areSame(again.document.list, session.document.list));
  EXPECT_EQ(again.mesh.checksum, session.mesh.checksum);

  discard(found[0]);
  EXPECT_THAT(recoverable(folder.path() / "state"), IsEmpty());
  EXPECT_TRUE(fs::is_empty(folder.path() / "state")) << "nothing is left behind";
  discard(found[0]);
}

TEST(Recovery, AProgramKilledWhileItWritesLeavesNoHalfCopy)
{
  const SessionFile small = sessionOf(1);
  const SessionFile large = sessionOf(400);
  for (int k = 0; k < 20; ++k) {
    const test::TemporaryFolder folder;
    Victim victim([&](int ready) {
      RecoveryFile file(folder.path());
      for (int round = 0;; ++round) {
        file.write(round % 2 == 0 ? small : large, "/parts/part.holdfast");
        say(ready);
      }
    });
    for (int round = 0; round <= k % 4; ++round) ASSERT_TRUE(victim.isReady());
    victim.kill();
    const std::vector<Recoverable> found = recoverable(folder.path());
    ASSERT_THAT(found, SizeIs(1));
    const std::size_t count = readSession(found[0].path).document.list.constraints.size();
    EXPECT_TRUE(count == 1 || count == 400) << count;
    discard(found[0]);
    EXPECT_THAT(folder.names(), IsEmpty()) << "what it was writing is removed too";
  }
}

TEST(Recovery, CopiesOfLivingProgramsAndOfThisOneAreNotOffered)
{
  const test::TemporaryFolder folder;
  const auto writes = [&](int ready) {
    RecoveryFile file(folder.path());
    file.write(sessionOf(1), "/parts/part.holdfast");
    say(ready);
    while (true) ::pause();
  };
  Victim dead(writes);
  Victim living(writes);
  RecoveryFile own(folder.path());
  own.write(sessionOf(2), "/parts/own.holdfast");
  ASSERT_TRUE(dead.isReady() && living.isReady());
  EXPECT_THAT(recoverable(folder.path()), IsEmpty());
  dead.kill();
  EXPECT_THAT(recoverable(folder.path()), SizeIs(1));
}

TEST(Recovery, ANormalEndLeavesNothing)
{
  const test::TemporaryFolder folder;
  {
    RecoveryFile file(folder.path());
    EXPECT_THAT(folder.names(), IsEmpty()) << "nothing is made before it is needed";
    file.write(sessionOf(1), "/parts/part.holdfast");
    EXPECT_THAT(folder.names(), SizeIs(1));
    file.clear();
    EXPECT_THAT(folder.names(), IsEmpty());
    file.write(sessionOf(1), "/parts/part.holdfast");
  }
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Recovery, WorkThatWasNeverSavedHasTheNameOfItsMesh)
{
  const test::TemporaryFolder folder;
  Victim victim([&](int ready) {
    RecoveryFile file(folder.path());
    SessionFile session = sessionOf(1);
    session.mesh = {"part.ply", "/meshes/part.ply", ""};
    file.write(session, "");
    say(ready);
    while (true) ::pause();
  });
  ASSERT_TRUE(victim.isReady());
  victim.kill();
  const std::vector<Recoverable> found = recoverable(folder.path());
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].original, "");
  EXPECT_EQ(found[0].mesh, "/meshes/part.ply");
  EXPECT_EQ(found[0].name, "part.ply");
}

TEST(Recovery, TheNewestIsFirstAndWhatCannotBeReadIsOfferedToo)
{
  const test::TemporaryFolder folder;
  const auto leave = [&](const std::string& name, const std::string& text, int hours) {
    fs::create_directory(folder.path() / name);
    fs::path copy = folder.file(name + "/copy.holdfast", text);
    fs::last_write_time(copy, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    return copy;
  };
  SessionFile session = sessionOf(1);
  session.mesh.path = "/meshes/part.ply";
  const fs::path old = leave("old", sessionToJson(session), 9);
  const fs::path spoilt = leave("spoilt", "{", 5);
  const fs::path fresh = leave("fresh", sessionToJson(session), 1);
  std::vector<fs::path> paths;
  for (const Recoverable& copy : recoverable(folder.path())) paths.push_back(copy.path);
  EXPECT_THAT(paths, ElementsAre(fresh, spoilt, old));
  EXPECT_THROW(static_cast<void>(readSession(spoilt)), InputError);
}

TEST(Recovery, WhatIsNotACopyIsLeftAlone)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder.file("part.holdfast", "mine");
  fs::create_directory(folder.path() / "empty");
  EXPECT_THAT(recoverable(folder.path()), IsEmpty());
  EXPECT_THAT(recoverable(folder.path() / "none"), IsEmpty());
  EXPECT_THAT(recoverable(file), IsEmpty());
  Recoverable wrong;
  wrong.path = file;
  discard(wrong);
  EXPECT_THAT(folder.names(), ElementsAre("empty", "part.holdfast"));
}

TEST(Recovery, ACopyThatCannotBeWrittenLeavesTheLastOne)
{
  const test::TemporaryFolder folder;
  RecoveryFile file(folder.path());
  file.write(sessionOf(3), "/parts/part.holdfast");
  SessionFile broken = sessionOf(1);
  broken.document.list.constraints[0].name = "";
  EXPECT_THROW(file.write(broken, "/parts/part.holdfast"), OutputError);
  const fs::path copy = folder.path() / folder.names().at(0) / "copy.holdfast";
  EXPECT_THAT(readSession(copy).document.list.constraints, SizeIs(3));
}

TEST(Recovery, AFolderThatWasTidiedAwayIsMadeAgain)
{
  const test::TemporaryFolder folder;
  RecoveryFile file(folder.path() / "recovery");
  file.write(sessionOf(1), "/parts/part.holdfast");
  fs::remove_all(folder.path() / "recovery");
  file.write(sessionOf(1), "/parts/part.holdfast");
  EXPECT_FALSE(fs::is_empty(folder.path() / "recovery"));
}

TEST(Recovery, AFolderThatCannotBeMadeIsSaid)
{
  const test::TemporaryFolder folder;
  RecoveryFile file(folder.file("file", "") / "recovery");
  EXPECT_THROW(file.write(sessionOf(1), "/parts/part.holdfast"), OutputError);
}

TEST(Recovery, OtherUsersCannotReadTheCopies)
{
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "open");
  const fs::perms before = fs::status(folder.path() / "open").permissions();
  RecoveryFile elsewhere(folder.path() / "open");
  elsewhere.write(sessionOf(1), "/parts/part.holdfast");
  EXPECT_EQ(fs::status(folder.path() / "open").permissions(), before) << "a folder that was there is not changed";
  for (const auto& place : fs::directory_iterator(folder.path() / "open"))
    EXPECT_EQ(place.status().permissions(), fs::perms::owner_all);
  RecoveryFile file(folder.path() / "state/recovery");
  file.write(sessionOf(1), "/parts/part.holdfast");
  EXPECT_EQ(fs::status(folder.path() / "state/recovery").permissions(), fs::perms::owner_all);
}

TEST(Recovery, TheFolderIsThatOfTheStateOfTheUser)
{
  const Variable home("HOME", "/home/somebody");
  {
    const Variable state("XDG_STATE_HOME", "/state");
    EXPECT_EQ(recoveryFolder(), "/state/holdfast/recovery");
  }
  for (const std::optional<std::string>& notAbsolute :
       {std::optional<std::string>(), std::optional<std::string>("state")}) {
    const Variable state("XDG_STATE_HOME", notAbsolute);
    EXPECT_EQ(recoveryFolder(), "/home/somebody/.local/state/holdfast/recovery");
    const Variable homeless("HOME", std::nullopt);
    EXPECT_EQ(recoveryFolder(), std::nullopt);
  }
}

}  // namespace
}  // namespace holdfast
