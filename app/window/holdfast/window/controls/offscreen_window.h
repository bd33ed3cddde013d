#pragma once
/// Pictures in files where Qt draws on no X server.

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// A window that is never shown. VTK's own needs an X server; null where Qt draws on one, and VTK's own will do. On the
/// thread of the window.
[[nodiscard]] vtkSmartPointer<vtkRenderWindow> newOffscreenWindow();

}  // namespace holdfast
