#pragma once
/// Tells whether OpenGL has finished drawing, without waiting for it.

#include <chrono>
#include <initializer_list>

class vtkRenderWindow;

namespace holdfast {

/// The fence tells when OpenGL has drawn what it was ordered to draw. OpenGL takes orders at once and draws later, on a
/// GPU or on threads of its own. One fence is set at a time, behind all orders so far.
///
/// Mesa's renderer for machines without a GPU reports a fence as passed a moment before its threads release it. If the
/// next order frees the fence in that moment, the threads write into freed memory (`lp_fence_signal`, Mesa 22.3). This
/// class therefore keeps a second hold on each fence until the next one is passed. No thread reaches the next one
/// before it has released the first.
class DrawFence {
 public:
  /// Makes a fence for `window`, which outlives the fence and draws in a context of Qt.
  explicit DrawFence(vtkRenderWindow& window);
  ~DrawFence();
  DrawFence(const DrawFence&) = delete;
  DrawFence& operator=(const DrawFence&) = delete;

  void set();

  /// Returns false if the orders before the fence are still being drawn after `patience`. Else it returns true, and the
  /// fence is no longer set. It returns true if no fence is set.
  [[nodiscard]] bool pass(std::chrono::nanoseconds patience = {});

 private:
  using Sync = void*;  // a GLsync

  void drop(std::initializer_list<Sync*> syncs);

  vtkRenderWindow& window_;
  Sync asked_ = nullptr;   // null where none is set
  Sync held_ = nullptr;    // the second hold on the same
  Sync passed_ = nullptr;  // that on the last one that was passed
};

}  // namespace holdfast
