#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCurveRepresentation.h"

#include <algorithm>
#include <cmath>

#include <vtkCell.h>
#include <vtkIdList.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/mesh/poly_data.h>

using namespace holdfast;

namespace {

constexpr int kReachPixels = 12;
constexpr int kLeastPlaces = 3;

constexpr Color kCurveColor{0.78, 0.24, 0.00};
constexpr Color kRimColor{1, 1, 1};
constexpr double kCurvePixels = 2;
constexpr double kCurveRimPixels = 4;
constexpr double kPreviewPixels = 1.5;
constexpr double kPreviewRimPixels = 3.5;
constexpr double kPlacePixels = 10;
constexpr double kActivePixels = 17;
constexpr double kRimOpacity = 0.82;
constexpr double kPreviewOpacity = 0.65;

}  // namespace

vtkStandardNewMacro(vtkHoldfastSurfaceCurveRepresentation);

vtkHoldfastSurfaceCurveRepresentation::vtkHoldfastSurfaceCurveRepresentation()
{
  this->InteractionState = vtkContourRepresentation::Outside;
  this->SetPointPlacer(this->Placer);
  this->SetLineInterpolator(this->Interpolator);
  this->Placer->SetKind(PickKind::Vertex);
  this->Placer->SetSnapPixels(kReachPixels);
  this->PixelTolerance = kReachPixels;
  const auto show = [](vtkActor& actor, vtkPolyData& line, const Color& color, double opacity) {
    showData(actor, line);
    setColor(actor, color);
    actor.GetProperty()->SetOpacity(opacity);
    actor.GetProperty()->LightingOff();
  };
  const double faint = this->LineBehind->GetProperty()->GetOpacity();
  show(*this->LineBehind, *this->Line, kCurveColor, faint);
  show(*this->LineRim, *this->Line, kRimColor, kRimOpacity);
  show(*this->LineFront, *this->Line, kCurveColor, 1);
  show(*this->PreviewRim, *this->PreviewLine, kRimColor, kPreviewOpacity * kRimOpacity);
  show(*this->PreviewFront, *this->PreviewLine, kCurveColor, kPreviewOpacity);
  this->Props = {this->LineBehind,          &this->DotsBehind.actor(), this->LineRim,       this->LineFront,
                 this->PreviewRim,          this->PreviewFront,        &this->Dots.actor(), &this->PreviewDot.actor(),
                 &this->ActiveRing.actor(), &this->ClosingRing.actor()};
}

void vtkHoldfastSurfaceCurveRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Regions: " << this->Interpolator->GetRegions().get() << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
  os << indent << "Places:";
  for (const Index vertex : this->GetPlaces()) os << ' ' << vertex;
  os << '\n';
}

void vtkHoldfastSurfaceCurveRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  const bool isSameModel = surface && this->Surface && &surface->model() == &this->Surface->model();
  this->Surface = std::move(surface);
  this->Placer->SetSurface(this->Surface);
  this->Interpolator->SetSurface(this->Surface);
  if (!isSameModel) return this->ClearAllNodes();
  for (vtkContourRepresentationNode* node : this->Internal->Nodes) {
    Vector3::Map(node->WorldPosition) = this->PlaceOf(Index{node->PointId});
    for (vtkContourRepresentationPoint* point : node->Points)
      Vector3::Map(point->WorldPosition) = this->PlaceOf(Index{point->PointId});
  }
  this->NeedToRender = 1;
  this->BuildLines();
}

void vtkHoldfastSurfaceCurveRepresentation::SetPixelRatio(double ratio)
{
  this->PixelRatio = std::clamp(ratio, 0.1, 100.0);
  this->Placer->SetPixelRatio(this->PixelRatio);
  this->SetPixelTolerance(static_cast<int>(std::lround(kReachPixels * this->PixelRatio)));
  this->Modified();
}

std::vector<Index> vtkHoldfastSurfaceCurveRepresentation::GetPlaces() const
{
  std::vector<Index> places;
  for (const vtkContourRepresentationNode* node : this->Internal->Nodes) places.push_back(Index{node->PointId});
  return places;
}

std::vector<Index> vtkHoldfastSurfaceCurveRepresentation::GetPath() const
{
  std::vector<Index> path;
  for (const vtkContourRepresentationNode* node : this->Internal->Nodes) {
    path.push_back(Index{node->PointId});
    for (const vtkContourRepresentationPoint* point : node->Points) path.push_back(Index{point->PointId});
  }
  return path;
}

/// Tells whether the vertex may be a place beside all others but `moved`.
bool vtkHoldfastSurfaceCurveRepresentation::IsPossible(Index vertex, int moved) const
{
  if (!this->Surface || !this->Interpolator->GetRegions()) return false;
  if (vertex < 0 || vertex >= this->Surface->positions().rows()) return false;
  const SolverMesh& mesh = this->Surface->model().solverMesh;
  const Index unknown = mesh.weld.unknownOf[vertex];
  if (mesh.componentOf[unknown] < 0) return false;
  const std::vector<Index> places = this->GetPlaces();
  for (int n = 0; n < static_cast<int>(places.size()); ++n) {
    if (n == moved) continue;
    const Index other = mesh.weld.unknownOf[places[static_cast<std::size_t>(n)]];
    if (other == unknown || mesh.componentOf[other] != mesh.componentOf[unknown]) return false;
  }
  return true;
}

