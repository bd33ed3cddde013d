#pragma once
/// \file
/// When what was drawn is done, without waiting for it.

class vtkRenderWindow;

namespace holdfast {

/// OpenGL takes orders at once and draws later, on a GPU or on threads of its own. One fence is set at a time, behind
/// all that has been ordered so far.
class DrawFence {
 public:
  /// `window` stays alive as long as this, and draws in a context of Qt.
  explicit DrawFence(vtkRenderWindow& window);
  ~DrawFence();
  DrawFence(const DrawFence&) = delete;
  DrawFence& operator=(const DrawFence&) = delete;

  /// In the place of one that was set before.
  void set();

  /// False while what is before the fence is being drawn; else true, and it is no longer set. True where none is set.
  [[nodiscard]] bool pass();

 private:
  void drop();

  vtkRenderWindow& window_;
  void* sync_ = nullptr;  // a GLsync
};

}  // namespace holdfast
