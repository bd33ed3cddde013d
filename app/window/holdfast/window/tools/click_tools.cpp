#include <QScopedValueRollback>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastConstraintMarkWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/tools.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

class SelectTool : public ToolOf<vtkHoldfastConstraintMarkWidget> {
 public:
  SelectTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::PickEvent, this, &SelectTool::pick);
    connect(&viewport, &Viewport::marksChanged, this, &SelectTool::followMarks);
  }

  Qt::CursorShape cursor() const override { return Qt::ArrowCursor; }

  QString hint() const override { return tr("Click a constraint to select it, drag to rotate the picture"); }

 private:
  void followMarks()
  {
    widget().GetConstraintMarkRepresentation()->SetSection(viewport().section() ? &*viewport().section() : nullptr);
    widget().SetMarks(viewport().contents() ? viewport().contents()->sharedMarks() : nullptr);
  }

  void pick(vtkObject* /*caller*/, unsigned long /*event*/, void* picked)
  {
    const auto& [constraint, isAdded] = *static_cast<const ConstraintPick*>(picked);
    if (!isAdded) return editor().selectConstraints(constraint >= 0 ? std::vector{constraint} : std::vector<Index>{});
    if (constraint < 0) return;
    auto selected = editor().selectedConstraints();
    if (std::erase(selected, constraint) == 0) selected.push_back(constraint);
    editor().selectConstraints(std::move(selected));
  }
};

class PointTool : public ToolOf<vtkHoldfastSurfacePointWidget> {
 public:
  PointTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::InteractionEvent, this, &PointTool::preview);
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &PointTool::place);
    widget().AddObserver(vtkCommand::WidgetValueChangedEvent, this, &PointTool::changed);
  }

  QString hint() const override
  {
    // In the order of `PickKind`.
    const std::array hints{tr("Click a point of the surface to hold it. V: vertices only, E: edges, F: faces"),
                           tr("Click a vertex to hold it. E: edges, F: faces, A: whatever is nearest"),
                           tr("Click an edge to hold a point of it. V: vertices, F: faces, A: whatever is nearest"),
                           tr("Click a face to hold a point of it. V: vertices, E: edges, A: whatever is nearest")};
    return hints[static_cast<std::size_t>(widget().GetKind())];
  }

  bool hasPreview() const override { return true; }

  void end() override
  {
    ToolOf::end();
    viewport().setPreview(std::nullopt);
  }

  void leave() override
  {
    widget().HidePreview();
    viewport().setPreview(std::nullopt);
  }

  bool wants(const QKeyEvent& event) const override
  {
    const char key = characterOf(event);
    return key != '\0' && widget().WantsKey(key);
  }

 private:
  void preview(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    const auto* shown = static_cast<const SurfacePick*>(pick);
    viewport().setPreview(shown != nullptr ? std::optional(*shown) : std::nullopt);
  }

  void place(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    take(*static_cast<const SurfacePick*>(pick));
  }

  virtual void take(const SurfacePick& pick) { holdPoint(editor(), pick); }
};

class ProbeTool final : public PointTool {
 public:
  using PointTool::PointTool;

  QString hint() const override
  {
    return tr("Click a point to keep its values at “Measured”. V, E, F: vertices, edges, faces only; A: any");
  }

 private:
  void take(const SurfacePick& pick) override
  {
    Measurements measurements = editor().measurements();
    measurements.probes.push_back(pick.location);
    const QString name = tr("probe %1").arg(measurements.probes.size());
    editor().setMeasurements(name, std::move(measurements));
  }
};

