// The examples of docs/widgets.md, each with a gesture that is played to it, and their pictures. What stands between
// two marks is printed on that page.
//   widget_pictures DATA PICTURES [off]      DATA: the folder data/. off: widgets are switched off before the gesture
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkEvent.h>
#include <vtkHandleWidget.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/vtkHoldfastConstraintMarkWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastRegionWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastRotationSphereStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h>
#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>
#include <holdfast/widgets/scene/kept_scene.h>
#include <holdfast/widgets/scene/lighting.h>

#include "widget_view.h"

using namespace holdfast;

struct Examples : WidgetView {
  using WidgetView::WidgetView;

  void gizmo();
  void surfacePoint();
  void surfaceCurve();
  void region();
  void constraintMarks();
  void surfaceRuler();
  void surfaceCamera();
  void rotationSphere();

  void bindings();
  void keptScene();
  void placer();
};

void Examples::gizmo()
{
  const Vector3 place(0, 6, 50);
  // [gizmo]
  vtkNew<vtkHoldfastGizmoWidget> gizmo;
  gizmo->SetInteractor(interactor);
  gizmo->GetGizmoRepresentation()->SetFrame(place, Eigen::Matrix3d::Identity());
  gizmo->GetGizmoRepresentation()->SetUnits("mm");
  vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback([](vtkObject*, unsigned long, void*, void* callData) {
    const auto& motion = *static_cast<GizmoMotion*>(callData);
    std::cout << "moved by " << motion.translation.transpose() << ", turned by " << motion.degrees << " degrees\n";
  });
  gizmo->AddObserver(vtkCommand::InteractionEvent, tell);
  gizmo->On();
  // [gizmo]
  switchOffWhereAsked(*gizmo);
  gizmo->GetGizmoRepresentation()->SetPixelRatio(kPixelRatio);
  send(vtkCommand::MouseMoveEvent, pixelOf(place + Vector3(0, 0, 10)));
  draw();
  drag({pixelOf(place + Vector3(0, 0, 10)), pixelAt(240, 300)});
}

void Examples::surfacePoint()
{
  scene.setMeshEdges(MeshEdges::All);
  lookAt({0, -104, 0}, 7, {0.3, -1, 0.3});
  // [surface point]
  vtkNew<vtkHoldfastSurfacePointWidget> point;
  point->SetInteractor(interactor);
  point->SetSurface(surface);
  point->SetKind(PickKind::Face);
  vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback([](vtkObject*, unsigned long, void*, void* callData) {
    const auto& pick = *static_cast<SurfacePick*>(callData);
    std::cout << "a point of face " << pick.face << " at " << pick.place.transpose() << '\n';
  });
  point->AddObserver(vtkCommand::PlacePointEvent, tell);
  point->On();
  // [surface point]
  switchOffWhereAsked(*point);
  point->SetPixelRatio(kPixelRatio);
  click(pixelAt(264, 177));
  draw();
}

void Examples::surfaceCurve()
{
  scene.setMeshEdges(MeshEdges::All);
  lookAt({25, -76, 25}, 32, {0.1, -1, 0.1});
  // [surface curve]
  vtkNew<vtkHoldfastSurfaceCurveWidget> curve;
  curve->SetInteractor(interactor);
  curve->SetSurface(surface);
  curve->SetRegions(std::make_shared<VertexRegions>(model.mesh, model.solverMesh));
  vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback([](vtkObject* widget, unsigned long, void*, void*) {
    std::cout << "a curve through " << static_cast<vtkHoldfastSurfaceCurveWidget*>(widget)->GetPath().size()
              << " vertices\n";
  });
  curve->AddObserver(vtkCommand::EndInteractionEvent, tell);
  curve->On();
  // [surface curve]
  switchOffWhereAsked(*curve);
  curve->SetPixelRatio(kPixelRatio);
  for (int k = 0; k <= 10; ++k) {
    const double angle = k * std::numbers::pi / 5;
    click(pixelAt(248 + 84 * std::cos(angle), 180 + 72 * std::sin(angle)));
  }
  draw();
}

void Examples::region()
{
  // [region]
  vtkNew<vtkHoldfastRegionWidget> region;
  region->SetInteractor(interactor);
  region->SetSurface(surface);
  region->SetRegions(std::make_shared<VertexRegions>(model.mesh, model.solverMesh));
  region->SetShape(RegionShape::Brush);
  vtkNew<vtkCallbackCommand> select;
  select->SetClientData(&scene);
  select->SetCallback([](vtkObject* widget, unsigned long, void* clientData, void* callData) {
    static_cast<SceneContents*>(clientData)->setSelection(static_cast<RegionCallData*>(callData)->reached);
    static_cast<vtkHoldfastRegionWidget*>(widget)->Render();
  });
  region->AddObserver(vtkCommand::InteractionEvent, select);
  region->On();
  // [region]
  switchOffWhereAsked(*region);
  region->SetPixelRatio(kPixelRatio);
  drag({pixelAt(180, 240), pixelAt(220, 250), pixelAt(270, 240), pixelAt(290, 220)});
  draw();
}

