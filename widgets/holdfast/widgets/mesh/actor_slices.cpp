#include "holdfast/widgets/mesh/actor_slices.h"

#include <algorithm>

#include <vtkPointData.h>
#include <vtkPoints.h>

namespace holdfast {
namespace {

vtkSmartPointer<vtkCellArray> someOf(vtkCellArray& cells, Index begin, Index end)
{
  auto some = vtkSmartPointer<vtkCellArray>::New();
  some->AllocateExact(end - begin, (end - begin) * cells.GetMaxCellSize());
  for (Index k = begin; k < end; ++k) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells.GetCellAtId(k, count, corners);
    some->InsertNextCell(count, corners);
  }
  return some;
}

/// All but the cells.
void share(vtkPolyData& whole, vtkPolyData& slice)
{
  slice.SetPoints(whole.GetPoints());
  slice.GetPointData()->SetNormals(whole.GetPointData()->GetNormals());
  slice.GetPointData()->SetScalars(whole.GetPointData()->GetScalars());
}

void share(vtkPolyDataMapper& whole, vtkPolyDataMapper& slice)
{
  slice.SetScalarVisibility(whole.GetScalarVisibility());
  slice.SetInterpolateScalarsBeforeMapping(whole.GetInterpolateScalarsBeforeMapping());
  slice.SetUseLookupTableScalarRange(whole.GetUseLookupTableScalarRange());
  if (whole.GetScalarVisibility() != 0) slice.SetLookupTable(whole.GetLookupTable());
  slice.SetClippingPlanes(whole.GetClippingPlanes());
}

}  // namespace

vtkCellArray& ActorSlices::cells() const
{
  vtkPolyData& data = *whole_.GetInput();
  return data.GetNumberOfPolys() > 0 ? *data.GetPolys() : *data.GetLines();
}

void ActorSlices::make(Index slice)
{
  vtkPolyData& whole = *whole_.GetInput();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const Index begin = slice * kSliceCells;
  const auto some = someOf(cells(), begin, std::min<Index>(begin + kSliceCells, cells().GetNumberOfCells()));
  if (whole.GetNumberOfPolys() > 0)
    data->SetPolys(some);
  else
    data->SetLines(some);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  slices_[slice] = {data, mapper};
}

void ActorSlices::show(Index slice)
{
  if (cells().GetMTime() != cellsTime_) slices_.clear();
  cellsTime_ = cells().GetMTime();
  slices_.resize(static_cast<std::size_t>(count()));
  if (slices_[slice].data == nullptr) make(slice);
  share(*whole_.GetInput(), *slices_[slice].data);
  share(whole_, *slices_[slice].mapper);
  actor_.SetMapper(slices_[slice].mapper);
}

}  // namespace holdfast
