#include <vector>

#include <holdfast/widgets/interaction/constraint_mark_widget.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class SelectTool : public ToolOf<ConstraintMarkWidget> {
 public:
  SelectTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::PickEvent, this, &SelectTool::pick);
    connect(&viewport, &Viewport::marksChanged, this, &SelectTool::followMarks);
  }

  Qt::CursorShape cursor() const override { return Qt::ArrowCursor; }

  QString hint() const override { return tr("Click a constraint to select it, drag to turn the picture"); }

 private:
  void followMarks()
  {
    widget().GetConstraintMarkRepresentation()->SetSection(viewport().section());
    widget().SetMarks(viewport().contents() ? viewport().contents()->sharedMarks() : nullptr);
  }

  void pick(vtkObject* /*caller*/, unsigned long /*event*/, void* picked)
  {
    const auto& [constraint, isAdded] = *static_cast<const ConstraintPick*>(picked);
    if (!isAdded) return editor().selectConstraints(constraint ? std::vector{*constraint} : std::vector<Index>{});
    if (!constraint) return;
    auto selected = editor().selectedConstraints();
    if (std::erase(selected, *constraint) == 0) selected.push_back(*constraint);
    editor().selectConstraints(std::move(selected));
  }
};

}  // namespace

Tool* newSelectTool(Editor& editor, Viewport& viewport)
{
  return new SelectTool(editor, viewport);
}

}  // namespace holdfast
