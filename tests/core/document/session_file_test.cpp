#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/session_file.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"
#include "support/random.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSessionHead = R"({"format": "holdfast-constraints", "version": 1, "constraints": [])";
const std::string kMesh = R"(, "mesh": {"path": "part.ply"})";

/// A session in which nothing has its default value.
SessionFile fullSession()
{
  SessionFile session;
  session.mesh = {"../meshes/part \"7\".ply", "/home/somebody/meshes/part.ply", "fnv1a64:0123456789abcdef"};
  test::Random random(7);
  session.document.list = test::randomConstraintList(random, 40);
  session.document.options = {Weights::Uniform, {SolverKind::Soft, Backend::Eigen, 0.1}};
  session.view.camera =
      Camera{{0.1, -1e-300, 1.0 / 3}, {1e300, -0.0, 2}, {0, 0.6, 0.8}, std::numeric_limits<double>::min(), true};
  session.view.upAxis = "y";
  session.view.colorBy = "detail";
  session.view.range = {-0.1, 0.30000000000000004};
  session.view.scale = "log";
  session.view.decades = 7;
  session.view.colorMap = "Björk's";
  session.view.bands = 12;
  session.view.legend = "left";
  session.view.decimals = 3;
  session.view.restShape = "edges";
  session.view.meshEdges = "all";
  session.view.surface = "wireframe";
  session.view.hiddenFaces = {{0, 3}, {7, 7}};
  session.view.showsConstraints = false;
  session.view.showsRotations = true;
  session.document.annotations = std::make_shared<const Annotations>(Annotations{
      {{"rim \"1\"", {VertexIds{{3, 1, 4}}}}, {"eye", {InsideCurve{{AtVertex{1}, AtVertex{2}, AtVertex{5}}}}}},
      {{AtVertex{7}, AtEdge{1, 2, 0.1}, AtFace{4, {0.25, 0.25, 0.5}}}, {{AtVertex{1}, AtEdge{3, 4, 1}}}}});
  session.original = "/home/somebody/part.holdfast";
  return session;
}

/// Returns the annotations as constraints, which can be compared.
ConstraintList listOf(const Annotations& annotations)
{
  ConstraintList list;
  const auto add = [&](const std::string& name, auto what) { list.constraints.push_back({name, true, what}); };
  for (const SavedSelection& saved : annotations.selections) add("s " + saved.name, FixedConstraint{saved.select});
  for (const SurfaceLocation& probe : annotations.measurements.probes) add("probe", PointConstraint{probe, Move{}});
  for (const auto& [from, to] : annotations.measurements.rulers) add("ruler", RelativeConstraint{from, to, {}});
  return list;
}

void expectSame(const SessionFile& a, const SessionFile& b)
{
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_TRUE(test::areSame(listOf(*a.document.annotations), listOf(*b.document.annotations)));
  EXPECT_TRUE(test::areSame(a.document.list, b.document.list));
  EXPECT_EQ(a.document.options, b.document.options);
  EXPECT_EQ(a.view, b.view);
  EXPECT_EQ(a.original, b.original);
}

