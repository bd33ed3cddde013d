#pragma once
/// \file
/// When what was drawn is done, without waiting for it.

#include <chrono>
#include <initializer_list>

class vtkRenderWindow;

namespace holdfast {

/// OpenGL takes orders at once and draws later, on a GPU or on threads of its own. One fence is set at a time, behind
/// all that has been ordered so far.
///
/// Mesa's renderer for machines without a GPU says that a fence is passed a moment before its threads have let go of
/// it. Freed by the next order within that moment, they would write into memory that is no longer theirs
/// (`lp_fence_signal`, Mesa 22.3); who asks again and again meets it sooner or later. So a second hold on each fence is
/// kept until the one after it is passed, which no thread comes to before it has left the one before.
class DrawFence {
 public:
  /// `window` stays alive as long as this, and draws in a context of Qt.
  explicit DrawFence(vtkRenderWindow& window);
  ~DrawFence();
  DrawFence(const DrawFence&) = delete;
  DrawFence& operator=(const DrawFence&) = delete;

  /// In the place of one that was set before.
  void set();

  /// False while what is before the fence is being drawn, and still is after `patience`; else true, and it is no longer
  /// set. True where none is set.
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
