#pragma once
/// The panels around the picture, and the connections between them and the picture.

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

/// Two stacks of tabs at the right: constraints, colours and rotations above; the selection and results below.
class PanelDocks : public QObject {
  Q_OBJECT

 public:
  PanelDocks(Editor& editor, Viewport& viewport, QMainWindow& window);

  void fillMenu(QMenu& menu) const;

  void warmUp(const ExampleDocument& example) { sphere_->warmUp(example); }

  void share(const QSize& size);

  void followViewport();

  /// Brings the panel of colours to the front, with the keys.
  void showColors();
  /// Brings the panel of the solution to the front; the line of the tolerance of welding has the keys.
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
