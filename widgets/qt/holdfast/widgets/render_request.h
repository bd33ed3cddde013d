#pragma once
/// \file
/// Drawing a VTK view later, once for all requests of one turn of the event loop.

#include <QObject>

class QVTKOpenGLNativeWidget;

namespace holdfast {

/// Belongs to one view, as its child. A view that is hidden is not drawn: ask again when it is shown.
class RenderRequest : public QObject {
 public:
  explicit RenderRequest(QVTKOpenGLNativeWidget& view);

  void post();

 private:
  void draw();

  QVTKOpenGLNativeWidget& view_;
  bool isPosted_ = false;
};

}  // namespace holdfast
