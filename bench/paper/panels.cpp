#include "bench/paper/panels.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkLineSource.h>
#include <vtkPoints.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/mesh/actors.h>

#include "bench/paper/workbench.h"

namespace holdfast::paper {
namespace {

ViewFrame frameFor(const Look& look)
{
  const Vector3 back = look.back.normalized();
  const Vector3 right = look.up.cross(back).normalized();
  return {right, back.cross(right), back};
}

/// The places of all panels, which share one camera.
Positions placesOf(const std::vector<Panel>& panels)
{
  Index count = 0;
  for (const Panel& panel : panels) count += panel.shown->result.positions.rows();
  Positions all(count, 3);
  Index row = 0;
  for (const Panel& panel : panels) {
    all.middleRows(row, panel.shown->result.positions.rows()) = panel.shown->result.positions;
    row += panel.shown->result.positions.rows();
  }
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
  options.colorBy = panel.colorBy;
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

}  // namespace

Deformed deformed(const std::string& mesh, const std::string& constraints, const DeformOptions& options)
{
  auto model = std::make_unique<const Model>(makeModel(readMesh(mesh).mesh, mesh));
  DeformResult result = deform(*model, readConstraints(constraints), constraints, options);
  return {std::move(model), std::move(result)};
}

Picture tiled(const std::vector<Picture>& pictures, int columns)
{
  constexpr std::size_t kChannels = 3;
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
      const std::size_t to = kChannels * (static_cast<std::size_t>(whole.size.width) * row + one.width * (k % columns));
      std::copy_n(from, kChannels * one.width, whole.pixels.begin() + static_cast<std::ptrdiff_t>(to));
    }
  return whole;
}

void drawPanels(const std::string& path, const std::vector<Panel>& panels, const Look& look)
{
  const Positions places = placesOf(panels);
  std::vector<Picture> pictures;
  for (const Panel& panel : panels) pictures.push_back(drawn(panel, frameFor(look), places, look.panel, path));
  writeFile(path, toPng(tiled(pictures, look.columns), path));
}

}  // namespace holdfast::paper
