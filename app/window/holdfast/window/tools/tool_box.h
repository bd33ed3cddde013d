#pragma once
/// Holds the tools of the viewport, one of which is chosen, and the actions that choose them.

#include <QActionGroup>

#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

class ToolBox : public QObject {
  Q_OBJECT

 public:
  ToolBox(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QList<QAction*> actions() const { return group_->actions(); }
  /// Returns a switch that makes rectangle and lasso select hidden vertices, too. Its state is remembered.
  [[nodiscard]] QAction* reachesThrough() const { return reachesThrough_; }
  [[nodiscard]] const Tool& current() const { return *current_; }
  void chooseSelect() { actions().front()->setChecked(true); }
  void drawIcons();

 Q_SIGNALS:
  void hintChanged(const QString& hint);

 private:
  void choose(Tool* tool);

  Viewport& viewport_;
  QActionGroup* group_;
  QAction* reachesThrough_;
  Tool* current_ = nullptr;
};

}  // namespace holdfast