bool vtkHoldfastSurfaceCurveRepresentation::InsertPlace(int n, Index vertex)
{
  constexpr int kNoNode = -1;
  if (n < 0 || n > this->GetNumberOfNodes() || !this->IsPossible(vertex, kNoNode)) return false;
  auto* node = new vtkContourRepresentationNode{};
  for (const int k : {0, 4, 8}) node->WorldOrientation[k] = 1;
  this->Internal->Nodes.insert(this->Internal->Nodes.begin() + n, node);
  return this->MovePlace(n, vertex);
}

bool vtkHoldfastSurfaceCurveRepresentation::MovePlace(int n, Index vertex)
{
  if (!this->IsNode(n) || !this->IsPossible(vertex, n)) return false;
  vtkContourRepresentationNode& node = *this->Internal->Nodes[static_cast<std::size_t>(n)];
  node.PointId = vertex;
  Vector3::Map(node.WorldPosition) = this->PlaceOf(vertex);
  this->UpdateLines(n);
  this->NeedToRender = 1;
  return true;
}

void vtkHoldfastSurfaceCurveRepresentation::ClearAllNodes()
{
  this->Internal->ClearNodes();
  this->ClosedLoop = 0;
  this->ActiveNode = -1;
  this->CurrentOperation = Inactive;
  this->Preview.clear();
  this->NeedToRender = 1;
  this->BuildLines();
}

Index vtkHoldfastSurfaceCurveRepresentation::VertexAt(const DisplayPoint& pixel) const
{
  SurfacePick pick;
  if (this->Renderer == nullptr || !this->Placer->Pick(*this->Renderer, pixel.data(), pick)) return -1;
  return std::get<AtVertex>(pick.location).vertex;
}

bool vtkHoldfastSurfaceCurveRepresentation::IsClosable() const
{
  return this->ClosedLoop == 0 && static_cast<int>(this->Internal->Nodes.size()) >= kLeastPlaces;
}

bool vtkHoldfastSurfaceCurveRepresentation::IsAtFirst(const DisplayPoint& pixel)
{
  if (!this->IsClosable()) return false;
  const Vector3 first = toDisplay(*this->Renderer, this->PlaceOf(this->GetPlaces().front()));
  return (first.head<2>() - centerOfPixel(pixel.x(), pixel.y())).norm() < kReachPixels * this->PixelRatio;
}

void vtkHoldfastSurfaceCurveRepresentation::SetPreview(Index vertex)
{
  std::vector<Index> way;
  if (vertex >= 0 && this->Internal->Nodes.empty())
    way = {vertex};
  else if (vertex >= 0 && this->ClosedLoop == 0)
    way = this->Interpolator->Path(this->GetPlaces().back(), vertex);
  if (way == this->Preview) return;
  this->Preview = std::move(way);
  this->NeedToRender = 1;
  this->Modified();
}

Index vtkHoldfastSurfaceCurveRepresentation::NearestVertex(const double place[3]) const
{
  if (!this->Surface) return -1;
  const Vector3 at(place);
  Index nearest = -1;
  double least = 0;
  for (Index v = 0; v < this->Surface->positions().rows(); ++v) {
    if (!this->Surface->isShown(v)) continue;
    const double distance = (this->PlaceOf(v) - at).stableNorm();
    if (nearest >= 0 && distance >= least) continue;
    nearest = v;
    least = distance;
  }
  return nearest;
}

int vtkHoldfastSurfaceCurveRepresentation::AddNodeOnContour(int x, int y)
{
  const Index vertex = this->VertexAt(DisplayPoint(x, y));
  if (vertex < 0) return 0;
  const std::vector<int>& unknownOf = this->Surface->model().solverMesh.weld.unknownOf;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
    for (const vtkContourRepresentationPoint* point : this->GetNthNode(n)->Points)
      if (unknownOf[Index{point->PointId}] == unknownOf[vertex]) return this->InsertPlace(n + 1, vertex);
  return 0;
}

int vtkHoldfastSurfaceCurveRepresentation::AddIntermediatePointWorldPosition(int n, double place[3], vtkIdType vertex)
{
  if (!this->IsNode(n)) return 0;
  auto* point = new vtkContourRepresentationPoint{};
  point->PointId = vertex;
  Vector3::Map(point->WorldPosition) = Vector3(place);
  this->Internal->Nodes[static_cast<std::size_t>(n)]->Points.push_back(point);
  return 1;
}

