#include <array>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>

#include "support/random.h"
#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

using test::TemporaryFolder;
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
    return readAnyMesh(path);
  }
};

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
}

TEST_F(PolyDataErrors, NameAFolder)
{
  const auto folder = folder_.path() / "folder.vtp";
  std::filesystem::create_directory(folder);
  EXPECT_THAT(errorOf(folder), HasSubstr("is a directory: name a file"));
}

TEST_F(PolyDataErrors, SayThatLegacyFilesAreNotRead)
{
  for (const std::string name : {"mesh.vtk", "mesh.VTK"})
    EXPECT_THAT(errorOf(name, "# vtk DataFile Version 3.0\n"),
                testing::AllOf(HasSubstr(name), HasSubstr("not read"), HasSubstr("save it as .vtp")));
}

TEST_F(PolyDataErrors, CarryTheReasonOfTheParser)
{
  EXPECT_THAT(errorOf("text.vtp", "no XML at all\n"),
              testing::AllOf(HasSubstr("no whole XML file: "), HasSubstr("line 1"), Not(HasSubstr("ERROR: In"))));
}

TEST_F(PolyDataErrors, NameAnEmptyFile)
{
  EXPECT_THAT(errorOf("empty.vtp", ""), HasSubstr("the file is empty"));
}

TEST_F(PolyDataErrors, NameOtherKindsOfData)
{
  EXPECT_THAT(errorOf("image.vtp", R"(<VTKFile type="ImageData" version="1.0"><ImageData/></VTKFile>)"),
              HasSubstr("no PolyData file"));
}

TEST_F(PolyDataErrors, NameASurfaceWithoutPolygons)
{
  vtkNew<vtkPolyData> points;
  points->SetPoints(test::richPolyData()->GetPoints());
  EXPECT_THAT(errorOf("points.vtp", vtpBytes(*points)), HasSubstr("no polygons"));
  EXPECT_NE(errorOf("nothing.vtp", vtpBytes(*vtkNew<vtkPolyData>())), "no error");
}

TEST_F(PolyDataErrors, NameStripsThatAreNoFaces)
{
  const auto stripsOf = [](std::initializer_list<vtkIdType> corners) {
    auto strips = test::richPolyData();
    vtkNew<vtkCellArray> strip;
    strip->InsertNextCell(corners);
    strips->SetStrips(strip);
    strips->GetCellData()->Initialize();
    return strips;
  };
  EXPECT_THAT(errorOf("strips.vtp", vtpBytes(*stripsOf({0, 1, 2, 77}))),
              testing::AllOf(HasSubstr("strip 0"), HasSubstr("point 77")));
  const auto flat = stripsOf({0, 1, 0, 1});
  flat->SetPolys(vtkNew<vtkCellArray>());
  EXPECT_THAT(errorOf("flat.vtp", vtpBytes(*flat)), HasSubstr("no strip has a triangle"));
}

TEST_F(PolyDataErrors, NameThePolygonThatIsNoFace)
{
  EXPECT_THAT(errorOf("corner.vtp", vtpText("0 1 3", "3")),
              testing::AllOf(HasSubstr("polygon 0"), HasSubstr("point 3")));
  EXPECT_THAT(errorOf("negative.vtp", vtpText("0 1 -1", "3")),
              testing::AllOf(HasSubstr("polygon 0"), HasSubstr("point -1")));
  EXPECT_THAT(errorOf("two.vtp", vtpText("0 1", "2")), testing::AllOf(HasSubstr("polygon 0"), HasSubstr("at least 3")));
}

TEST_F(PolyDataErrors, NameOffsetsThatLeadNowhere)
{
  EXPECT_NE(errorOf("past.vtp", vtpText("0 1 2", "300000")), "no error");
  EXPECT_NE(errorOf("negative.vtp", vtpText("0 1 2", "-3")), "no error");
  EXPECT_EQ(errorOf("control.vtp", vtpText("0 1 2", "3")), "no error");
}

TEST_F(PolyDataErrors, NameCountsThatTheFileDoesNotHold)
{
  std::string vtp = vtpText("0 1 2", "3");
  vtp.replace(vtp.find("NumberOfPoints=\"3\""), 18, "NumberOfPoints=\"-3\"");
  EXPECT_THAT(errorOf("negative.vtp", vtp), testing::AllOf(HasSubstr("negative.vtp:2: "), HasSubstr("NumberOfPoints")));
}

/// Reading `bytes` gives the mesh that they hold or an `InputError`; the count says how often it was refused.
class DamagedFiles : public testing::Test {
 protected:
  [[nodiscard]] std::optional<Mesh> meshOf(const std::string& bytes) const
  {
    try {
      return readPolyData(folder_.file("damaged.vtp", bytes)).mesh;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] static std::string whole() { return vtpBytes(*test::richPolyData()); }

 private:
  TemporaryFolder folder_;
};

/// Only the end of the XML may be missing without loss.
TEST_F(DamagedFiles, CutShortNeverGiveAnotherMesh)
{
  const std::string bytes = whole();
  const std::optional<Mesh> mesh = meshOf(bytes);
  ASSERT_TRUE(mesh);
  std::size_t refused = 0;
  testing::internal::CaptureStderr();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::optional<Mesh> cut = meshOf(bytes.substr(0, length));
    refused += cut ? 0 : 1;
    if (cut) {
      EXPECT_TRUE(test::isSameBits(cut->positions, mesh->positions) && cut->faces == mesh->faces) << length;
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, bytes.size() / 2);
}

/// VTK's own reader crashes on some of these.
TEST_F(DamagedFiles, WithOtherNumbersAreReadOrRefused)
{
  const std::string bytes = whole();
  test::Random random(11);
  std::size_t refused = 0;
  testing::internal::CaptureStderr();
  for (int round = 0; round < 500; ++round) {
    std::string damaged = bytes;
    const auto place = damaged.find_first_of("0123456789", random.integer(0, damaged.size() - 1));
    if (place == std::string::npos) continue;
    const std::array<const char*, 6> numbers{"", "-1", "99999999", "4294967296", "9223372036854775807", "1e9"};
    damaged.replace(place, 1, numbers[random.integer(0, 5)]);
    refused += meshOf(damaged) ? 0 : 1;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, 50U);
}

}  // namespace
}  // namespace holdfast
