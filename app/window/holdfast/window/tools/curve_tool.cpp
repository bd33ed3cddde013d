#include "holdfast/window/tools/curve_tool.h"

#include <QScopedValueRollback>
#include <vector>

#include <holdfast/constraints/selector.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

constexpr std::size_t kLeastPlaces = 3;

}  // namespace

CurveTool::CurveTool(Editor& editor, Viewport& viewport, QObject* parent) : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  widget_->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &CurveTool::followCurve);
  widget_->AddObserver(vtkCommand::EndInteractionEvent, this, &CurveTool::selectInside);
  connect(&editor, &Editor::vertexSelectionChanged, this, &CurveTool::followSelection);
}

QString CurveTool::hint() const
{
  if (!error_.isEmpty()) return error_;
  if (widget_->IsClosed()) return tr("Drag its places, or F: fixed, H: handle, R: rigid. Escape takes the curve away");
  const std::size_t places = widget_->GetPlaces().size();
  if (places == 0) return tr("Click places around a feature to draw a closed curve along the edges");
  if (places < kLeastPlaces) return tr("Click on; Backspace takes the last place back, Escape all");
  return tr("Click the first place, or press Enter, to close the curve; Backspace takes the last place back");
}

void CurveTool::followSurface()
{
  widget_->SetSurface(viewport().surface());
  widget_->SetRegions(editor().isOpen() ? editor().mesh().regions : nullptr);
}

void CurveTool::followDisplay()
{
  widget_->SetPixelRatio(viewport().pixelRatio());
}

void CurveTool::end()
{
  WidgetTool::end();
  widget_->Clear();
}

void CurveTool::followCurve()
{
  error_.clear();
  Q_EMIT changed();
}

void CurveTool::selectInside()
{
  if (!widget_->IsClosed()) return;
  InsideCurve curve;
  for (const Index vertex : widget_->GetPlaces()) curve.through.push_back(AtVertex{vertex});
  const Model& model = *editor().model();
  const SurfaceLocator locator = model.locator();
  CurveSelector selector(model.mesh, model.solverMesh, locator);
  const QScopedValueRollback<bool> selecting(isSelecting_, true);
  try {
    editor().selectVertices(selector.select(curve, {}), Selection{curve});
    error_.clear();
  } catch (const InputError& error) {
    error_ = tr("This curve encloses nothing: %1").arg(QString::fromStdString(error.reason()));
  }
  Q_EMIT changed();
}

void CurveTool::followSelection()
{
  if (isSelecting_ || !widget_->IsClosed()) return;
  widget_->Clear();
  widget_->Render();
  Q_EMIT changed();
}

}  // namespace holdfast
