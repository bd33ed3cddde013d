#include <array>
#include <utility>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/mesh/actors.h>

#include "render/drawn_window.h"

namespace holdfast {
namespace {

using Rgb = std::array<int, 3>;

/// A square across the view, at a depth.
void setUpSheet(vtkActor& actor, double z, const Rgb& color, double opacity)
{
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
    corners->InsertNextPoint(x, y, z);
  vtkNew<vtkCellArray> square;
  square->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> sheet;
  sheet->SetPoints(corners);
  sheet->SetPolys(square);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(sheet);
  actor.SetMapper(mapper);
  actor.GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  actor.GetProperty()->SetOpacity(opacity);
  actor.GetProperty()->LightingOff();
}

/// The middle of the picture of both, drawn in this order.
Rgb middleOf(vtkActor& first, vtkActor& second)
{
  constexpr PictureSize kFewPixels{20, 20};
  const test::OffscreenWindow window(kFewPixels);
  window.renderer().AddActor(&first);
  window.renderer().AddActor(&second);
  window.renderer().GetActiveCamera()->ParallelProjectionOn();
  window.renderer().ResetCamera();
  const Picture picture = window.drawn();
  const unsigned char* const pixel = &picture.pixels[3 * (10 * kFewPixels.width + 10)];
  return {pixel[0], pixel[1], pixel[2]};
}

constexpr Rgb kGreen{0, 200, 0};
constexpr Rgb kBlue{0, 0, 200};

TEST(BlendedActor, ShowsWhatIsBehindIt)
{
  vtkNew<vtkActor> behind;
  vtkNew<BlendedActor> sheet;
  setUpSheet(*behind, -1, kBlue, 1);
  setUpSheet(*sheet, 0, kGreen, 0.5);
  EXPECT_EQ(middleOf(*behind, *sheet), (Rgb{0, 100, 100}));
}

TEST(BlendedActor, HidesNothingThatIsDrawnAfterIt)
{
  vtkNew<vtkActor> behind;
  vtkNew<BlendedActor> sheet;
  setUpSheet(*behind, -1, kBlue, 1);
  setUpSheet(*sheet, 0, kGreen, 0.5);
  EXPECT_EQ(middleOf(*sheet, *behind), kBlue);

  // An actor of VTK's that is drawn at the same time does.
  vtkNew<vtkActor> forced;
  forced->ForceOpaqueOn();
  setUpSheet(*forced, 0, kGreen, 0.5);
  EXPECT_NE(middleOf(*forced, *behind), kBlue);
}

TEST(BlendedActor, IsHiddenByWhatIsBeforeIt)
{
  vtkNew<vtkActor> before;
  vtkNew<BlendedActor> sheet;
  setUpSheet(*before, 1, kBlue, 1);
  setUpSheet(*sheet, 0, kGreen, 0.5);
  EXPECT_EQ(middleOf(*before, *sheet), kBlue);
}

}  // namespace
}  // namespace holdfast