void Examples::constraintMarks()
{
  // [constraint marks]
  vtkNew<vtkHoldfastConstraintMarkWidget> marks;
  marks->SetInteractor(interactor);
  marks->SetMarks(scene.sharedMarks());
  vtkNew<vtkCallbackCommand> highlight;
  highlight->SetClientData(&scene);
  highlight->SetCallback([](vtkObject* widget, unsigned long, void* clientData, void* callData) {
    const auto* constraint = static_cast<Index*>(callData);
    static_cast<SceneContents*>(clientData)->highlight(constraint ? std::vector{*constraint} : std::vector<Index>{});
    static_cast<vtkHoldfastConstraintMarkWidget*>(widget)->Render();
  });
  marks->AddObserver(vtkCommand::HighlightEvent, highlight);
  marks->On();
  // [constraint marks]
  switchOffWhereAsked(*marks);
  marks->SetPixelRatio(kPixelRatio);
  send(vtkCommand::MouseMoveEvent, pixelOf({1.23, 15.74, 80.37}));
  draw();
}

void Examples::surfaceRuler()
{
  // [surface ruler]
  vtkNew<vtkHoldfastSurfaceRulerWidget> ruler;
  ruler->SetInteractor(interactor);
  ruler->SetSurface(surface);
  ruler->SetUnits("mm");
  vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback([](vtkObject* widget, unsigned long, void*, void*) {
    std::cout << "measured " << static_cast<vtkHoldfastSurfaceRulerWidget*>(widget)->GetDistance() << " mm\n";
  });
  ruler->AddObserver(vtkCommand::EndInteractionEvent, tell);
  ruler->On();
  // [surface ruler]
  switchOffWhereAsked(*ruler);
  scene.setMarks({});
  ruler->SetPixelRatio(kPixelRatio);
  click(pixelOf({1.23, 15.74, 80.37}));
  click(pixelOf({0.415, -17.918, 14.9}));
  draw();
}

void Examples::surfaceCamera()
{
  // [surface camera]
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  style->SetSurface(surface);
  vtkWidgetEventTranslator& drags = *style->GetEventTranslator();
  drags.SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::NoEvent);
  drags.SetTranslation(vtkCommand::LeftButtonPressEvent, vtkEvent::ShiftModifier, 0, 0, nullptr,
                       vtkWidgetEvent::Translate);
  drags.SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Rotate);
  interactor->SetInteractorStyle(style);
  // [surface camera]
  switchOffWhereAsked(*style);
  style->SetPixelRatio(kPixelRatio);
  SceneContents before(model);
  before.setPixelRatio(kPixelRatio);
  vtkNew<vtkRenderer> left;
  before.addTo(*left);
  addLights(*left);
  addBackground(*left);
  left->SetViewport(0, 0, 0.5, 1);
  renderer->SetViewport(0.5, 0, 1, 1);
  window->AddRenderer(left);
  const PreviewedPoint place{nearestVertex({75, -5, 10}), MarkKind::Face};
  std::array<PointPreview, 2> previews;
  for (std::size_t k = 0; k < previews.size(); ++k) {
    previews[k].setBallPixels(10 * kPixelRatio);
    previews[k].set(place);
    for (vtkActor* const actor : previews[k].actors()) (k == 0 ? left.Get() : renderer.Get())->AddActor(actor);
  }
  fit(*renderer->GetActiveCamera(), defaultFrame(surface->positions()), surface->positions(), 2.0 / 3);
  left->GetActiveCamera()->DeepCopy(renderer->GetActiveCamera());
  renderer->ResetCameraClippingRange();
  left->ResetCameraClippingRange();
  const DisplayPoint at = pixelOf(place.place);
  drag({at, at + pixelAt(40, 10)});
  draw();
}

void Examples::rotationSphere()
{
  renderer->RemoveAllViewProps();
  // [rotation sphere]
  RotationSphere sphere;
  sphere.addTo(*renderer);
  sphere.show(placeRotations(model, *deformation, nullptr));
  sphere.fitCamera();
  vtkNew<vtkHoldfastRotationSphereStyle> style;
  style->SetSphere(&sphere);
  vtkNew<vtkCallbackCommand> mark;
  mark->SetClientData(&sphere);
  mark->SetCallback([](vtkObject*, unsigned long, void* clientData, void* callData) {
    static_cast<RotationSphere*>(clientData)->mark(*static_cast<Index*>(callData));
  });
  style->AddObserver(vtkCommand::PickEvent, mark);
  interactor->SetInteractorStyle(style);
  // [rotation sphere]
  switchOffWhereAsked(*style);
  sphere.setColoring(coloringOf(model, *deformation, ColorBy::Angle, "mm"));
  sphere.setLook({.pixelRatio = kPixelRatio});
  drag({pixelAt(240, 180), pixelAt(262, 164)});
  release(pixelAt(262, 164));
  click(pixelAt(300, 155));
  draw();
}

