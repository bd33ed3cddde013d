#include "interaction/recorded_gesture.h"

#include <fstream>
#include <iterator>

#include <vtkInteractorEventRecorder.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include "support/temporary_folder.h"

namespace holdfast::test {

std::string recorded(vtkRenderWindowInteractor& interactor, const std::function<void()>& gesture)
{
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "gesture.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&interactor);
  // Before widgets, which abort what they use.
  recorder->SetPriority(1);
  recorder->SetFileName(path.c_str());
  recorder->On();
  recorder->Record();
  gesture();
  recorder->Stop();
  recorder->Off();
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void replay(const std::string& events, vtkRenderWindowInteractor& interactor)
{
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&interactor);
  recorder->ReadFromInputStringOn();
  recorder->SetInputString(events.c_str());
  recorder->Play();
  recorder->Off();
}

}  // namespace holdfast::test
