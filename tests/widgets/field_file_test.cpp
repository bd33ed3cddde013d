#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <holdfast/io/field_file.h>
#include <holdfast/widgets/mesh/poly_data.h>

#include "support/meshes.h"
#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

using test::readByVtk;

std::vector<double> valuesOf(vtkDataSetAttributes& attributes, const char* name)
{
  auto* array = vtkDoubleArray::SafeDownCast(attributes.GetArray(name));
  if (array == nullptr) return {};
  return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues()};
}

TEST(FieldFile, HoldsTheMeshAtTheGivenPositions)
{
  const Mesh mesh = test::withAwkwardCoordinates(test::icosphere(1));
  const Positions moved = mesh.positions * (1.0 / 7);
  const auto result = readByVtk(fieldsToVtp(mesh, moved, {}, {}).bytes);
  EXPECT_TRUE(test::isSameBits(positionsOf(*result), moved));
  EXPECT_EQ(polygonsOf(*result, "fields.vtp"), mesh.faces);
}

TEST(FieldFile, LeavesFacesOfFewCornersOut)
{
  Mesh mesh = test::tetrahedron();
  const Polygons surface = mesh.faces;
  mesh.faces.add({0, 1});
  mesh.faces.add(std::vector<Index>{});
  EXPECT_EQ(polygonsOf(*readByVtk(fieldsToVtp(mesh, mesh.positions, {}, {}).bytes), "fields.vtp"), surface);
}

TEST(FieldFile, LeavesOutTheValuesOfSuchFaces)
{
  Mesh mesh{test::tetrahedron().positions, {}};
  mesh.faces.add({0, 1});
  mesh.faces.add({0, 1, 2});
  const Field area{"area", 2, {1, 2, 3, 4}};
  const auto result = readByVtk(fieldsToVtp(mesh, mesh.positions, {}, std::vector{area}).bytes);
  EXPECT_EQ(valuesOf(*result->GetCellData(), "area"), (std::vector<double>{3, 4}));
}

TEST(FieldFile, NamesMayHaveLettersThatMeanSomethingToXml)
{
  const Mesh mesh = test::tetrahedron();
  const Field odd{"a<b & \"c\" 'd'>", 1, {1, 2, 3, 4}};
  const auto result = readByVtk(fieldsToVtp(mesh, mesh.positions, std::vector{odd}, {}).bytes);
  EXPECT_EQ(valuesOf(*result->GetPointData(), odd.name.c_str()), odd.values);
}

TEST(FieldFile, KeepsEveryNumberOfItsFields)
{
  const Mesh mesh = test::tetrahedron();
  const Field angle{"angle", 1, {1.0 / 3, -0.0, 1e-320, 720}};
  const Field shift{"shift", 3, {0.1, 0.2, 0.3, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const Field area{"area", 1, {0.7, 1.4, 2.1, 2.8}};
  const auto result = readByVtk(fieldsToVtp(mesh, mesh.positions, std::vector{angle, shift}, std::vector{area}).bytes);
  EXPECT_EQ(valuesOf(*result->GetPointData(), "angle"), angle.values);
  EXPECT_EQ(valuesOf(*result->GetPointData(), "shift"), shift.values);
  EXPECT_EQ(result->GetPointData()->GetArray("shift")->GetNumberOfComponents(), 3);
  EXPECT_EQ(valuesOf(*result->GetCellData(), "area"), area.values);
}

TEST(FieldFile, KeepsNumbersThatAreNone)
{
  const Mesh mesh = test::tetrahedron();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Field field{"odd", 1, {nan, infinity, -infinity, 0}};
  const auto result = readByVtk(fieldsToVtp(mesh, mesh.positions, std::vector{field}, {}).bytes);
  const std::vector<double> values = valuesOf(*result->GetPointData(), "odd");
  ASSERT_EQ(values.size(), 4U);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], infinity);
  EXPECT_EQ(values[2], -infinity);
}

TEST(FieldFile, IsTheSameOnEveryRun)
{
  const Mesh mesh = test::tetrahedron();
  const Field field{"n", 1, {1, 2, 3, 4}};
  EXPECT_EQ(fieldsToVtp(mesh, mesh.positions, std::vector{field}, {}).bytes,
            fieldsToVtp(mesh, mesh.positions, std::vector{field}, {}).bytes);
}

}  // namespace
}  // namespace holdfast