void Examples::bindings()
{
  vtkNew<vtkHoldfastGizmoWidget> gizmo;
  gizmo->SetInteractor(interactor);
  // [bindings]
  vtkWidgetEventTranslator& events = *gizmo->GetEventTranslator();
  events.SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::NoEvent);
  events.SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::Select);
  events.SetTranslation(vtkCommand::MiddleButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  // [bindings]
  gizmo->GetGizmoRepresentation()->SetFrame({0, 6, 50}, Eigen::Matrix3d::Identity());
  gizmo->On();
  click(pixelOf({0, 6, 60}));
  send(vtkCommand::MiddleButtonPressEvent, pixelOf({0, 6, 60}));
  if (gizmo->IsHeld()) std::cout << "held by the middle button\n";
}

void Examples::keptScene()
{
  vtkNew<vtkHoldfastSurfacePointWidget> point;
  point->SetInteractor(interactor);
  point->SetSurface(surface);
  // [kept scene]
  window->SetMultiSamples(0);
  window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> layer;
  layer->SetLayer(1);
  layer->SetActiveCamera(renderer->GetActiveCamera());
  layer->PreserveDepthBufferOn();
  window->AddRenderer(layer);
  point->SetDefaultRenderer(layer);
  KeptScene kept(*renderer, *renderer);
  const auto drawAgain = [&] { kept.isCurrent() ? kept.drawLayersAbove() : window->Render(); };
  // [kept scene]
  point->On();
  drawAgain();
  send(vtkCommand::MouseMoveEvent, pixelAt(240, 180));
  if (kept.isCurrent()) std::cout << "only the layer is drawn again\n";
  drawAgain();
}

void Examples::placer()
{
  const Vector3 place(0, -104, 0);
  // [placer]
  vtkNew<vtkHoldfastSurfacePointPlacer> placer;
  placer->SetSurface(surface);
  vtkNew<vtkHoldfastSurfaceHandleRepresentation> drawn;
  drawn->SetPointPlacer(placer);
  drawn->SetLocation(AtNear{place});
  vtkNew<vtkHandleWidget> handle;
  handle->SetInteractor(interactor);
  handle->SetRepresentation(drawn);
  handle->On();
  // [placer]
  drag({pixelOf(place), pixelAt(160, 160)});
  std::cout << "the handle is at " << Vector3(drawn->GetWorldPosition()).transpose() << '\n';
}

struct Example {
  const char* name;
  void (Examples::*play)();
  const char* mesh;
  const char* constraints;
};

constexpr Example kWithPictures[] = {
    {"gizmo", &Examples::gizmo, "bracket.obj", ""},
    {"surface_point", &Examples::surfacePoint, "head.ply", ""},
    {"surface_curve", &Examples::surfaceCurve, "head.ply", ""},
    {"region", &Examples::region, "head.ply", ""},
    {"constraint_marks", &Examples::constraintMarks, "bracket.obj", "bracket.constraints.json"},
    {"surface_ruler", &Examples::surfaceRuler, "bracket.obj", "bracket.constraints.json"},
    {"surface_camera", &Examples::surfaceCamera, "head.ply", ""},
    {"rotation_sphere", &Examples::rotationSphere, "plate_unsymmetric.off",
     "plate_unsymmetric.three_handles.constraints.json"}};

constexpr Example kOthers[] = {{"bindings", &Examples::bindings, "bracket.obj", ""},
                               {"kept_scene", &Examples::keptScene, "head.ply", ""},
                               {"placer", &Examples::placer, "head.ply", ""}};

int main(int argc, char** argv)
try {
  if (argc < 3) throw std::runtime_error("widget_pictures DATA PICTURES [off]");
  const std::filesystem::path data = argv[1];
  const std::filesystem::path pictures = argv[2];
  const bool isOff = argc > 3;
  const auto play = [&](const Example& example) {
    const std::string constraints = example.constraints;
    Examples view({data / example.mesh, constraints.empty() ? std::filesystem::path() : data / constraints,
                   pictures / (std::string("widget_") + example.name + ".png"), isOff});
    (view.*example.play)();
  };
  for (const Example& example : kWithPictures) play(example);
  if (isOff) return 0;
  for (const Example& example : kOthers) play(example);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
