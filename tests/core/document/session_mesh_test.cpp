#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/session_file.h>
#include <holdfast/words/error.h>

#include "support/temporary_folder.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

/// The folder `project` with a mesh in a folder beside that of the session.
struct Project {
  Project()
  {
    fs::create_directories(folder.path() / "project/meshes");
    fs::create_directories(folder.path() / "project/sessions");
    static_cast<void>(folder.file("project/meshes/part.ply", "a mesh"));
  }

  [[nodiscard]] fs::path mesh() const { return folder.path() / "project/meshes/part.ply"; }
  [[nodiscard]] fs::path session() const { return folder.path() / "project/sessions/part.holdfast"; }

  test::TemporaryFolder folder;
};

SessionFile sessionOf(const Project& project)
{
  SessionFile session;
  session.mesh = referenceTo(project.mesh(), project.session(), checksumOfFile(project.mesh()));
  return session;
}

TEST(Checksum, IsThePublishedHash)
{
  const test::TemporaryFolder folder;
  EXPECT_EQ(checksumOfFile(folder.file("a", "a")), "fnv1a64:af63dc4c8601ec8c");
  EXPECT_EQ(checksumOfFile(folder.file("foobar", "foobar")), "fnv1a64:85944171f73967e8");
}

TEST(Checksum, DependsOnEveryByteOfALargeFile)
{
  const test::TemporaryFolder folder;
  std::string bytes(300000, '\xFF');
  const std::string checksum = checksumOfFile(folder.file("large", bytes));
  for (const std::size_t place : {std::size_t{0}, std::size_t{65535}, std::size_t{65536}, bytes.size() - 1}) {
    bytes[place] = 'x';
    EXPECT_NE(checksumOfFile(folder.file("large", bytes)), checksum);
    bytes[place] = '\xFF';
  }
  EXPECT_NE(checksumOfFile(folder.file("large", bytes + '\0')), checksum);
}

TEST(Checksum, OfWhatIsNoFileIsRefused)
{
  const test::TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(checksumOfFile(folder.path() / "none")), InputError);
  EXPECT_THROW(static_cast<void>(checksumOfFile(folder.path())), InputError);
}

TEST(SessionMesh, IsNamedFromTheFolderOfTheSession)
{
  const Project project;
  const MeshReference reference = referenceTo(project.mesh(), project.session(), checksumOfFile(project.mesh()));
  EXPECT_EQ(reference.path, "../meshes/part.ply");
  EXPECT_EQ(reference.checksum, checksumOfFile(project.mesh()));
}

TEST(SessionMesh, WhoseChecksumIsKnownIsNotRead)
{
  const Project project;
  const MeshReference read = referenceTo(project.mesh(), project.session(), checksumOfFile(project.mesh()));
  fs::remove(project.mesh());
}

TEST(SessionMesh, IsNamedThroughLinkedFolders)
{
  const Project project;
  fs::create_directory_symlink(project.folder.path() / "project/sessions", project.folder.path() / "link");
  const SessionFile session{
      referenceTo(project.mesh(), project.folder.path() / "link/part.holdfast", checksumOfFile(project.mesh())),
      {},
      {},
      {}};
  EXPECT_EQ(session.mesh.path, "../meshes/part.ply") << "what the system makes of link/..";
  EXPECT_EQ(resolveMesh(session, project.folder.path() / "link/part.holdfast").state, MeshState::Same);
}

TEST(SessionMesh, IsFoundAfterBothHaveMovedTogether)
{
  const Project project;
  const SessionFile session = sessionOf(project);
  fs::rename(project.folder.path() / "project", project.folder.path() / "moved");
  const ResolvedMesh found = resolveMesh(session, project.folder.path() / "moved/sessions/part.holdfast");
  EXPECT_EQ(found.state, MeshState::Same) << found.message;
  EXPECT_TRUE(fs::equivalent(found.path, project.folder.path() / "moved/meshes/part.ply"));
  EXPECT_EQ(found.message, "");
}

TEST(SessionMesh, IsFoundWhereItWasWhenTheSessionAloneHasMoved)
{
  const Project project;
  const ResolvedMesh found = resolveMesh(sessionOf(project), project.folder.path() / "elsewhere/part.holdfast");
  EXPECT_EQ(found.state, MeshState::Same) << found.message;
  EXPECT_TRUE(fs::equivalent(found.path, project.mesh()));
}

TEST(SessionMesh, ThatIsTheSameGoesBeforeOneThatHasChanged)
{
  const Project project;
  const SessionFile session = sessionOf(project);
  fs::create_directories(project.folder.path() / "copy/meshes");
  fs::create_directories(project.folder.path() / "copy/sessions");
  static_cast<void>(project.folder.file("copy/meshes/part.ply", "another mesh"));
  const ResolvedMesh found = resolveMesh(session, project.folder.path() / "copy/sessions/part.holdfast");
  EXPECT_EQ(found.state, MeshState::Same);
  EXPECT_TRUE(fs::equivalent(found.path, project.mesh()));
}

TEST(SessionMesh, ThatHasChangedIsSaidToHave)
{
  const Project project;
  const SessionFile session = sessionOf(project);
  static_cast<void>(project.folder.file("project/meshes/part.ply", "a mesh, exported anew"));
  const ResolvedMesh found = resolveMesh(session, project.session());
  EXPECT_EQ(found.state, MeshState::Changed);
  EXPECT_TRUE(fs::equivalent(found.path, project.mesh()));
  EXPECT_THAT(found.message, HasSubstr("not the one that the session was saved with"));
  EXPECT_THAT(found.message, HasSubstr("part.ply"));
}

TEST(SessionMesh, ThatIsMissingIsSaidToBe)
{
  const Project project;
  const SessionFile session = sessionOf(project);
  fs::remove(project.mesh());
  const ResolvedMesh found = resolveMesh(session, project.session());
  EXPECT_EQ(found.state, MeshState::Missing);
  EXPECT_THAT(found.message, HasSubstr("there is no such file"));
  EXPECT_THAT(found.message, HasSubstr("Choose where the mesh of the session is"));
}

TEST(SessionMesh, WithoutAChecksumIsTakenAsItIs)
{
  const Project project;
  SessionFile session;
  session.mesh.path = "../meshes/part.ply";
  EXPECT_EQ(resolveMesh(session, project.session()).state, MeshState::Same);
  session.mesh.path = project.mesh().string();
  EXPECT_EQ(resolveMesh(session, "/nowhere/part.holdfast").state, MeshState::Same);
}

}  // namespace
}  // namespace holdfast
