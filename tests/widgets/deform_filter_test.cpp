#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <holdfast/deform/fields.h>
#include <holdfast/widgets/mesh/poly_data.h>

#include "holdfast/widgets/mesh/vtkHoldfastDeform.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

/// Counts the events of one kind, and keeps VTK from printing errors.
class Count : public vtkCommand {
 public:
  static Count* New() { return new Count; }
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override { ++times; }
  int times = 0;
};

ConstraintList lifted(double height)
{
  return test::listOf({test::hold({0, 1, 2}), test::moveTo(AtVertex{11}, {3, 2, height})});
}

struct FilteredGrid : testing::Test {
  FilteredGrid()
  {
    input->ShallowCopy(toPolyData(mesh, mesh.positions));
    filter->SetInputData(input);
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->AddObserver(vtkCommand::ProgressEvent, steps);
  }

  [[nodiscard]] Positions positions()
  {
    filter->Update();
    return positionsOf(*filter->GetOutput());
  }

  const Mesh mesh = test::grid(3, 2);
  vtkNew<vtkPolyData> input;
  vtkNew<vtkHoldfastDeform> filter;
  vtkNew<Count> errors;
  vtkNew<Count> steps;
};

TEST_F(FilteredGrid, IsAtRestWithoutConstraints)
{
  EXPECT_EQ(positions(), mesh.positions);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), mesh.faces.size());
}

TEST_F(FilteredGrid, IsTheDeformationWithItsFields)
{
  filter->SetConstraints(lifted(1));
  const Model model = makeModel(mesh);
  const DeformResult expected = deform(model, lifted(1));
  EXPECT_EQ(positions(), expected.positions);
  EXPECT_EQ(filter->GetReport().solve.message, expected.report.solve.message);
  for (const Field& field : fieldsOf(model, expected))
    EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray(field.name.c_str()), nullptr) << field.name;
}

TEST_F(FilteredGrid, FactorisesNothingForAnotherTargetAndAnewForAnotherInput)
{
  filter->SetConstraints(lifted(1));
  static_cast<void>(positions());
  const int first = steps->times;
  filter->SetConstraints(lifted(2));
  EXPECT_EQ(positions(), deform(makeModel(mesh), lifted(2)).positions);
  const int second = steps->times - first;
  EXPECT_LT(second, first);
  input->GetPoints()->SetPoint(5, 1, 1, 0.5);
  input->GetPoints()->Modified();
  const Mesh other{positionsOf(*input), mesh.faces};
  EXPECT_EQ(positions(), deform(makeModel(other), lifted(2)).positions);
  EXPECT_GT(steps->times - first - second, second);
}

TEST_F(FilteredGrid, OtherOptionsCount)
{
  filter->SetConstraints(lifted(1));
  filter->SetOptions({Weights::Uniform, {}});
  EXPECT_EQ(positions(), deform(makeModel(mesh), lifted(1), "list", {Weights::Uniform, {}}).positions);
}

TEST_F(FilteredGrid, SaysWhatIsUnusableAndHasNoOutput)
{
  filter->SetConstraints(test::listOf({test::hold({0, 99})}));
  EXPECT_EQ(positions().rows(), 0);
  EXPECT_GT(errors->times, 0);
  filter->SetConstraints(lifted(1));
  EXPECT_EQ(positions().rows(), mesh.vertexCount());
}

TEST_F(FilteredGrid, EndsWhenItIsAborted)
{
  filter->SetConstraints(lifted(1));
  struct Aborting : vtkCommand {
    static Aborting* New() { return new Aborting; }
    void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  };
  vtkNew<Aborting> aborting;
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, aborting);
  EXPECT_EQ(positions().rows(), 0);
  EXPECT_EQ(errors->times, 0);
  filter->RemoveObserver(tag);
  filter->Modified();
  EXPECT_EQ(positions().rows(), mesh.vertexCount());
}

TEST_F(FilteredGrid, ForgetsAnAbortThatCameAfterTheLastStep)
{
  filter->SetConstraints(lifted(1));
  ASSERT_EQ(positions().rows(), mesh.vertexCount());
  filter->SetAbortExecute(1);
  EXPECT_EQ(positions().rows(), mesh.vertexCount());
}

}  // namespace
}  // namespace holdfast
