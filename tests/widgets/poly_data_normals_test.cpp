#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/files/poly_data_file.h>
#include <holdfast/widgets/mesh/poly_data.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A flat strip of five squares in z = 0; `normals` are stored for points and for faces.
class StoredNormals : public testing::Test {
 protected:
  void store(const Vector3& normal)
  {
    surface_->GetPointData()->SetNormals(repeated<vtkDoubleArray>(normal, mesh_.vertexCount()));
    surface_->GetCellData()->SetNormals(repeated<vtkFloatArray>(normal, mesh_.faces.size()));
  }

  static Vector3 normalOf(vtkDataSetAttributes& attributes, vtkIdType id)
  {
    Vector3 normal;
    attributes.GetNormals()->GetTuple(id, normal.data());
    return normal;
  }

  /// The strip bent up at its last two vertices, so that only the last square moves.
  [[nodiscard]] Positions bent() const
  {
    Positions positions = mesh_.positions;
    positions(5, 2) = 1;
    positions(11, 2) = 1;
    return positions;
  }

  Mesh mesh_ = test::grid(5, 1);
  vtkSmartPointer<vtkPolyData> surface_ = toPolyData(mesh_, mesh_.positions);

 private:
  template <class Array>
  static vtkSmartPointer<Array> repeated(const Vector3& normal, Index count)
  {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName("n");
    array->SetNumberOfComponents(3);
    for (Index i = 0; i < count; ++i) array->InsertNextTuple(normal.data());
    return array;
  }
};

TEST_F(StoredNormals, StayWhereNothingMoved)
{
  const Vector3 odd(0.6, 0, 0.8);
  store(odd);
  EXPECT_THAT(refreshNormals(*surface_, mesh_, mesh_.positions), IsEmpty());
  EXPECT_THAT(refreshNormals(*surface_, mesh_, bent()), testing::SizeIs(2));
  EXPECT_EQ(normalOf(*surface_->GetPointData(), 0), odd);
  EXPECT_EQ(normalOf(*surface_->GetPointData(), 9), odd);
}

TEST_F(StoredNormals, FollowTheFacesThatMoved)
{
  store(Vector3::UnitZ());
  EXPECT_THAT(refreshNormals(*surface_, mesh_, bent()),
              ElementsAre("4 normals of points recomputed", "2 normals of faces recomputed"));
  const Vector3 slope = Vector3(-1, 0, 1).normalized();
  EXPECT_TRUE(normalOf(*surface_->GetPointData(), 5).isApprox(slope, 1e-15));
  EXPECT_TRUE(normalOf(*surface_->GetCellData(), 9).isApprox(slope, 1e-7));
  EXPECT_EQ(normalOf(*surface_->GetCellData(), 7), Vector3::UnitZ());
}

TEST_F(StoredNormals, StayOnTheSideOnWhichTheyWere)
{
  store(-Vector3::UnitZ());
  (void)refreshNormals(*surface_, mesh_, bent());
  EXPECT_LT(normalOf(*surface_->GetPointData(), 5).z(), 0);
}

TEST_F(StoredNormals, OfFacesAreCountedAfterVerticesAndLines)
{
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({0, 1});
  surface_->SetLines(line);
  mesh_.faces = polygonsOf(*surface_, "strip.vtp");
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface_->GetNumberOfCells(); ++i) normals->InsertNextTuple3(0, 0, 1);
  surface_->GetCellData()->AddArray(normals);
  (void)refreshNormals(*surface_, mesh_, bent());
  vtkDataArray& refreshed = *surface_->GetCellData()->GetArray("Normals");
  EXPECT_EQ(refreshed.GetComponent(8, 2), 1);
  EXPECT_LT(refreshed.GetComponent(9, 2), 1);
  EXPECT_EQ(normals->GetComponent(9, 2), 1) << "the array as it was read must not change";
}

}  // namespace
}  // namespace holdfast
