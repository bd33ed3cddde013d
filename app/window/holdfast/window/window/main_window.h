#pragma once
/// The window, with the picture in the middle and panels around it. It decides what menus and keys do.

#include <QActionGroup>
#include <QCloseEvent>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <holdfast/window/files/autosave.h>
#include <holdfast/window/files/document_exports.h>
#include <holdfast/window/files/document_files.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/tools/gizmo_tool.h>
#include <holdfast/window/tools/tool_box.h>
#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/window/panel_docks.h>
#include <holdfast/window/window/remembered.h>
#include <holdfast/window/window/status_line.h>

namespace holdfast {

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  /// Draws an example in every view. Call it before the window is shown: compiling shaders takes some tenths of a
  /// second.
  void warmUp();

  /// Makes the window look as it did when it was closed last, and keeps how it looks when it is closed. Call it before
  /// the window is shown.
  void remember();

  [[nodiscard]] Editor& editor() { return editor_; }
  [[nodiscard]] Viewport& viewport() { return *viewport_; }
  [[nodiscard]] GizmoTool& gizmo() { return *gizmo_; }

  [[nodiscard]] DocumentFiles& files() { return files_; }
  [[nodiscard]] DocumentExports& exports() { return exports_; }

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void makeToolBars();
  void drawIcons();
  void makeFileMenu();
  void makeEditMenu();
  void makeConstraintMenu();
  void makeSelectionMenu();
  void keepSymmetric();
  void addMirrors(QMenu& menu);
  void askForSectionPlane();
  void selectBesidePlane();
  void makeViewMenu();
  void makeHelpMenu();
  void connectFiles();
  void rememberSwitch(QAction& action);
  void rememberLayout();
  void setUnit(const QString& unit);
  void showPreferences();
  void resetSettings();
  void keepPicture();
  void take(const QStringList& paths);
  void showContextMenu(const QPoint& place);
  void connectStatus();
  void updateTitle();
  void updateActions();
  void escape();

  enum class Needs { Nothing, Document, Vertices, Constraints, Measurements };
  /// An entry of a menu. An entry without a text is a separator.
  struct Item {
    const char* name = "";
    QString text;
    const char* key = "";
    QString tip;
    Needs needs = Needs::Nothing;
    std::function<void()> run = {};
  };
  static const Item kSeparator;
  QAction* addAction(QMenu& menu, const Item& item);
  QAction* addSwitch(QMenu& menu, const Item& item);
  void addActions(QMenu& menu, const std::vector<Item>& items)
  {
    for (const Item& item : items) item.text.isEmpty() ? menu.addSeparator() : addAction(menu, item);
  }
  /// Adds entries of which one is chosen. At first this is the first.
  void addChoices(QMenu& menu, const std::vector<Item>& items);

  Editor editor_;
  DocumentFiles files_;
  DocumentExports exports_;
  std::unique_ptr<Autosave> autosave_;  // null where there is no place for copies
  Viewport* viewport_;
  GizmoTool* gizmo_;
  ToolBox* tools_;
  StatusLine* status_;
  PanelDocks* panels_;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  std::vector<std::pair<QAction*, Needs>> needs_;
  QList<QActionGroup*> choices_;
  std::optional<Remembered> remembered_;  // none in a window that remembers nothing
  QString unit_;                          // of documents that name none
  QTimer pictureDelay_;                   // until what was opened or saved is drawn
};

}  // namespace holdfast
