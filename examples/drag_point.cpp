// Hold points of a mesh in a plain window of VTK, and drag the last one: the surface follows at every frame.
//   drag_point MESH.obj RESULT.obj [RECORDING]      RECORDING: of vtkInteractorEventRecorder, played instead of a hand
#include <fstream>
#include <iostream>

#include <vtkInteractorEventRecorder.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <holdfast/holdfast.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>
#include <holdfast/widgets/scene/scene_contents.h>

using namespace holdfast;

struct DragPoint {
  explicit DragPoint(const Model& m) : deformer(m), scene(m)
  {
    scene.addTo(*renderer);
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    window->SetSize(800, 600);
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    point->SetInteractor(interactor);
    point->AddObserver(vtkCommand::PlacePointEvent, this, &DragPoint::hold);
    gizmo->SetInteractor(interactor);
    gizmo->GetGizmoRepresentation()->SetMotions(GizmoMotions::Moves);
    gizmo->AddObserver(vtkCommand::InteractionEvent, this, &DragPoint::drag);
    window->Render();
    point->SetSurface(std::make_shared<VisibleSurface>(m));
    point->On();
  }
  void hold(vtkObject*, unsigned long, void* callData)
  {
    const auto& [location, place, face, triangle] = *static_cast<const SurfacePick*>(callData);
    list.constraints.push_back(
        {std::to_string(list.constraints.size()), true, PointConstraint{location, Target{place}}});
    gizmo->GetGizmoRepresentation()->SetFrame(place, Eigen::Matrix3d::Identity());
    gizmo->On();
  }
  void drag(vtkObject*, unsigned long, void*)
  {
    std::get<PointConstraint>(list.constraints.back().what).to =
        Target{gizmo->GetGizmoRepresentation()->GetFrame().center};
    const auto positions = std::make_shared<Positions>(deformer.deform(list, "clicks").positions);
    scene.setPositions(*positions);
    point->SetSurface(std::make_shared<VisibleSurface>(point->GetPlacer()->GetSurface()->movedTo(positions)));
  }
  ConstraintList list;
  Deformer deformer;
  SceneContents scene;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  vtkNew<vtkHoldfastSurfacePointWidget> point;
  vtkNew<vtkHoldfastGizmoWidget> gizmo;
};

int main(int argc, char** argv)
try {
  if (argc < 3) throw std::runtime_error("drag_point MESH.obj RESULT.obj [RECORDING]");
  const MeshDocument file = readMesh(argv[1]);
  const Model model = makeModel(file.mesh, argv[1]);
  DragPoint tool(model);
  vtkNew<vtkInteractorEventRecorder> player;
  player->SetInteractor(tool.interactor);
  if (argc > 3 && !std::ifstream(argv[3])) throw std::runtime_error(argv[3] + std::string(" cannot be read"));
  if (argc > 3) player->SetFileName(argv[3]);
  argc > 3 ? player->Play() : tool.interactor->Start();
  writeMesh(argv[2], file, tool.point->GetPlacer()->GetSurface()->positions());
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
