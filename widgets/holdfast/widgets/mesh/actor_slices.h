#pragma once
/// A large mesh, some of its cells at a time.

#include <vector>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <holdfast/base/types.h>

namespace holdfast {

/// Triangles, or lines, that are drawn in a few milliseconds without a GPU.
inline constexpr Index kSliceCells = 20'000;

/// The cells of one actor in their order, cut into slices that share its points. They are made when first shown.
class ActorSlices {
 public:
  /// Slices the polygons, or else the lines, of `whole`, a mapper of `actor`. Both stay alive as long as this.
  ActorSlices(vtkActor& actor, vtkPolyDataMapper& whole) : actor_(actor), whole_(whole) {}
  ActorSlices(const ActorSlices&) = delete;
  ActorSlices& operator=(const ActorSlices&) = delete;

  [[nodiscard]] vtkActor& actor() const noexcept { return actor_; }
  [[nodiscard]] Index count() const { return (cells().GetNumberOfCells() + kSliceCells - 1) / kSliceCells; }
  /// The actor draws one of `count` slices only, until it is given another mapper. O(`kSliceCells`) the first time.
  void show(Index slice);
  void showWhole() { actor_.SetMapper(&whole_); }

 private:
  struct Slice {
    vtkSmartPointer<vtkPolyData> data;  // null until it is first shown
    vtkSmartPointer<vtkPolyDataMapper> mapper;
  };

  [[nodiscard]] vtkCellArray& cells() const;
  void make(Index slice);

  vtkActor& actor_;
  vtkPolyDataMapper& whole_;
  vtkMTimeType cellsTime_ = 0;
  std::vector<Slice> slices_;
};

}  // namespace holdfast