void expectSessionRefused(const std::string& text, const std::string& element, const std::string& words)
{
  SCOPED_TRACE(text);
  try {
    static_cast<void>(parseSession(text, "s.holdfast"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "s.holdfast");
    EXPECT_EQ(error.location().element, element);
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
}

TEST(SessionFile, ReadsBackEqualInEveryMember)
{
  const SessionFile session = fullSession();
  const std::string text = sessionToJson(session);
  expectSame(parseSession(text, "s"), session);
  EXPECT_EQ(sessionToJson(parseSession(text, "s")), text);
}

TEST(SessionFile, WhatIsAbsentStaysAbsent)
{
  SessionFile session;
  session.mesh.path = "part.ply";
  const std::string text = sessionToJson(session);
  expectSame(parseSession(text, "s"), session);
  const nlohmann::json json = nlohmann::json::parse(text);
  EXPECT_EQ(json["view"], nlohmann::json::object());
  EXPECT_EQ(json["mesh"], (nlohmann::json{{"path", "part.ply"}}));
  for (const char* key : {"original", "selections", "measurements"}) EXPECT_FALSE(json.contains(key)) << key;
}

TEST(SessionFile, IsAConstraintFileAsWell)
{
  const SessionFile session = fullSession();
  const test::TemporaryFolder folder;
  writeSession(folder.path() / "part.holdfast", session);
  EXPECT_TRUE(test::areSame(readConstraints(folder.path() / "part.holdfast"), session.document.list));
}

TEST(SessionFile, LeavesTheDefaultBackendToTheBuild)
{
  SessionFile session;
  session.mesh.path = "part.ply";
  EXPECT_THAT(sessionToJson(session), testing::Not(HasSubstr("backend")));
  session.document.options.solver.backend = Backend::Eigen;
  session.document.options.nearLimit = 0.25;
  session.document.options.weldTolerance = 1e-7;
  EXPECT_EQ(parseSession(sessionToJson(session), "s").document.options, session.document.options);
}

TEST(SessionFile, IsWrittenToAFileAndReadFromIt)
{
  const test::TemporaryFolder folder;
  const SessionFile session = fullSession();
  writeSession(folder.path() / "part.holdfast", session);
  expectSame(readSession(folder.path() / "part.holdfast"), session);
  EXPECT_THAT(folder.names(), ElementsAre("part.holdfast"));
}

TEST(SessionFile, WhatCannotBeReadAgainIsNotWritten)
{
  const test::TemporaryFolder folder;
  const std::string path = folder.file("part.holdfast", "as it was");
  SessionFile nameless;
  EXPECT_THROW(writeSession(path, nameless), OutputError);
  SessionFile infinite = fullSession();
  infinite.view.camera->parallelScale = std::numeric_limits<double>::infinity();
  EXPECT_THROW(writeSession(path, infinite), OutputError);
  SessionFile notUtf8 = fullSession();
  notUtf8.mesh.path = "m\xFFsh.ply";
  EXPECT_THROW(writeSession(path, notUtf8), OutputError);
  EXPECT_EQ(test::bytesOf(path), "as it was");
}

TEST(SessionFile, ConstraintFilesWithoutAMeshAreNoSessions)
{
  expectSessionRefused(kSessionHead + "}", "top level", "\"mesh\" is missing: this is a constraint file; open a mesh");
}

TEST(SessionFile, MistakesOfTheMeshAreRefused)
{
  expectSessionRefused(kSessionHead + R"(, "mesh": "part.ply"})", "mesh", "an object in braces");
  expectSessionRefused(kSessionHead + R"(, "mesh": {}})", "mesh", "\"path\" is missing");
  expectSessionRefused(kSessionHead + R"(, "mesh": {"path": ""}})", "mesh.path", "the text is empty");
  expectSessionRefused(kSessionHead + R"(, "mesh": {"path": "p", "sum": 1}})", "mesh.sum", "unknown key");
  for (const std::string sum :
       {"", "0123456789abcdef", "md5:0123456789abcdef", "fnv1a64:0123", "fnv1a64:0123456789ABCDEF"})
    expectSessionRefused(kSessionHead + R"(, "mesh": {"path": "p", "checksum": ")" + sum + R"("}})", "mesh.checksum",
                         sum.empty() ? "the text is empty" : "16 hexadecimal digits");
}

TEST(SessionFile, MistakesOfTheOptionsAreRefused)
{
  const std::string head = kSessionHead + kMesh + R"(, "options": )";
  expectSessionRefused(head + R"({"weight": "uniform"}})", "options.weight", R"(did you mean "weights"?)");
  expectSessionRefused(head + R"({"weights": "cotan"}})", "options.weights",
                       R"("cotan" is not known here; Known here:)");
  expectSessionRefused(head + R"({"solver": "Soft"}})", "options.solver", R"(did you mean "soft"?)");
  expectSessionRefused(head + R"({"soft_weight": 0}})", "options.soft_weight", "not above 0");
  expectSessionRefused(head + R"({"rotations": "fund"}})", "options.rotations", R"(did you mean "found"?)");
  expectSessionRefused(head + R"({"rotation_change": -1}})", "options.rotation_change", "not above 0");
  expectSessionRefused(head + R"({"weld": -1}})", "options.weld", "not above 0");
  expectSessionRefused(head + R"({"near_limit": 0}})", "options.near_limit", "not above 0");
  expectSessionRefused(head + R"({"backend": 1}})", "options.backend", "text in double quotes");
}

TEST(SessionFile, MistakesOfTheViewAreRefused)
{
  const std::string head = kSessionHead + kMesh + R"(, "view": )";
  expectSessionRefused(head + R"({"colour": "x"}})", "view.colour", "unknown key");
  expectSessionRefused(head + R"({"color_by": ""}})", "view.color_by", "the text is empty");
  expectSessionRefused(head + R"({"range": [1, 1]}})", "view.range", "low is not below high");
  expectSessionRefused(head + R"({"range": [1]}})", "view.range", "a list of 2");
  expectSessionRefused(head + R"({"bands": 0}})", "view.bands", "not above 0");
  expectSessionRefused(head + R"({"hidden_faces": [[0, 1], [5, 4]]}})", "view.hidden_faces[1]", "5 is not below 4");
  expectSessionRefused(head + R"({"hidden_faces": [[-1, 4]]}})", "view.hidden_faces[0][0]", "-1");
  expectSessionRefused(head + R"({"glyphs": {"rotations": 1}}})", "view.glyphs.rotations", "true or false");
  const std::string camera = head + R"({"camera": {"position": [0,0,1], "focal_point": )";
  expectSessionRefused(camera + R"([0,0,1], "view_up": [0,1,0]}}})", "view.camera.focal_point",
                       "the camera's own place");
  expectSessionRefused(camera + R"([0,0,0]}}})", "view.camera", "\"view_up\" is missing");
  expectSessionRefused(camera + R"([0,0,0], "view_up": [0,0,0]}}})", "view.camera.view_up", "cannot be zero");
  expectSessionRefused(camera + R"([0,0,0], "view_up": [0,1,0], "parallel_scale": -1}}})", "view.camera.parallel_scale",
                       "not above 0");
  expectSessionRefused(camera + R"([0,0,0], "view_up": [0,1,0], "projection": "paralel"}}})", "view.camera.projection",
                       R"(did you mean "parallel"?)");
}

TEST(SessionFile, MistakesOfSavedSelectionsAndMeasurementsAreRefused)
{
  const std::string head = kSessionHead + kMesh + R"(, "selections": )";
  const std::string a = R"({"name": "a", "select": {"vertices": [1]}})";
  expectSessionRefused(head + "[" + a + ", " + a + "]}", "selections[1].name", "\"a\" is the name of an earlier");
  expectSessionRefused(head + R"([{"name": "", "select": {"vertices": [1]}}]})", "selections[0].name", "empty");
  expectSessionRefused(head + R"([{"name": "a"}]})", "selections[0]", "\"select\" is missing");
  expectSessionRefused(head + R"([{"name": "a", "select": {"vertices": []}}]})", "selections[0].select.vertices",
                       "at least one");
  const std::string measured = kSessionHead + kMesh + R"(, "measurements": )";
  expectSessionRefused(measured + R"({"probe": []}})", "measurements.probe", R"(did you mean "probes"?)");
  expectSessionRefused(measured + R"({"probes": [{"near": [0, 0, 0]}]}})", "measurements.probes[0]",
                       "vertices, edges or faces");
  expectSessionRefused(measured + R"({"rulers": [[{"vertex": 1}]]}})", "measurements.rulers[0]", "a list of 2");
}

TEST(SessionFile, AFileThatIsNotThereIsNamed)
{
  const test::TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(readSession(folder.path() / "none.holdfast")), InputError);
}

}  // namespace
}  // namespace holdfast
