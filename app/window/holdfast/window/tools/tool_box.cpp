#include "holdfast/window/tools/tool_box.h"

#include <QAction>
#include <QApplication>
#include <array>

#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/tools/ruler_tool.h>
#include <holdfast/window/tools/tools.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

// In the order in which the tools are added.
constexpr std::array kSigns{Sign::Select, Sign::Point, Sign::Relative, Sign::Brush, Sign::Rectangle,
                            Sign::Lasso,  Sign::Flood, Sign::Curve,    Sign::Ruler};

}  // namespace

ToolBox::ToolBox(Editor& editor, Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport), group_(new QActionGroup(this))
{
  add(newSelectTool(editor, viewport), "toolSelect", tr("&Select"), "S",
      tr("Select constraints, and move them by the arrows and rings"));
  add(newPointTool(editor, viewport), "toolPoint", tr("Hold &point"), "P",
      tr("Hold a point on a vertex, on an edge or inside a face"));
  add(newRelativeTool(editor, viewport), "toolRelative", tr("&Keep vector"), "K",
      tr("Keep the vector between two points of the surface, or give it"));
  add(newRegionTool(RegionShape::Brush, editor, viewport), "toolBrush", tr("&Brush"), "B",
      tr("Paint a region along the surface"));
  add(newRegionTool(RegionShape::Rectangle, editor, viewport), "toolRectangle", tr("Rec&tangle"), "M",
      tr("Select vertices in a rectangle"));
  add(newRegionTool(RegionShape::Lasso, editor, viewport), "toolLasso", tr("&Lasso"), "L",
      tr("Select vertices by drawing around them"));
  add(newRegionTool(RegionShape::Side, editor, viewport), "toolFlood", tr("Si&de"), "W",
      tr("Select a smooth side, or a whole part by a double click"));
  add(newCurveTool(editor, viewport), "toolCurve", tr("&Curve"), "C",
      tr("Draw a closed curve around a feature on the surface"));
  add(new RulerTool(editor, viewport, this), "toolRuler", tr("R&uler"), "D",
      tr("Measure between two points of the surface, now and at rest"));
  drawIcons();
  chooseSelect();
}

void ToolBox::add(Tool* tool, const QString& objectName, const QString& name, const QString& key, const QString& tip)
{
  tool->setParent(this);
  auto* action = named(new QAction(name, group_), objectName);
  action->setCheckable(true);
  action->setShortcut(QKeySequence(key));
  action->setToolTip(QString("%1 (%2)").arg(tip, key));
  connect(action, &QAction::toggled, this, [this, tool](bool isOn) {
    if (isOn) choose(tool);
  });
  connect(tool, &Tool::changed, this, [this, tool] {
    if (tool == current_) Q_EMIT hintChanged(tool->hint());
  });
}

void ToolBox::choose(Tool* tool)
{
  current_ = tool;
  viewport_.setTool(tool);
  Q_EMIT hintChanged(tool->hint());
}

void ToolBox::chooseSelect()
{
  actions().front()->setChecked(true);
}

void ToolBox::drawIcons()
{
  for (int k = 0; k < actions().size(); ++k)
    actions()[k]->setIcon(iconOf(kSigns[static_cast<std::size_t>(k)], QApplication::palette()));
}

}  // namespace holdfast
