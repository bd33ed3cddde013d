#include "interaction/interaction_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <vtkAbstractWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast::test {
namespace {

constexpr double kGrey = 0.6;

struct NamedKey {
  const char* keySym;
  char character;
};

// What stands behind names longer than a letter.
constexpr std::array kNamedKeys{NamedKey{"period", '.'},      NamedKey{"comma", ','},        NamedKey{"minus", '-'},
                                NamedKey{"bracketleft", '['}, NamedKey{"bracketright", ']'}, NamedKey{"plus", '+'},
                                NamedKey{"Return", '\r'},     NamedKey{"BackSpace", '\b'},   NamedKey{"Escape", '\x1b'},
                                NamedKey{"Tab", '\t'},        NamedKey{"space", ' '}};

char characterOf(const std::string& keySym)
{
  if (keySym.size() == 1) return keySym.front();
  const auto* found =
      std::find_if(kNamedKeys.begin(), kNamedKeys.end(), [&](const NamedKey& key) { return key.keySym == keySym; });
  return found == kNamedKeys.end() ? '\0' : found->character;
}

std::string keySymOf(char character)
{
  const auto* found = std::find_if(kNamedKeys.begin(), kNamedKeys.end(),
                                   [&](const NamedKey& key) { return key.character == character; });
  return found == kNamedKeys.end() ? std::string(1, character) : found->keySym;
}

}  // namespace

void Mouse::send(unsigned long event, const DisplayPoint& place, const Held& held, int repeatCount)
{
  interactor_.SetEventInformation(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())),
                                  held.ctrl ? 1 : 0, held.shift ? 1 : 0, '\0', repeatCount, nullptr);
  interactor_.SetAltKey(held.alt ? 1 : 0);
  interactor_.InvokeEvent(event);
}

void Mouse::moveTo(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::MouseMoveEvent, place, held);
}

void Mouse::press(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::LeftButtonPressEvent, place, held);
}

void Mouse::release(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::LeftButtonReleaseEvent, place, held);
}

void Mouse::click(const DisplayPoint& place, const Held& held)
{
  moveTo(place, held);
  press(place, held);
  release(place, held);
}

void Mouse::doubleClick(const DisplayPoint& place, const Held& held)
{
  click(place, held);
  send(vtkCommand::LeftButtonPressEvent, place, held, 1);
  release(place, held);
}

void Mouse::drag(const std::vector<DisplayPoint>& way, const Held& held)
{
  moveTo(way.front(), held);
  press(way.front(), held);
  for (std::size_t k = 1; k < way.size(); ++k) moveTo(way[k], held);
  release(way.back(), held);
}

void Mouse::rightPress(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::RightButtonPressEvent, place, held);
}

void Mouse::rightRelease(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::RightButtonReleaseEvent, place, held);
}

void Mouse::middlePress(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::MiddleButtonPressEvent, place, held);
}

void Mouse::middleRelease(const DisplayPoint& place, const Held& held)
{
  send(vtkCommand::MiddleButtonReleaseEvent, place, held);
}

void Mouse::wheel(const DisplayPoint& place, int notches)
{
  for (int k = 0; k < std::abs(notches); ++k)
    send(notches > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent, place, {});
}

void Mouse::leave()
{
  interactor_.InvokeEvent(vtkCommand::LeaveEvent);
}

void Mouse::key(const std::string& keySym, const Held& held)
{
  const char character = characterOf(keySym);
  interactor_.SetKeyEventInformation(held.ctrl ? 1 : 0, held.shift ? 1 : 0, character, 0, keySym.c_str());
  interactor_.SetAltKey(held.alt ? 1 : 0);
  interactor_.InvokeEvent(vtkCommand::KeyPressEvent);
  if (character != '\0') interactor_.InvokeEvent(vtkCommand::CharEvent);
  interactor_.InvokeEvent(vtkCommand::KeyReleaseEvent);
}

void Mouse::type(const std::string& text)
{
  for (const char character : text) key(keySymOf(character));
}

InteractionFixture::InteractionFixture(Mesh mesh, int width, int height)
    : model_(makeModel(std::move(mesh), "mesh")), surface_(std::make_shared<const VisibleSurface>(model_))
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetSize(width, height);
  window_->AddRenderer(renderer_);
  interactor_->SetRenderWindow(window_);
  interactor_->SetInteractorStyle(nullptr);
  interactor_->SetSize(width, height);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(toPolyData(model_.mesh, model_.mesh.positions));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(kGrey, kGrey, kGrey);
  renderer_->AddActor(actor);
  renderer_->ResetCamera();
  interactor_->Initialize();
}

InteractionFixture::~InteractionFixture() = default;

void InteractionFixture::enable(vtkAbstractWidget& widget)
{
  widget.SetInteractor(interactor_);
  widget.SetCurrentRenderer(renderer_);
  widget.SetEnabled(1);
}

void InteractionFixture::lookFromFront()
{
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera.SetPosition(0, -1, 0);
  camera.SetFocalPoint(0, 0, 0);
  camera.SetViewUp(0, 0, 1);
  renderer_->ResetCamera();
}

DisplayPoint InteractionFixture::pixelOf(const Vector3& place) const
{
  return toDisplay(*renderer_, place).head<2>().array().floor();
}

DisplayPoint InteractionFixture::pixelOfVertex(Index vertex) const
{
  return pixelOf(surface_->positions().row(vertex).transpose());
}

std::vector<int> InteractionFixture::colorAt(const DisplayPoint& pixel) const
{
  window_->Render();
  vtkNew<vtkUnsignedCharArray> colors;
  const int x = static_cast<int>(pixel.x());
  const int y = static_cast<int>(pixel.y());
  window_->GetPixelData(x, y, x, y, 0, colors);
  return {colors->GetValue(0), colors->GetValue(1), colors->GetValue(2)};
}

int InteractionFixture::countPixels(const std::vector<int>& color, int tolerance) const
{
  window_->Render();
  vtkNew<vtkUnsignedCharArray> colors;
  window_->GetPixelData(0, 0, window_->GetSize()[0] - 1, window_->GetSize()[1] - 1, 0, colors);
  int count = 0;
  for (vtkIdType pixel = 0; pixel < colors->GetNumberOfTuples(); ++pixel) {
    bool isAlike = true;
    for (int channel = 0; channel < 3; ++channel)
      isAlike = isAlike &&
                std::abs(colors->GetValue(3 * pixel + channel) - color[static_cast<std::size_t>(channel)]) <= tolerance;
    count += isAlike ? 1 : 0;
  }
  return count;
}

void InteractionFixture::save(const std::string& path) const
{
  window_->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window_);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
}

EventLog::EventLog(vtkObject& object, const std::vector<unsigned long>& events) : object_(object)
{
  for (const unsigned long event : events) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
        [](vtkObject*, unsigned long id, void* self, void*) { static_cast<EventLog*>(self)->events_.push_back(id); });
    tags_.push_back(object.AddObserver(event, command));
  }
}

EventLog::~EventLog()
{
  for (const unsigned long tag : tags_) object_.RemoveObserver(tag);
}

}  // namespace holdfast::test