class RelativeTool : public ToolOf<vtkHoldfastSurfaceRulerWidget> {
 public:
  RelativeTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &RelativeTool::forgetRefusal);
    widget().AddObserver(CancelInteractionEvent, this, &RelativeTool::forgetRefusal);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &RelativeTool::keep);
    for (vtkHoldfastSurfaceRulerRepresentation* const arrow : {widget().GetRulerRepresentation(), selected_.Get()}) {
      arrow->ShowVectorOn();
      arrow->LabelVisibilityOff();
    }
    selected_->SetRenderer(&viewport.widgetRenderer());
    viewport.widgetRenderer().AddViewProp(selected_);
    connect(&editor, &Editor::constraintSelectionChanged, this, &RelativeTool::showSelected);
    connect(&editor, &Editor::stateChanged, this, &RelativeTool::showSelected);
  }

  QString hint() const override
  {
    if (!refusal_.isEmpty()) return refusal_;
    if (widget().GetLocation(0)) return tr("Click the second point; Escape takes the first one back");
    return tr("Click two points of the surface to keep the vector from the first to the second");
  }

  bool cancel() override
  {
    if (!widget().IsUnderWay()) return false;
    widget().Cancel();
    return true;
  }

 private:
  void followSurface() override
  {
    ToolOf::followSurface();
    selected_->SetSurface(viewport().surface());
  }

  void followDisplay() override
  {
    for (vtkHoldfastSurfaceRulerRepresentation* const arrow : {widget().GetRulerRepresentation(), selected_.Get()}) {
      arrow->SetPixelRatio(viewport().pixelRatio());
      arrow->SetUnits(editor().isOpen() ? editor().list().units : "");
    }
    selected_->SetVisibility(viewport().display().areConstraintsShown ? 1 : 0);
  }

  void forgetRefusal()
  {
    refusal_.clear();
    Q_EMIT changed();
  }

  void keep()
  {
    const SurfaceLocation first = *widget().GetLocation(0);
    const SurfaceLocation second = *widget().GetLocation(1);
    const bool isOnePlace = widget().GetRestDistance() == 0;
    widget().Clear();
    if (isOnePlace)
      refusal_ = tr("Both clicks took the same place, which has no vector: click two places that are apart");
    else
      addConstraint(editor(), "vector ", RelativeConstraint{second, first, {}});
    Q_EMIT changed();
  }

  void showSelected()
  {
    for (const int end : {0, 1}) selected_->GetHandle(end).SetPlacement(nullptr);
    if (!editor().isOpen() || editor().selectedConstraints().size() != 1) return;
    const Constraint& constraint = editor().list().constraints[editor().selectedConstraints().front()];
    const auto* relative = std::get_if<RelativeConstraint>(&constraint.what);
    if (relative == nullptr) return;
    try {
      selected_->GetHandle(0).SetLocation(relative->to);
      selected_->GetHandle(1).SetLocation(relative->from);
    } catch (const InputError&) {
      // The mesh has no such place: the inspector says so, and there is no arrow.
      selected_->GetHandle(0).SetPlacement(nullptr);
    }
  }

  QString refusal_;  // of the last two clicks; empty if they made a constraint
  vtkNew<vtkHoldfastSurfaceRulerRepresentation> selected_;
};

