#include "holdfast/window/tools/relative_tool.h"

#include <vtkRenderer.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/window/model/commands.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

RelativeTool::RelativeTool(Editor& editor, Viewport& viewport, QObject* parent) : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  widget_->AddObserver(vtkCommand::PlacePointEvent, this, &RelativeTool::forgetRefusal);
  widget_->AddObserver(CancelInteractionEvent, this, &RelativeTool::forgetRefusal);
  widget_->AddObserver(vtkCommand::EndInteractionEvent, this, &RelativeTool::keep);
  widget_->GetRulerRepresentation()->ShowVectorOn();
  selected_->ShowVectorOn();
  selected_->SetRenderer(&viewport.widgetRenderer());
  viewport.widgetRenderer().AddViewProp(selected_);
  connect(&editor, &Editor::constraintSelectionChanged, this, &RelativeTool::showSelected);
  connect(&editor, &Editor::stateChanged, this, &RelativeTool::showSelected);
}

QString RelativeTool::hint() const
{
  if (!refusal_.isEmpty()) return refusal_;
  if (widget_->GetLocation(0)) return tr("Click the second point; Escape takes the first one back");
  return tr("Click two points of the surface to keep the vector from the first to the second");
}

void RelativeTool::followSurface()
{
  widget_->SetSurface(viewport().surface());
  selected_->SetSurface(viewport().surface());
}

void RelativeTool::followDisplay()
{
  for (SurfaceRulerRepresentation* const arrow : {widget_->GetRulerRepresentation(), selected_.Get()}) {
    arrow->SetPixelRatio(viewport().pixelRatio());
    arrow->SetUnits(editor().isOpen() ? editor().list().units : "");
  }
  selected_->SetVisibility(viewport().display().areConstraintsShown ? 1 : 0);
}

bool RelativeTool::cancel()
{
  if (!widget_->IsUnderWay()) return false;
  widget_->Cancel();
  return true;
}

void RelativeTool::forgetRefusal()
{
  refusal_.clear();
  Q_EMIT changed();
}

void RelativeTool::keep()
{
  const SurfaceLocation first = *widget_->GetLocation(0);
  const SurfaceLocation second = *widget_->GetLocation(1);
  const bool isOnePlace = widget_->GetRestDistance() == 0;
  widget_->Clear();
  if (isOnePlace)
    refusal_ = tr("Both clicks took the same place, which has no vector: click two places that are apart");
  else
    keepVector(editor(), second, first);
  Q_EMIT changed();
}

void RelativeTool::showSelected()
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
    // A place that the mesh does not have: the inspector says so, and there is no arrow.
    selected_->GetHandle(0).SetPlacement(std::nullopt);
  }
}

}  // namespace holdfast
