#pragma once
/// Holds the panels around the picture, and connects them and the picture.

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

#include <holdfast/widgets/scene/example_document.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/panels/color_panel.h>
#include <holdfast/window/panels/histogram_panel.h>
#include <holdfast/window/panels/sphere_panel.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// The docks are two stacks of tabs at the right. Constraints, colours and rotations are above; the selection and
/// results are below.
class PanelDocks : public QObject {
  Q_OBJECT

 public:
  PanelDocks(Editor& editor, Viewport& viewport, QMainWindow& window);

  void fillMenu(QMenu& menu) const;

  void warmUp(const ExampleDocument& example) { sphere_->warmUp(example); }

  void share(const QSize& size);

  void followViewport();

  /// Brings the panel of colours to the front, and gives it the keyboard focus.
  void showColors();
  /// Brings the panel of the solution to the front, and gives the line of the welding tolerance the keyboard focus.
  void showWelding();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void yield();
  void bringToFront(const char* dock);
  QDockWidget* add(const QString& title, const QString& objectName, QWidget* panel);
  void arrange();
  void countConflicts();
  void countWarnings();

  Editor& editor_;
  Viewport& viewport_;
  QMainWindow& window_;
  ColorPanel* colors_ = nullptr;
  SpherePanel* sphere_ = nullptr;
  HistogramPanel* histograms_ = nullptr;
  QDockWidget* conflicts_ = nullptr;
  QDockWidget* findings_ = nullptr;
  QList<QDockWidget*> upper_;
  QList<QDockWidget*> lower_;
};

}  // namespace holdfast
