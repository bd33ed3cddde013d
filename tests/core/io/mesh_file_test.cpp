#include <array>
#include <cmath>
#include <filesystem>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/mesh/triangulation.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\ng square\nf 1/1 2/1 3/1 4/1\nf 1 3 2\n";

class MeshFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const std::filesystem::path& path) const
  {
    try {
      static_cast<void>(readMesh(path));
      return "read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, path.string());
      return error.reason();
    }
  }

  [[nodiscard]] MeshDocument readBack(const Serialized& written, const std::string& extension) const
  {
    return readMesh(folder_.file("again" + extension, written.bytes));
  }

  test::TemporaryFolder folder_;
};

TEST_F(MeshFile, AMeshMadeInMemorySurvivesEveryFormatThatHoldsDoubles)
{
  Mesh mesh = test::icosphere(2);
  mesh.positions *= 1.0 / 3.0;
  mesh.faces.add({0, 1, 2, 3, 4});
  for (const std::string extension : {".obj", ".ply", ".off", ".vtp"}) {
    const Serialized written = serializeMesh({mesh, nullptr}, mesh.positions, extension);
    const MeshDocument again = readBack(written, extension);
    EXPECT_EQ(again.mesh.positions, mesh.positions) << extension;
    EXPECT_EQ(again.mesh.faces, mesh.faces) << extension;
    EXPECT_THAT(written.notes, IsEmpty());
    EXPECT_THAT(again.source->extras(), IsEmpty());
  }
}

TEST_F(MeshFile, PlyHoldsFacesOfManyCorners)
{
  const Index corners = 300;
  Mesh mesh{Positions::Zero(corners, 3), {}};
  std::vector<Index> polygon;
  for (Index v = 0; v < corners; ++v) polygon.push_back(v);
  mesh.faces.add(polygon);
  const Serialized written = serializeMesh({mesh, nullptr}, mesh.positions, ".ply");
  EXPECT_EQ(readBack(written, ".ply").mesh.faces, mesh.faces);
}

TEST_F(MeshFile, StlGetsTrianglesInSinglePrecisionAndSaysSo)
{
  const MeshDocument document = readMesh(folder_.file("a.obj", kObj));
  Positions positions = document.mesh.positions;
  positions(2, 0) = 1.1;
  const Serialized written = serializeMesh(document, positions, ".stl");
  const Mesh mesh = readBack(written, ".stl").mesh;
  EXPECT_EQ(mesh.faces.size(), 3);
  EXPECT_EQ(mesh.positions(4, 0), static_cast<double>(1.1F));
  EXPECT_EQ(mesh.positions.row(5).transpose(), Vector3(0, 1, 0));
  EXPECT_THAT(written.notes,
              ElementsAre(HasSubstr("1 coordinate rounded, off by at most 2.38e-08"), "1 polygon split into triangles",
                          "left behind, because the format changes from .obj to .stl: texture coordinates, groups"));
}

/// Half the sum of the triangles' cross products along z, and the least of them.
std::pair<double, double> areaAndLeast(const Mesh& mesh)
{
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto corner = [&](std::size_t k) -> Vector3 { return mesh.positions.row(mesh.faces[f][k]).transpose(); };
    const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).z() / 2;
    sum += area;
    least = std::min(least, area);
  }
  return {sum, least};
}

struct Outline {
  std::string name;
  std::vector<std::array<double, 2>> places;
  double area;
};

class ConcavePolygons : public MeshFile, public testing::WithParamInterface<Outline> {};

TEST_P(ConcavePolygons, KeepTheirAreaInStl)
{
  Mesh mesh{Positions::Zero(std::ssize(GetParam().places), 3), {}};
  std::vector<Index> corners;
  for (const auto& [x, y] : GetParam().places) {
    mesh.positions.row(std::ssize(corners)) << x, y, 0;
    corners.push_back(std::ssize(corners));
  }
  mesh.faces.add(corners);
  const Mesh written = readBack(serializeMesh({mesh, nullptr}, mesh.positions, ".stl"), ".stl").mesh;
  const auto [area, least] = areaAndLeast(written);
  EXPECT_DOUBLE_EQ(area, GetParam().area);
  EXPECT_GT(least, 0);
}

