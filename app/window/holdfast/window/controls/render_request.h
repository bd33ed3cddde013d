#pragma once
/// \file
/// Drawing a VTK view later, once for all requests of one turn of the event loop, and one view a turn.

#include <QObject>

class QVTKOpenGLNativeWidget;

namespace holdfast {

/// Belongs to one view, as its child. A view that is hidden is not drawn: ask again when it is shown.
class RenderRequest : public QObject {
 public:
  explicit RenderRequest(QVTKOpenGLNativeWidget& view);

  /// Nothing comes of it where the view is drawn before for another reason: when it is shown, say.
  void post();
  /// Its turn has come.
  void draw();

 private:
  void drawn() { isPosted_ = false; }

  QVTKOpenGLNativeWidget& view_;
  bool isPosted_ = false;
};

}  // namespace holdfast
