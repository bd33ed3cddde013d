#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/mesh/poly_data.h>
#include <holdfast/widgets/picking/surface_picker.h>

#include "render/drawn_window.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// A picture in which the colour of each pixel is the number of its face, counted from 1; 0 is the background.
class FacesDrawn {
 public:
  FacesDrawn(const Model& model, int parallelProjection)
  {
    const vtkSmartPointer<vtkPolyData> data = toPolyData(model.mesh, model.mesh.positions);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (Index f = 1; f <= model.mesh.faces.size(); ++f)
      colors->InsertNextTuple3(std::floor(static_cast<double>(f) / 256), static_cast<double>(f % 256), 0);
    data->GetCellData()->SetScalars(colors);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    renderer().AddActor(actor);
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetParallelProjection(parallelProjection);
    fit(camera, defaultFrame(model.mesh.positions), model.mesh.positions, double{kWidth} / kHeight);
    renderer().ResetCameraClippingRange();
    pixels_ = window_.drawn().pixels;
  }

  [[nodiscard]] vtkRenderer& renderer() const { return window_.renderer(); }

  /// -1 for the background.
  [[nodiscard]] Index faceAt(int x, int y) const
  {
    const std::size_t first = 3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
    return Index{pixels_[first]} * 256 + Index{pixels_[first + 1]} - 1;
  }

 private:
  test::OffscreenWindow window_{{kWidth, kHeight}};
  std::vector<unsigned char> pixels_;
};

struct Count {
  int drawn = 0;     // pixels of the surface
  int mistaken = 0;  // pixels where another face is picked than is drawn
};

/// Picks at each pixel, `shift` away from it.
Count countMistakes(const Mesh& mesh, int parallelProjection, double shift)
{
  const Model model = makeModel(mesh, "mesh");
  const FacesDrawn picture(model, parallelProjection);
  const SurfacePicker picker(std::make_shared<const VisibleSurface>(model));
  Count count;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto pick = picker.pick(picture.renderer(), x + shift, y + shift, PickKind::Face, 0);
      const Index drawn = picture.faceAt(x, y);
      count.drawn += drawn >= 0 ? 1 : 0;
      count.mistaken += drawn == (pick ? pick->face : -1) ? 0 : 1;
    }
  return count;
}

TEST(Picking, FacesArePickedWhereTheyAreDrawn)
{
  for (const Mesh& mesh : {test::icosphere(3), test::quadBox({1, 2, 3}, 5), test::plate(20, 15)})
    for (const int parallelProjection : {0, 1}) {
      const Count count = countMistakes(mesh, parallelProjection, 0);
      EXPECT_GT(count.drawn, 2000);
      // The picture is drawn in single precision: pixels whose centers an edge passes by may go either way.
      EXPECT_LE(count.mistaken, count.drawn / 500);
    }
}

TEST(Picking, HalfAPixelBesideOtherFacesAreDrawn)
{
  for (const int parallelProjection : {0, 1}) {
    const Count count = countMistakes(test::icosphere(3), parallelProjection, 0.5);
    EXPECT_GT(count.mistaken, count.drawn / 50);
  }
}

}  // namespace
}  // namespace holdfast
