#pragma once
/// Slices draw a large mesh some of its cells at a time.

#include <vector>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// So many triangles or lines are drawn in a few milliseconds without a GPU.
inline constexpr Index kSliceCells = 20'000;

/// The cells of one actor in their order, cut into slices that share its points. A slice is made when it is first
/// shown.
class ActorSlices {
 public:
  /// Slices the polygons of `whole`, or else its lines. `whole` is a mapper of `actor`. Both must stay alive as long as
  /// the slices.
  ActorSlices(vtkActor& actor, vtkPolyDataMapper& whole) : actor_(actor), whole_(whole) {}
  ActorSlices(const ActorSlices&) = delete;
  ActorSlices& operator=(const ActorSlices&) = delete;

  [[nodiscard]] vtkActor& actor() const noexcept { return actor_; }
  /// Returns the number of slices.
  [[nodiscard]] Index count() const { return (cells().GetNumberOfCells() + kSliceCells - 1) / kSliceCells; }
  /// Makes the actor draw only one of the `count` slices, until it is given another mapper. O(`kSliceCells`) the first
  /// time.
  void show(Index slice);
  /// Makes the actor draw all its cells again.
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
