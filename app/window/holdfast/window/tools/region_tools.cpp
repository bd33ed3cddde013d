#include <QAction>
#include <QScopedValueRollback>
#include <QString>
#include <array>
#include <vector>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h>
#include <holdfast/window/tools/tools.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

class RegionTool : public ToolOf<vtkHoldfastRegionWidget> {
 public:
  RegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QAction& reachesThrough) : ToolOf(editor, viewport)
  {
    widget().SetShape(shape);
    widget().AddObserver(vtkCommand::StartInteractionEvent, this, &RegionTool::start);
    widget().AddObserver(vtkCommand::InteractionEvent, this, &RegionTool::reach);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &RegionTool::reach);
    widget().AddObserver(CancelInteractionEvent, this, &RegionTool::restore);
    widget().AddObserver(vtkCommand::WidgetValueChangedEvent, this, &RegionTool::changed);
    const auto followSwitch = [this](bool isThrough) {
      widget().SetReach(isThrough ? ScreenReach::Through : ScreenReach::VisibleOnly);
      Q_EMIT changed();
    };
    connect(&reachesThrough, &QAction::toggled, this, followSwitch);
    followSwitch(reachesThrough.isChecked());
  }

  QString hint() const override
  {
    const QString outline =
        ' ' + (widget().GetReach() == ScreenReach::Through
                   ? tr("Hidden ones, too. Shift adds, Ctrl removes, T: only seen ones. Then F, H or R")
                   : tr("Shift adds, Ctrl removes, T reaches through. Then F: fixed, H: handle, R: rigid"));
    // In the order of `RegionShape`.
    const std::array hints{tr("Paint a region. Shift adds, Ctrl removes, [ and ] size the brush. Then F: fixed, "
                              "H: handle, R: rigid"),
                           tr("Drag a rectangle.") + outline, tr("Draw around vertices.") + outline,
                           sideHint().arg(widget().GetSideAngle())};
    return hints[static_cast<std::size_t>(widget().GetShape())];
  }

  void leave() override { widget().HideCircle(); }
  bool cancel() override { return widget().Cancel(); }

 private:
  [[nodiscard]] QString sideHint() const
  {
    const QString rest = ' ' + tr("Double click: a part. Shift adds, Ctrl removes");
    if (widget().GetBendFrom() == BendFrom::Neighbour)
      return tr("Click a side: < %1° at each edge ([, ]; N: from the face).") + rest;
    return tr("Click a side: < %1° from the face ([, ]; N: at each edge).") + rest;
  }

  void start()
  {
    before_ = editor().selectedVertices();
    ofModel_ = editor().model();
  }

  void reach(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
  {
    const auto& [reached, mode] = *static_cast<const RegionCallData*>(callData);
    editor().selectVertices(joined(before_, viewport().shownAmong(reached), mode));
  }

  void restore()
  {
    // Another document may have been opened meanwhile.
    if (editor().isOpen() && ofModel_.lock() == editor().model()) editor().selectVertices(before_);
  }

  std::vector<Index> before_;           // the selection when the gesture began
  std::weak_ptr<const Model> ofModel_;  // the model at that time
};

constexpr std::size_t kLeastPlaces = 3;

class CurveTool : public ToolOf<vtkHoldfastSurfaceCurveWidget> {
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
      select(editor().mesh().selector->select(selection, {}), selection);
      error_.clear();
    } catch (const InputError& error) {
      error_ = tr("This curve encloses nothing: %1").arg(QString::fromStdString(error.reason()));
    }
    Q_EMIT changed();
  }

  /// Constraints keep the curve where nothing inside is hidden, else the vertices that are shown.
  void select(const std::vector<Index>& inside, const Selection& curve)
  {
    std::vector<Index> shown = viewport().shownAmong(inside);
    const bool isWhole = shown.size() == inside.size();
    editor().selectVertices(std::move(shown), isWhole ? std::optional(curve) : std::nullopt);
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

Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QAction& reachesThrough)
{
  return new RegionTool(shape, editor, viewport, reachesThrough);
}

Tool* newCurveTool(Editor& editor, Viewport& viewport)
{
  return new CurveTool(editor, viewport);
}

}  // namespace holdfast