class RulerTool : public ToolOf<vtkHoldfastSurfaceRulerWidget> {
 public:
  RulerTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    setObjectName("rulerTool");
    widget().GetRulerRepresentation()->LabelVisibilityOff();
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &RulerTool::changed);
    widget().AddObserver(CancelInteractionEvent, this, &RulerTool::changed);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &RulerTool::keep);
    widget().AddObserver(NextRulerEvent, this, &RulerTool::leaveCurrent);
    connect(&editor, &Editor::annotationsChanged, this, [this] {
      if (!isChanging_ && current_) {
        current_.reset();
        widget().Clear();
      }
      showKept();
    });
  }

  void end() override
  {
    ToolOf::end();
    leaveCurrent();
    widget().Clear();
  }

  bool remove() override
  {
    if (!current_) return false;
    Measurements rest = editor().measurements();
    rest.rulers.erase(rest.rulers.begin() + *std::exchange(current_, std::nullopt));
    widget().Clear();
    editor().setMeasurements(tr("remove the ruler"), std::move(rest));
    Q_EMIT changed();
    return true;
  }

  QString hint() const override
  {
    if (widget().GetLocation(1))
      return tr("Drag an end to measure elsewhere, or click two other points; Escape takes the ruler away");
    if (widget().GetLocation(0)) return tr("Click the second point; Escape takes the first one back");
    return tr("Click two points of the surface to measure between them, now and at rest");
  }

  bool cancel() override
  {
    if (!widget().IsUnderWay()) return false;
    widget().Cancel();
    Q_EMIT changed();
    return true;
  }

 private:
  void followSurface() override
  {
    ToolOf::followSurface();
    if (editor().isOpen()) widget().SetUnits(editor().list().units);
    if (!widget().GetLocation(1)) current_.reset();
    for (const auto& ruler : kept_) ruler->SetSurface(viewport().surface());
    if (kept_.size() + (current_ ? 1 : 0) != editor().measurements().rulers.size()) showKept();
  }

  void followDisplay() override
  {
    ToolOf::followDisplay();
    for (const auto& ruler : kept_) ruler->SetPixelRatio(viewport().pixelRatio());
  }

  /// Lists the ruler that the user has placed, or has dragged an end of.
  void keep()
  {
    Measurements measurements = editor().measurements();
    if (!current_) {
      current_ = static_cast<std::ptrdiff_t>(measurements.rulers.size());
      measurements.rulers.emplace_back();
    }
    measurements.rulers[*current_] = {*widget().GetLocation(0), *widget().GetLocation(1)};
    const QScopedValueRollback<bool> changing(isChanging_, true);
    editor().setMeasurements(tr("ruler %1").arg(*current_ + 1), std::move(measurements));
  }

  void leaveCurrent()
  {
    if (std::exchange(current_, std::nullopt)) showKept();
  }

  /// The widget draws the current one.
  void showKept()
  {
    const auto& rulers = editor().measurements().rulers;
    for (const auto& ruler : kept_) viewport().widgetRenderer().RemoveViewProp(ruler);
    kept_.clear();
    for (std::size_t k = 0; k < rulers.size(); ++k) {
      if (current_ == static_cast<std::ptrdiff_t>(k)) continue;
      vtkHoldfastSurfaceRulerRepresentation& ruler = *kept_.emplace_back();
      ruler.SetRenderer(&viewport().widgetRenderer());
      ruler.LabelVisibilityOff();
      ruler.SetPixelRatio(viewport().pixelRatio());
      ruler.SetUnits(editor().list().units);
      ruler.SetSurface(viewport().surface());
      for (const int end : {0, 1}) {
        const SurfaceLocation& at = rulers[k][static_cast<std::size_t>(end)];
        const SurfacePlacement placement{at, pointOf(at, editor().model()->mesh)};
        ruler.GetHandle(end).SetPlacement(&placement);
      }
      viewport().widgetRenderer().AddViewProp(&ruler);
    }
    viewport().scheduleWidgets();
  }

  std::optional<std::ptrdiff_t> current_;                            // the ruler whose ends the widget has, in the list
  bool isChanging_ = false;                                          // this tool changes the list
  std::vector<vtkNew<vtkHoldfastSurfaceRulerRepresentation>> kept_;  // all others
};

}  // namespace

Tool* newSelectTool(Editor& editor, Viewport& viewport)
{
  return new SelectTool(editor, viewport);
}

Tool* newPointTool(Editor& editor, Viewport& viewport)
{
  return new PointTool(editor, viewport);
}

Tool* newProbeTool(Editor& editor, Viewport& viewport)
{
  return new ProbeTool(editor, viewport);
}

Tool* newRelativeTool(Editor& editor, Viewport& viewport)
{
  return new RelativeTool(editor, viewport);
}

Tool* newRulerTool(Editor& editor, Viewport& viewport)
{
  return new RulerTool(editor, viewport);
}

}  // namespace holdfast
