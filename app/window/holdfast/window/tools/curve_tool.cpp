#include <QScopedValueRollback>
#include <QString>

#include <holdfast/base/error.h>
#include <holdfast/widgets/interaction/surface_curve_widget.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

constexpr std::size_t kLeastPlaces = 3;

class CurveTool : public ToolOf<SurfaceCurveWidget> {
 public:
  CurveTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::WidgetValueChangedEvent, this, &CurveTool::followCurve);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &CurveTool::selectInside);
    connect(&editor, &Editor::vertexSelectionChanged, this, &CurveTool::followSelection);
  }

  QString hint() const override
  {
    if (!error_.isEmpty()) return error_;
    if (widget().IsClosed())
      return tr("Drag its places, or F: fixed, H: handle, R: rigid. Escape takes the curve away");
    const std::size_t places = widget().GetPlaces().size();
    if (places == 0) return tr("Click places around a feature to draw a closed curve along the edges");
    if (places < kLeastPlaces) return tr("Click on; Backspace takes the last place back, Escape all");
    return tr("Click the first place, or press Enter, to close the curve; Backspace takes the last place back");
  }

  void end() override
  {
    ToolOf::end();
    widget().Clear();
  }

  bool cancel() override { return widget().Cancel(); }

 private:
  void followCurve()
  {
    error_.clear();
    Q_EMIT changed();
  }

  void selectInside()
  {
    if (!widget().IsClosed()) return;
    InsideCurve curve;
    for (const Index vertex : widget().GetPlaces()) curve.through.push_back(AtVertex{vertex});
    const Selection selection{curve};
    const QScopedValueRollback<bool> selecting(isSelecting_, true);
    try {
      editor().selectVertices(editor().mesh().selector->select(selection, {}), selection);
      error_.clear();
    } catch (const InputError& error) {
      error_ = tr("This curve encloses nothing: %1").arg(QString::fromStdString(error.reason()));
    }
    Q_EMIT changed();
  }

  void followSelection()
  {
    if (isSelecting_ || !widget().IsClosed()) return;
    widget().Clear();
    widget().Render();
    Q_EMIT changed();
  }

  QString error_;  // why the closed curve selects nothing
  bool isSelecting_ = false;
};

}  // namespace

Tool* newCurveTool(Editor& editor, Viewport& viewport)
{
  return new CurveTool(editor, viewport);
}

}  // namespace holdfast
