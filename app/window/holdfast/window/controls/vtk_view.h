#pragma once
/// Shows a picture of VTK in a window of Qt. Its interactor asks for pictures and draws none itself.

#include <QMouseEvent>
#include <QWheelEvent>

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>

namespace holdfast {

/// The view replaces VTK's adapter for mouse and wheel. That adapter loses the pixel under the cursor on displays with
/// a pixel ratio above 1. It also loses shares of a notch of the wheel. The second press of a double click has a repeat
/// count of 1.
class VtkView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit VtkView(QWidget* parent = nullptr);

  /// Returns the number of pixels of the render window for each pixel of the widget.
  [[nodiscard]] double pixelRatio() const { return devicePixelRatioF(); }

 Q_SIGNALS:
  void renderWanted();

 protected:
  bool event(QEvent* event) override;
  void paintGL() override;

 private:
  void sendMouse(const QMouseEvent& event);
  void sendWheel(const QWheelEvent& event);
  void setInformation(const QPointF& place, Qt::KeyboardModifiers modifiers, int repeatCount);
  void tellRender();

  bool isPainting_ = false;
};

}  // namespace holdfast
