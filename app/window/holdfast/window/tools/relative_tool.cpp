#include <vtkRenderer.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_ruler_widget.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class RelativeTool : public ToolOf<SurfaceRulerWidget> {
 public:
  RelativeTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &RelativeTool::forgetRefusal);
    widget().AddObserver(CancelInteractionEvent, this, &RelativeTool::forgetRefusal);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &RelativeTool::keep);
    widget().GetRulerRepresentation()->ShowVectorOn();
    selected_->ShowVectorOn();
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
    for (SurfaceRulerRepresentation* const arrow : {widget().GetRulerRepresentation(), selected_.Get()}) {
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
      keepVector(editor(), second, first);
    Q_EMIT changed();
  }

  void showSelected()
  {
    for (const int end : {0, 1}) selected_->GetHandle(end).SetPlacement(std::nullopt);
    if (!editor().isOpen() || editor().selectedConstraints().size() != 1) return;
    const Constraint& constraint = editor().list().constraints[editor().selectedConstraints().front()];
    const auto* relative = std::get_if<RelativeConstraint>(&constraint.what);
    if (relative == nullptr) return;
    try {
      selected_->GetHandle(0).SetLocation(relative->to);
      selected_->GetHandle(1).SetLocation(relative->from);
    } catch (const InputError&) {
      // The mesh has no such place: the inspector says so, and there is no arrow.
      selected_->GetHandle(0).SetPlacement(std::nullopt);
    }
  }

  QString refusal_;  // of the last two clicks; empty if they made a constraint
  vtkNew<SurfaceRulerRepresentation> selected_;
};

}  // namespace

Tool* newRelativeTool(Editor& editor, Viewport& viewport)
{
  return new RelativeTool(editor, viewport);
}

}  // namespace holdfast
