#include "holdfast/window/tools/tool_box.h"

#include <QAction>
#include <QApplication>

#include <holdfast/window/controls/icons.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {

ToolBox::ToolBox(Editor& editor, Viewport& viewport, QObject* parent)
    : QObject(parent),
      viewport_(viewport),
      group_(new QActionGroup(this)),
      reachesThrough_(named(new QAction(tr("Reac&h through"), this), "reachThrough"))
{
  reachesThrough_->setCheckable(true);
  reachesThrough_->setShortcut(QKeySequence("T"));
  reachesThrough_->setToolTip(tr("Rectangle and lasso select hidden vertices, too (T)"));
  const auto region = [&](RegionShape shape) { return newRegionTool(shape, editor, viewport, *reachesThrough_); };
  struct Entry {
    Tool* tool;
    const char* name;
    QString text;
    const char* key;
    QString tip;
    Sign sign;
  };
  for (const Entry& entry : {Entry{newSelectTool(editor, viewport), "toolSelect", tr("&Select"), "S",
                                   tr("Select constraints, and move them by the arrows and rings"), Sign::Select},
                             {newPointTool(editor, viewport), "toolPoint", tr("Hold &point"), "P",
                              tr("Hold a point on a vertex, on an edge or inside a face"), Sign::Point},
                             {newRelativeTool(editor, viewport), "toolRelative", tr("&Keep vector"), "K",
                              tr("Keep the vector between two points of the surface, or give it"), Sign::Relative},
                             {region(RegionShape::Brush), "toolBrush", tr("&Brush"), "B",
                              tr("Paint a region along the surface"), Sign::Brush},
                             {region(RegionShape::Rectangle), "toolRectangle", tr("Rec&tangle"), "M",
                              tr("Select vertices in a rectangle"), Sign::Rectangle},
                             {region(RegionShape::Lasso), "toolLasso", tr("&Lasso"), "L",
                              tr("Select vertices by drawing around them"), Sign::Lasso},
                             {region(RegionShape::Side), "toolFlood", tr("Si&de"), "W",
                              tr("Select a smooth side, or a whole part by a double click"), Sign::Flood},
                             {newCurveTool(editor, viewport), "toolCurve", tr("&Curve"), "C",
                              tr("Draw a closed curve around a feature on the surface"), Sign::Curve},
                             {newRulerTool(editor, viewport), "toolRuler", tr("R&uler"), "D",
                              tr("Measure between two points of the surface, now and at rest"), Sign::Ruler},
                             {newProbeTool(editor, viewport), "toolProbe", tr("&Probe"), "Q",
                              tr("Keep the values of all fields at a point of the surface"), Sign::Probe}}) {
    Tool* const tool = entry.tool;
    tool->setParent(this);
    auto* action = named(new QAction(entry.text, group_), entry.name);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(entry.key));
    action->setToolTip(QString("%1 (%2)").arg(entry.tip, entry.key));
    action->setData(static_cast<int>(entry.sign));
    connect(action, &QAction::toggled, this, [this, tool](bool isOn) {
      if (isOn) choose(tool);
    });
    connect(tool, &Tool::changed, this, [this, tool] {
      if (tool == current_) Q_EMIT hintChanged(tool->hint());
    });
  }
  drawIcons();
  chooseSelect();
}

void ToolBox::choose(Tool* tool)
{
  current_ = tool;
  viewport_.setTool(tool);
  Q_EMIT hintChanged(tool->hint());
}

void ToolBox::drawIcons()
{
  for (QAction* action : actions())
    action->setIcon(iconOf(static_cast<Sign>(action->data().toInt()), QApplication::palette()));
  reachesThrough_->setIcon(iconOf(Sign::Through, QApplication::palette()));
}

}  // namespace holdfast
