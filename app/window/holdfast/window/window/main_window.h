#pragma once
/// \file
/// The window: the picture in the middle, panels around it, and what menus and keys do.

#include <QKeySequence>
#include <QMainWindow>
#include <functional>
#include <memory>
#include <vector>

#include <holdfast/window/controls/theme.h>
#include <holdfast/window/files/autosave.h>
#include <holdfast/window/files/document_exports.h>
#include <holdfast/window/files/document_files.h>
#include <holdfast/window/model/editor.h>

class QMenu;
class QToolBar;

namespace holdfast {

class GizmoTool;
class PanelDocks;
class StatusLine;
class ToolBox;
class Viewport;
struct DroppedFiles;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  /// Draws an example that nobody sees, everything of it in every view: this compiles shaders. Without a GPU it takes
  /// some tenths of a second, in which nobody waits as long as the window is not on the screen; first pictures of
  /// meshes and of panels take as much longer without it. Before the window is shown.
  void warmUp();

  [[nodiscard]] Editor& editor() { return editor_; }
  [[nodiscard]] Viewport& viewport() { return *viewport_; }
  [[nodiscard]] GizmoTool& gizmo() { return *gizmo_; }

  [[nodiscard]] DocumentFiles& files() { return files_; }
  [[nodiscard]] DocumentExports& exports() { return exports_; }

  void setAppearance(Appearance appearance);

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void makeToolBars();
  void makeFileMenu();
  void makeEditMenu();
  void makeConstraintMenu();
  void makeSelectionMenu();
  void makeViewMenu();
  void makeHelpMenu();
  void connectFiles();
  void take(const DroppedFiles& files);
  void showContextMenu(const QPoint& place);
  void connectStatus();
  void updateTitle();
  void updateActions();
  void escape();
  void frameSelection();
  QAction* addAction(QMenu& menu, const QString& objectName, const QString& text, const QKeySequence& key,
                     const QString& tip, std::function<void()> run);

  Editor editor_;
  DocumentFiles files_;
  DocumentExports exports_;
  std::unique_ptr<Autosave> autosave_;  // null where there is no place for copies
  Viewport* viewport_;
  GizmoTool* gizmo_;
  ToolBox* tools_;
  StatusLine* status_;
  PanelDocks* panels_;
  QToolBar* toolBar_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  std::vector<QAction*> withDocument_;     // need an open document
  std::vector<QAction*> withVertices_;     // need selected vertices
  std::vector<QAction*> withConstraints_;  // need selected constraints
};

}  // namespace holdfast
