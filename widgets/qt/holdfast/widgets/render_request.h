#pragma once
/// \file
/// Drawing a VTK view later, once for all requests of one turn of the event loop.

#include <QObject>

class QVTKOpenGLNativeWidget;

namespace holdfast {

/// Of one view, which it outlives in none of its work: it is the view's child. A view that is hidden is not drawn; ask
/// again when it is shown.
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
