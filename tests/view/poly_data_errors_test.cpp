#include <optional>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/base/error.h>
#include <holdfast/view/poly_data.h>
#include <holdfast/view/poly_data_bytes.h>
#include <holdfast/view/poly_data_file.h>

#include "support/meshes.h"
#include "view/poly_data_samples.h"

namespace holdfast {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What reading a file of these bytes throws, and that nothing of it reaches the console.
class PolyDataErrors : public testing::Test {
 protected:
  [[nodiscard]] std::string errorOf(const std::string& name, const std::string& bytes) const
  {
    return errorOf(folder_.file(name, bytes));
  }

  [[nodiscard]] static std::string errorOf(const std::filesystem::path& path)
  {
    try {
      (void)readQuietly(path);
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, path.string());
      return error.what();
    }
    return "no error";
  }

  /// The mesh, or nothing where the file is refused.
  [[nodiscard]] std::optional<Mesh> meshOf(const std::string& name, const std::string& bytes) const
  {
    try {
      return readQuietly(folder_.file(name, bytes)).mesh;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  TemporaryFolder folder_;

 private:
  static MeshDocument readQuietly(const std::filesystem::path& path)
  {
    struct Console {
      Console() { testing::internal::CaptureStderr(); }
      ~Console() { EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); }
      Console(const Console&) = delete;
      Console& operator=(const Console&) = delete;
    } const console;
    return readPolyData(path);
  }
};

std::string tetrahedronAsVtp()
{
  const Mesh mesh = test::tetrahedron();
  return vtpBytes(*toPolyData(mesh, mesh.positions));
}

std::string vtpText(const std::string& connectivity, const std::string& offsets)
{
  return R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">)" +
         connectivity + R"(</DataArray><DataArray type="Int64" Name="offsets" format="ascii">)" + offsets +
         "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
}

TEST_F(PolyDataErrors, NameAFileThatIsNotThere)
{
  EXPECT_THAT(errorOf(folder_.path() / "absent.vtp"), HasSubstr("no such file"));
  EXPECT_THAT(errorOf(folder_.path() / "absent.vtk"), HasSubstr("no such file"));
}

TEST_F(PolyDataErrors, NameAFolder)
{
  const auto folder = folder_.path() / "folder.vtp";
  std::filesystem::create_directory(folder);
  EXPECT_THAT(errorOf(folder), HasSubstr("folder; name a file"));
}

TEST_F(PolyDataErrors, NameAnExtensionThatIsNotVtks)
{
  EXPECT_THAT(errorOf("mesh.obj", "v 0 0 0\n"), HasSubstr("use .vtp or .vtk"));
}

TEST_F(PolyDataErrors, CarryTheReasonOfVtk)
{
  EXPECT_THAT(errorOf("text.vtp", "no XML at all\n"), AllOf(HasSubstr("XML"), Not(HasSubstr("ERROR: In"))));
  EXPECT_THAT(errorOf("empty.vtp", ""), HasSubstr("VTK cannot read it: "));
  EXPECT_THAT(errorOf("empty.vtk", ""), HasSubstr("VTK cannot read it: "));
  EXPECT_THAT(errorOf("text.vtk", "no VTK at all\nnor this\n"), HasSubstr("VTK cannot read it: "));
}

TEST_F(PolyDataErrors, NameOtherKindsOfData)
{
  EXPECT_THAT(errorOf("image.vtp", R"(<VTKFile type="ImageData" version="1.0"><ImageData/></VTKFile>)"),
              HasSubstr("VTK cannot read it: "));
  EXPECT_THAT(errorOf("grid.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 double\n"),
              HasSubstr("VTK cannot read it: "));
}

TEST_F(PolyDataErrors, NameASurfaceWithoutPolygons)
{
  EXPECT_THAT(errorOf("points.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 double\n0 0 0\n"),
              HasSubstr("no polygons"));
  EXPECT_NE(errorOf("nothing.vtp", vtpBytes(*vtkNew<vtkPolyData>())), "no error");
}

TEST_F(PolyDataErrors, NameTriangleStrips)
{
  EXPECT_THAT(errorOf("strips.vtk", test::squareAsLegacyText("TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n")),
              AllOf(HasSubstr("triangle strips (1)"), HasSubstr("Triangulate")));
}

TEST_F(PolyDataErrors, NameThePolygonThatIsNoFace)
{
  EXPECT_THAT(errorOf("corner.vtp", vtpText("0 1 3", "3")), AllOf(HasSubstr("polygon 0"), HasSubstr("point 3")));
  EXPECT_THAT(errorOf("negative.vtp", vtpText("0 1 -1", "3")), AllOf(HasSubstr("polygon 0"), HasSubstr("point -1")));
  EXPECT_THAT(errorOf("two.vtp", vtpText("0 1", "2")), AllOf(HasSubstr("polygon 0"), HasSubstr("2 corners")));
}

TEST_F(PolyDataErrors, NameOffsetsThatLeadNowhere)
{
  EXPECT_NE(errorOf("past.vtp", vtpText("0 1 2", "300000")), "no error");
  EXPECT_NE(errorOf("negative.vtp", vtpText("0 1 2", "-3")), "no error");
  EXPECT_EQ(errorOf("control.vtp", vtpText("0 1 2", "3")), "no error");
}

TEST_F(PolyDataErrors, NameCountsThatTheFileDoesNotHold)
{
  const std::string huge =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4000000000000 double\n0 0 0\n";
  EXPECT_THAT(errorOf("huge.vtk", huge), HasSubstr("huge.vtk: "));
  EXPECT_NE(errorOf("huge.vtk", huge), "no error");
}

/// A file cut short is refused, or nothing but the end of the XML is missing and the mesh is whole.
TEST_F(PolyDataErrors, TruncatedFilesNeverGiveAnotherMesh)
{
  const Mesh whole = test::tetrahedron();
  for (const auto& [name, bytes] :
       {std::pair<std::string, std::string>("cut.vtp", tetrahedronAsVtp()),
        std::pair<std::string, std::string>("cut.vtk", legacyBytes(*toPolyData(whole, whole.positions), {"x", 4}))}) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      SCOPED_TRACE(name + " cut to " + std::to_string(length));
      const std::optional<Mesh> mesh = meshOf(name, bytes.substr(0, length));
      if (mesh) {
        EXPECT_TRUE(test::isSameBits(mesh->positions, whole.positions));
        EXPECT_EQ(mesh->faces, whole.faces);
      } else {
        ++refused;
      }
    }
    EXPECT_GT(refused, bytes.size() / 2);
  }
}

}  // namespace
}  // namespace holdfast
