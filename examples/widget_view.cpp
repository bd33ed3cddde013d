#include "widget_view.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageShrink3D.h>
#include <vtkInteractorObserver.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/lighting.h>

namespace holdfast {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 360;

}  // namespace

WidgetView::WidgetView(WidgetPicture picture)
    : files(std::move(picture)),
      model(makeModel(readMesh(files.mesh).mesh, files.mesh)),
      scene(model),
      surface(std::make_shared<const VisibleSurface>(model))
{
  scene.addTo(*renderer);
  scene.setPixelRatio(kPixelRatio);
  addLights(*renderer);
  addBackground(*renderer);
  window->AddRenderer(renderer);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kPixelRatio * kWidth, kPixelRatio * kHeight);
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(nullptr);
  interactor->SetSize(window->GetSize());
  interactor->Initialize();
  if (!files.constraints.empty()) {
    NoProgress progress;
    deformation = deform(model, readConstraints(files.constraints), files.constraints, {}, progress);
    scene.show(*deformation);
    const auto positions = std::make_shared<const Positions>(deformation->positions);
    surface = std::make_shared<const VisibleSurface>(surface->movedTo(positions));
  }
  constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
  fit(*renderer->GetActiveCamera(), defaultFrame(surface->positions()), surface->positions(), kAspect);
  renderer->ResetCameraClippingRange();
}

void WidgetView::lookAt(const Vector3& place, double radius, const Vector3& from) const
{
  vtkCamera& camera = *renderer->GetActiveCamera();
  const Vector3 eye =
      place + radius / std::tan(vtkMath::RadiansFromDegrees(camera.GetViewAngle() / 2)) * from.normalized();
  camera.SetFocalPoint(place.data());
  camera.SetPosition(eye.data());
  camera.SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
}

Vector3 WidgetView::nearestVertex(const Vector3& place) const
{
  Index vertex = 0;
  (surface->positions().rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&vertex);
  return surface->positions().row(vertex).transpose();
}

DisplayPoint WidgetView::pixelOf(const Vector3& place) const
{
  return toDisplay(*renderer, place).head<2>();
}

void WidgetView::send(unsigned long event, const DisplayPoint& pixel) const
{
  interactor->SetEventInformation(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  interactor->InvokeEvent(event);
}

void WidgetView::drag(const std::vector<DisplayPoint>& way) const
{
  send(vtkCommand::MouseMoveEvent, way.front());
  send(vtkCommand::LeftButtonPressEvent, way.front());
  for (const DisplayPoint& pixel : way) send(vtkCommand::MouseMoveEvent, pixel);
}

void WidgetView::release(const DisplayPoint& pixel) const
{
  send(vtkCommand::LeftButtonReleaseEvent, pixel);
}

void WidgetView::click(const DisplayPoint& pixel) const
{
  drag({pixel});
  release(pixel);
}

void WidgetView::switchOffWhereAsked(vtkInteractorObserver& widget) const
{
  // Not by `Off`, which leaves a style on.
  if (files.isOff) widget.SetInteractor(nullptr);
}

void WidgetView::draw() const
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> drawn;
  drawn->SetInput(window);
  drawn->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> mean;
  mean->SetShrinkFactors(kPixelRatio, kPixelRatio, 1);
  mean->SetInputConnection(drawn->GetOutputPort());
  vtkNew<vtkPNGWriter> file;
  file->SetFileName(files.picture.c_str());
  file->SetInputConnection(mean->GetOutputPort());
  file->Write();
  if (file->GetErrorCode() != 0) throw std::runtime_error(files.picture.string() + ": cannot be written");
}

}  // namespace holdfast