TEST_P(ConcavePolygons, AreDividedInStlAsForTheSolverAtRest)
{
  Mesh mesh{Positions::Zero(std::ssize(GetParam().places), 3), {}};
  std::vector<Index> corners;
  for (const auto& [x, y] : GetParam().places) {
    mesh.positions.row(std::ssize(corners)) << x, y, 0;
    corners.push_back(std::ssize(corners));
  }
  mesh.faces.add(corners);
  const Positions mirrored = mesh.positions.rowwise().reverse();
  const Mesh written = readBack(serializeMesh({mesh, nullptr}, mirrored, ".stl"), ".stl").mesh;
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  ASSERT_EQ(written.faces.size(), std::ssize(triangles));
  for (Index t = 0; t < written.faces.size(); ++t)
    for (Index k = 0; k < 3; ++k) EXPECT_EQ(written.positions.row(3 * t + k), mirrored.row(triangles[t][k]));
}

INSTANTIATE_TEST_SUITE_P(
    Outlines, ConcavePolygons,
    testing::Values(
        Outline{"Notch", {{0, 0}, {4, 0}, {4, 4}, {2, 0.5}, {0, 4}}, 9},
        Outline{"Angle", {{3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 0}}, 5},
        Outline{"Dart", {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}, 1.5},
        Outline{"Comb",
                {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
                11}),
    [](const auto& some) { return some.param.name; });

TEST_F(MeshFile, FacesOfFewCornersStayInTheirFormatAndAreLeftBehindInOthers)
{
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 3\n";
  const MeshDocument document = readMesh(folder_.file("a.obj", text));
  EXPECT_EQ(document.mesh.faces.size(), 3);
  for (const std::string extension : {".ply", ".off", ".stl", ".vtp"}) {
    const Serialized written = serializeMesh(document, document.mesh.positions, extension);
    EXPECT_EQ(readBack(written, extension).mesh.faces.size(), 1) << extension;
    EXPECT_THAT(written.notes, ElementsAre("2 faces of fewer than three corners left behind"));
  }
}

TEST_F(MeshFile, VerticesWithoutAPlaceStayAsTheFileHasThem)
{
  const std::string text = "v 0 0 0\nv 1 0 0\nv NaN 1.#INF 0\nv 0 1 0\nf 1 2 4\n";
  const MeshDocument document = readMesh(folder_.file("a.obj", text));
  Positions positions = document.mesh.positions;
  positions.row(2) = Vector3(7, 7, 7);
  positions(0, 2) = 0.5;
  EXPECT_EQ(serializeMesh(document, positions, ".obj").bytes, "v 0 0 0.5\nv 1 0 0\nv NaN 1.#INF 0\nv 0 1 0\nf 1 2 4\n");
  EXPECT_THAT(serializeMesh(document, positions, ".off").bytes, HasSubstr("1 0 0\nnan inf 0\n0 1 0\n"));
}

TEST_F(MeshFile, ABinaryStlThatIsWrittenBackSaysWhatItLoses)
{
  const Mesh mesh = test::tetrahedron();
  const MeshDocument stl = readBack(serializeMesh({mesh, nullptr}, mesh.positions, ".stl"), ".stl");
  Positions positions = stl.mesh.positions;
  positions(0, 0) = 1.1;
  positions(0, 1) = 1.2;
  const Serialized written = serializeMesh(stl, positions, ".stl");
  EXPECT_EQ(readBack(written, ".stl").mesh.positions(0, 0), static_cast<double>(1.1F));
  EXPECT_THAT(written.notes,
              ElementsAre("1 normal recomputed", HasSubstr("2 coordinates rounded, off by at most 4.77e-08")));
}

TEST_F(MeshFile, StlRefusesWhatNoFloatHolds)
{
  const Mesh mesh = test::tetrahedron();
  const Positions positions = mesh.positions * 1e300;
  EXPECT_THROW(static_cast<void>(serializeMesh({mesh, nullptr}, positions, ".stl")), OutputError);
  const MeshDocument stl = readBack(serializeMesh({mesh, nullptr}, mesh.positions, ".stl"), ".stl");
  EXPECT_THROW(static_cast<void>(serializeMesh(stl, stl.mesh.positions * 1e300, ".stl")), OutputError);
}

TEST_F(MeshFile, OfStlEveryFacetHasVerticesOfItsOwn)
{
  const Mesh mesh = test::tetrahedron();
  const MeshDocument stl = readBack(serializeMesh({mesh, nullptr}, mesh.positions, ".stl"), ".stl");
  const Serialized written = serializeMesh(stl, stl.mesh.positions, ".off");
  EXPECT_EQ(readBack(written, ".off").mesh.vertexCount(), 12);
  EXPECT_EQ(readBack(written, ".off").mesh.faces, stl.mesh.faces);
  EXPECT_THAT(written.notes, ElementsAre(HasSubstr("facet normals")));
}

TEST_F(MeshFile, TheExtensionCountsInAnyCase)
{
  const MeshDocument document = readMesh(folder_.file("a.OBJ", kObj));
  EXPECT_EQ(document.source->extension(), ".obj");
  EXPECT_EQ(serializeMesh(document, document.mesh.positions, ".Obj").bytes, kObj);
}

TEST_F(MeshFile, TextsAreToldFromBinaryFiles)
{
  const Mesh mesh = test::tetrahedron();
  for (const auto& [extension, isText] :
       {std::pair(".obj", true), {".off", true}, {".ply", false}, {".stl", false}, {".vtp", false}})
    EXPECT_EQ(readBack(serializeMesh({mesh, nullptr}, mesh.positions, extension), extension).source->isText(), isText)
        << extension;
}

TEST_F(MeshFile, EveryKnownExtensionIsReadAndWritten)
{
  const Mesh mesh = test::tetrahedron();
  EXPECT_THAT(meshExtensions(), ElementsAre(".obj", ".ply", ".off", ".stl", ".vtp"));
  EXPECT_THAT(outputExtensions(), ElementsAre(".obj", ".ply", ".off", ".stl", ".vtp", ".vtk"));
  for (const std::string_view extension : meshExtensions()) {
    const MeshDocument document =
        readBack(serializeMesh({mesh, nullptr}, mesh.positions, extension), std::string(extension));
    EXPECT_EQ(document.source->extension(), extension);
    EXPECT_EQ(document.mesh.faces.size(), 4);
  }
}

TEST_F(MeshFile, AnUnknownExtensionIsRefusedWithThoseThatAreKnown)
{
  EXPECT_EQ(refusal(folder_.file("a.xyz", "1")),
            "'.xyz' is not a mesh format that is known here: use .obj, .ply, .off, .stl, .vtp");
  const Mesh mesh = test::tetrahedron();
  try {
    static_cast<void>(serializeMesh({mesh, nullptr}, mesh.positions, ""));
    ADD_FAILURE() << "was written";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("a name without an extension says no mesh format: use .obj, .ply, .off, .stl, .vtp, .vtk"));
  }
}

