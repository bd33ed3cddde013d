#pragma once
/// \file
/// Gestures as VTK records and replays them.

#include <functional>
#include <string>

class vtkRenderWindowInteractor;

namespace holdfast::test {

/// The events that `gesture` sends to the interactor, as the text of a vtkInteractorEventRecorder.
[[nodiscard]] std::string recorded(vtkRenderWindowInteractor& interactor, const std::function<void()>& gesture);

void replay(const std::string& events, vtkRenderWindowInteractor& interactor);

}  // namespace holdfast::test
