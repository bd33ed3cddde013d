#include "bench/paper/panels.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

#include "bench/paper/shape_measures.h"
#include "bench/paper/workbench.h"

namespace holdfast::paper {
namespace {

constexpr std::size_t kChannels = 3;

ViewFrame frameFor(const Look& look)
{
  const Vector3 back = look.back.normalized();
  const Vector3 right = look.up.cross(back).normalized();
  return {right, back.cross(right), back};
}

/// What `look` shows of the meshes of `panels`.
Positions placesOf(const std::vector<Panel>& panels, const Look& look)
{
  std::vector<Vector3> places;
  for (const Panel& panel : panels) {
    const Positions& positions = panel.shown->result.positions;
    for (const Index v : look.focus.empty() ? allVertices(*panel.shown->model) : look.focus)
      places.emplace_back(positions.row(v));
  }
  Positions all(static_cast<Index>(places.size()), 3);
  for (Index k = 0; k < all.rows(); ++k) all.row(k) = places[k];
  return all;
}

vtkNew<vtkActor> actorOf(const Lines& lines, double width)
{
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  for (const auto& [from, to] : lines.segments) {
    const std::array<vtkIdType, 2> ids{points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
    cells->InsertNextCell(2, ids.data());
  }
  const vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkActor> actor;
  showData(*actor, *data);
  setColor(*actor, lines.color);
  setLineWidth(*actor, width);
  actor->GetProperty()->LightingOff();
  return actor;
}

void addLabel(vtkRenderer& renderer, const std::string& label, int pixelRatio)
{
  const vtkNew<vtkTextActor> text;
  text->SetInput(label.c_str());
  text->GetTextProperty()->SetFontSize(16 * pixelRatio);
  text->GetTextProperty()->SetColor(0.13, 0.15, 0.19);
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.03, 0.92);
  renderer.AddActor2D(text);
}

Picture drawn(const Panel& panel, const ViewFrame& frame, const Positions& places, const PictureSize& size,
              const std::string& name)
{
  SceneOptions options;
  options.size = size;
  options.coloring = coloringOf(*panel.shown->model, panel.shown->result, {panel.colorBy, panel.range, {}}, "");
  options.colorBy = ColorBy::None;
  options.legend = Legend::Hidden;
  Scene scene(*panel.shown->model, panel.shown->result, options);
  scene.contents().setMeshEdges(panel.edges);
  scene.contents().setRestGhost(panel.ghost);
  scene.setBackdrop({1, 1, 1});
  for (const Lines& lines : panel.lines) scene.meshRenderer().AddActor(actorOf(lines, 1.5 * scene.pixelRatio()));
  addLabel(scene.meshRenderer(), panel.label, scene.pixelRatio());
  fit(*scene.meshRenderer().GetActiveCamera(), frame, places, static_cast<double>(size.width) / size.height);
  scene.meshRenderer().ResetCameraClippingRange();
  return draw(scene, name);
}

Picture pixelsOf(vtkRenderWindow& window)
{
  const int* const size = window.GetSize();
  const vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return {{size[0], size[1]}, {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()}};
}

/// The mean of 2 x 2 pixels each.
Picture halved(const Picture& picture)
{
  const std::size_t width = kChannels * picture.size.width;  // of a row of `picture`
  Picture half{{picture.size.width / 2, picture.size.height / 2}, {}};
  for (std::size_t y = 0; y + 1 < static_cast<std::size_t>(picture.size.height); y += 2)
    for (std::size_t x = 0; x < width; x += (x % kChannels == kChannels - 1) ? kChannels + 1 : 1) {
      const unsigned char* const first = picture.pixels.data() + y * width + x;
      half.pixels.push_back(
          static_cast<unsigned char>((first[0] + first[kChannels] + first[width] + first[width + kChannels] + 2) / 4));
    }
  return half;
}

}  // namespace

Deformed deformed(const std::string& mesh, const std::string& constraints, const DeformOptions& options)
{
  auto model = std::make_unique<const Model>(makeModel(readMesh(mesh).mesh, mesh));
  DeformResult result = deform(*model, readConstraints(constraints), constraints, options);
  return {std::move(model), std::move(result)};
}

Picture tiled(const std::vector<Picture>& pictures, int columns)
{
  constexpr unsigned char kWhite = 255;
  const PictureSize one = pictures.front().size;
  const int count = static_cast<int>(pictures.size());
  const int rows = (count + columns - 1) / columns;
  Picture whole{{one.width * std::min(columns, count), one.height * rows}, {}};
  whole.pixels.assign(kChannels * whole.size.width * whole.size.height, kWhite);
  for (int k = 0; k < count; ++k)
    for (int y = 0; y < one.height; ++y) {
      const int row = one.height * (rows - 1 - k / columns) + y;
      const auto from = pictures[k].pixels.begin() + static_cast<std::ptrdiff_t>(kChannels) * one.width * y;
      const std::size_t to = kChannels * (static_cast<std::size_t>(whole.size.width) * row +
                                          static_cast<std::size_t>(one.width) * (k % columns));
      std::copy_n(from, static_cast<std::ptrdiff_t>(kChannels) * one.width,
                  whole.pixels.begin() + static_cast<std::ptrdiff_t>(to));
    }
  return whole;
}

std::vector<Picture> drawnPanels(const std::vector<Panel>& panels, const Look& look)
{
  const Positions together = placesOf(panels, look);
  std::vector<Picture> pictures;
  for (const Panel& panel : panels) {
    const Positions places = look.frame == Frame::OwnMesh ? placesOf({panel}, look) : together;
    pictures.push_back(drawn(panel, frameFor(look), places, look.panel, panel.label));
  }
  return pictures;
}

void drawPanels(const std::string& path, const std::vector<Panel>& panels, const Look& look)
{
  writeFile(path, toPng(tiled(drawnPanels(panels, look), look.columns), path));
}

Picture drawnSphere(const std::string& label, const Deformed& shown, const PictureSize& size)
{
  constexpr int kRatio = 2;
  const vtkNew<vtkRenderWindow> window;
  const vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kRatio * size.width, kRatio * size.height);
  window->AddRenderer(renderer);
  RotationSphere sphere;
  sphere.addTo(*renderer);
  sphere.setLook({.background = {1, 1, 1}, .pixelRatio = kRatio});
  sphere.show(placeRotations(*shown.model, shown.result, nullptr));
  sphere.setColoring(coloringOf(*shown.model, shown.result, ColorBy::Angle, ""));
  sphere.fitCamera();
  addLabel(*renderer, label, kRatio);
  window->Render();
  return halved(pixelsOf(*window));
}

}  // namespace holdfast::paper
