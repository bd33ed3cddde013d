#pragma once
/// Draws pictures for files where Qt draws on no X server.

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// Returns a window that is never shown. VTK's own window needs an X server. Where Qt draws on one, VTK's own will do,
/// and the function returns null. Call it on the thread of the window.
[[nodiscard]] vtkSmartPointer<vtkRenderWindow> newOffscreenWindow();

}  // namespace holdfast