TEST_F(MeshFile, LegacyVtkFilesAreWrittenAlone)
{
  for (const std::string name : {"mesh.vtk", "mesh.VTK"})
    EXPECT_EQ(refusal(folder_.file(name, "# vtk DataFile Version 3.0\n")),
              "legacy VTK files (.vtk) are not read: save it as .vtp, for example in ParaView (Save Data)");
  EXPECT_THAT(refusal(folder_.path() / "none.vtk"), HasSubstr("there is no such file: "));
  Mesh mesh = test::tetrahedron();
  mesh.faces.add({0, 1});
  const Serialized written = serializeMesh({mesh, nullptr}, mesh.positions, ".VTK");
  EXPECT_THAT(written.bytes, testing::StartsWith("# vtk DataFile Version 3.0\nHoldfast\nBINARY\nDATASET POLYDATA\n"
                                                 "POINTS 4 double\n"));
  EXPECT_THAT(written.notes, ElementsAre("1 face of fewer than three corners left behind"));
}

TEST_F(MeshFile, ErrorsOfOutputsNameTheFile)
{
  const Mesh mesh = test::tetrahedron();
  try {
    static_cast<void>(serializeMeshFile({mesh, nullptr}, mesh.positions * 1e300, "out/a.stl"));
    ADD_FAILURE() << "was written";
  } catch (const OutputError& error) {
    EXPECT_EQ(error.path(), "out/a.stl");
  }
}

TEST_F(MeshFile, WhatIsNoFileIsRefusedWithAReason)
{
  EXPECT_THAT(refusal(folder_.path() / "none.obj"), HasSubstr("there is no such file: "));
  EXPECT_THAT(refusal(folder_.path()), HasSubstr("is a directory: "));
  EXPECT_THAT(refusal(folder_.path() / "none" / "a.obj"), HasSubstr("there is no such file: "));
  EXPECT_THAT(refusal(folder_.file("file", "x") / "a.obj"), HasSubstr("there is no such file: "));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("is not a regular file: "));
  for (const std::string_view extension : meshExtensions())
    EXPECT_THAT(refusal(folder_.file("empty" + std::string(extension), "")), HasSubstr("the file is empty: "));
}

}  // namespace
}  // namespace holdfast
