#include "holdfast/window/tools/select_tool.h"

#include <vector>

#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

SelectTool::SelectTool(Editor& editor, Viewport& viewport, QObject* parent) : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  widget_->AddObserver(vtkCommand::PickEvent, this, &SelectTool::pick);
  connect(&viewport, &Viewport::marksChanged, this, &SelectTool::followMarks);
}

QString SelectTool::hint() const
{
  return tr("Click a constraint to select it, drag to turn the picture");
}

void SelectTool::followMarks()
{
  widget_->GetConstraintMarkRepresentation()->SetSection(viewport().section());
  widget_->SetMarks(viewport().contents() ? viewport().contents()->sharedMarks() : nullptr);
}

void SelectTool::followDisplay()
{
  widget_->SetPixelRatio(viewport().pixelRatio());
}

void SelectTool::pick(vtkObject* /*caller*/, unsigned long /*event*/, void* picked)
{
  const auto& [constraint, isAdded] = *static_cast<const ConstraintPick*>(picked);
  if (!isAdded) return editor().selectConstraints(constraint ? std::vector{*constraint} : std::vector<Index>{});
  if (!constraint) return;
  auto selected = editor().selectedConstraints();
  if (std::erase(selected, *constraint) == 0) selected.push_back(*constraint);
  editor().selectConstraints(std::move(selected));
}

}  // namespace holdfast