int vtkHoldfastSurfaceCurveRepresentation::ActivateNode(double pixel[2])
{
  const DisplayTransform display(*this->Renderer);
  const std::vector<Index> places = this->GetPlaces();
  double nearest = this->PixelTolerance;
  int active = -1;
  for (int n = 0; n < static_cast<int>(places.size()); ++n) {
    const Index vertex = places[static_cast<std::size_t>(n)];
    const DisplayTransform::Shown shown = display.show(this->PlaceOf(vertex));
    const double distance = (shown.point - centerOfPixel(pixel[0], pixel[1])).norm();
    if (!(shown.depth > 0) || distance >= nearest || !this->Surface->isVertexVisible(vertex, display)) continue;
    nearest = distance;
    active = n;
  }
  if (std::exchange(this->ActiveNode, active) != active) {
    this->NeedToRender = 1;
    this->Modified();
  }
  return active >= 0 ? 1 : 0;
}

int vtkHoldfastSurfaceCurveRepresentation::ComputeInteractionState(int x, int y, int /*modified*/)
{
  this->InteractionState = this->ActivateNode(x, y) != 0 ? Nearby : Outside;
  return this->InteractionState;
}

void vtkHoldfastSurfaceCurveRepresentation::WidgetInteraction(double pixel[2])
{
  if (this->CurrentOperation != Translate) return;
  const Index vertex = this->VertexAt(DisplayPoint(pixel));
  if (vertex >= 0 && this->IsNode(this->ActiveNode) && this->GetNthNode(this->ActiveNode)->PointId != vertex)
    this->MovePlace(this->ActiveNode, vertex);
}

void vtkHoldfastSurfaceCurveRepresentation::InitializeContour(vtkPolyData* line, vtkIdList* vertices)
{
  this->ClearAllNodes();
  const vtkIdType count = line->GetNumberOfPoints();
  const bool areNamed = vertices != nullptr && vertices->GetNumberOfIds() == count;
  for (vtkIdType k = 0; k < count; ++k) {
    if (areNamed)
      this->InsertPlace(this->GetNumberOfNodes(), Index{vertices->GetId(k)});
    else
      this->AddNodeAtWorldPosition(line->GetPoint(k));
  }
  // A closed line names its first point once more.
  if (line->GetNumberOfCells() > 0 && line->GetCell(0)->GetNumberOfPoints() > count) this->ClosedLoopOn();
}

void vtkHoldfastSurfaceCurveRepresentation::ShowSprites()
{
  std::vector<Sprite> places;
  if (this->Surface)
    for (const Index vertex : this->GetPlaces()) places.push_back({this->PlaceOf(vertex), kCurveColor});
  const auto only = [&](bool isShown, int n) {
    return isShown ? std::vector<Sprite>{places[static_cast<std::size_t>(n)]} : std::vector<Sprite>{};
  };
  this->ActiveRing.set(only(this->IsNode(this->ActiveNode) && this->ClosedLoop != 0, this->ActiveNode));
  this->ClosingRing.set(only(this->IsClosable(), 0));
  this->Dots.set(places);
  this->DotsBehind.set(places);
  std::vector<Sprite> preview;
  if (!this->Preview.empty()) preview.push_back({this->PlaceOf(this->Preview.back()), kCurveColor});
  this->PreviewDot.set(preview);
  for (PointSprites* const dots : {&this->Dots, &this->DotsBehind, &this->PreviewDot})
    dots->setPixels(kPlacePixels * this->PixelRatio);
  this->ActiveRing.setPixels(kActivePixels * this->PixelRatio);
  this->ClosingRing.setPixels(2 * kReachPixels * this->PixelRatio);
}

void vtkHoldfastSurfaceCurveRepresentation::BuildRepresentation()
{
  if (this->GetMTime() <= this->BuildTime) return;
  this->BuildTime.Modified();
  std::vector<Index> path = this->GetPath();
  if (this->ClosedLoop != 0 && !path.empty()) path.push_back(path.front());
  const auto show = [this](vtkPolyData& line, const std::vector<Index>& vertices) {
    std::vector<Vector3> places;
    places.reserve(vertices.size());
    for (const Index vertex : vertices) places.push_back(this->PlaceOf(vertex));
    setLines(line, {places});
  };
  show(*this->Line, path);
  show(*this->PreviewLine, this->Preview);
  setLineWidth(*this->LineBehind, kCurvePixels * this->PixelRatio);
  setLineWidth(*this->LineRim, kCurveRimPixels * this->PixelRatio);
  setLineWidth(*this->LineFront, kCurvePixels * this->PixelRatio);
  setLineWidth(*this->PreviewRim, kPreviewRimPixels * this->PixelRatio);
  setLineWidth(*this->PreviewFront, kPreviewPixels * this->PixelRatio);
  this->ShowSprites();
}

vtkPolyData* vtkHoldfastSurfaceCurveRepresentation::GetContourRepresentationAsPolyData()
{
  this->BuildRepresentation();
  return this->Line;
}
