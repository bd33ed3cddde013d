#pragma once
/// \file
/// A picture of VTK in a window of Qt, whose interactor asks for pictures and does not draw them itself.

#include <QVTKOpenGLNativeWidget.h>

class QMouseEvent;
class QWheelEvent;

namespace holdfast {

/// Events of Qt go to VTK's interactor. Where VTK's own adapter loses something of them they are sent from here: the
/// pixel that the cursor is in, on displays with several for each of the widget's, and shares of a notch of the wheel,
/// which the interactor's style is told (`vtkInteractorStyle::SetMouseWheelMotionFactor`). The second press of a double
/// click is a press with a repeat count of 1.
class VtkView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit VtkView(QWidget* parent = nullptr);

  /// Pixels of the render window for each of the widget's.
  [[nodiscard]] double pixelRatio() const { return devicePixelRatioF(); }

 Q_SIGNALS:
  /// The interactor wants a picture, on behalf of a widget or of its style.
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
