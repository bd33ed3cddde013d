#include "holdfast/widgets/mesh/mesh_actor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <utility>

#include <vtkCellArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/threads/parallel.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

constexpr double kEdgePixels = 1.1;

// No wider than a pixel of the window, OpenGL draws lines itself; wider ones are made of triangles.
constexpr double kMeshEdgePixels = 1.0;
constexpr double kPointPixels = 2.5;

vtkSmartPointer<vtkCellArray> linesOf(const std::vector<std::array<Index, 2>>& edges)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& [a, b] : edges) cells->InsertNextCell({a, b});
  return cells;
}

void showLines(vtkActor& actor, vtkPolyDataMapper& mapper, vtkPolyData& data)
{
  mapper.SetInputData(&data);
  mapper.ScalarVisibilityOff();
  actor.SetMapper(&mapper);
}

void setSurfaceLook(vtkProperty& property)
{
  property.SetColor(kPlainColor.red, kPlainColor.green, kPlainColor.blue);
  property.SetInterpolationToPhong();
  property.SetAmbient(0.16);
  property.SetDiffuse(0.84);
  property.SetSpecular(0.10);
  property.SetSpecularPower(24);
}

void setEdgeLook(vtkActor& actor, double opacity, double pixels)
{
  actor.GetProperty()->SetColor(0.13, 0.15, 0.19);
  actor.GetProperty()->SetOpacity(opacity);
  actor.GetProperty()->LightingOff();
  setLineWidth(actor, pixels);
}

}  // namespace

MeshActor::MeshActor(const Model& model, std::shared_ptr<const ShadedSurface> shaded)
    : model_(model),
      shaded_(shaded ? std::move(shaded) : std::make_shared<const ShadedSurface>(cutAtSharpEdges(model))),
      doubleNormals_(std::make_unique<AreaWeightedNormals>(shaded_->triangles, shaded_->triangles.corners(),
                                                           static_cast<Index>(shaded_->vertexOf.size())))
{
  places_.resize(static_cast<Index>(shaded_->vertexOf.size()), 3);
  coordinates_->SetNumberOfComponents(3);
  constexpr int kKeepOurs = 1;
  coordinates_->SetArray(places_.data(), places_.size(), kKeepOurs);
  points_->SetData(coordinates_);
  normals_->SetName("Normals");
  normals_->SetNumberOfComponents(3);
  normals_->SetNumberOfTuples(places_.rows());
  for (vtkPolyData* const data : {surfaceData_.Get(), edgeData_.Get(), meshEdgeData_.Get()}) data->SetPoints(points_);
  surfaceData_->GetPointData()->SetNormals(normals_);
  surfaceData_->SetPolys(toCells(shaded_->triangles));
  edgeData_->SetLines(linesOf(shaded_->creases));
  for (vtkPolyDataMapper* const mapper :
       {surfaceMapper_.Get(), coarseMapper_.Get(), edgeMapper_.Get(), meshEdgeMapper_.Get()})
    mapper->SetClippingPlanes(sectionPlanes_);
  surfaceMapper_->SetInputData(surfaceData_);
  surface_->SetMapper(surfaceMapper_);
  clearColors();
  showLines(*edges_, *edgeMapper_, *edgeData_);
  showLines(*meshEdges_, *meshEdgeMapper_, *meshEdgeData_);
  setSurfaceLook(*surface_->GetProperty());
  setEdgeLook(*edges_, 0.75, kEdgePixels);
  setEdgeLook(*meshEdges_, 0.35, kMeshEdgePixels);
  setPositions(model.mesh.positions);
}

MeshActor::~MeshActor()
{
  // An actor that is still in use draws a copy.
  vtkNew<vtkDoubleArray> copy;
  copy->DeepCopy(coordinates_);
  points_->SetData(copy);
}

void MeshActor::setPositions(const Positions& positions)
{
  parallelBlocks(places_.rows(), [&](Index k) { places_.row(k) = positions.row(shaded_->vertexOf[k]); });
  coordinates_->Modified();
  points_->Modified();
  areNormalsOld_ = true;
  isCoarseOld_ = true;
  update();
}

void MeshActor::updateNormals()
{
  const Positions& normals = doubleNormals_->at(places_);
  std::transform(normals.data(), normals.data() + normals.size(), normals_->GetPointer(0),
                 [](double value) { return static_cast<float>(value); });
  normals_->Modified();
  areNormalsOld_ = false;
}

void MeshActor::clearColors()
{
  surfaceMapper_->ScalarVisibilityOff();
  colorCoarse();
}

void MeshActor::setMeshEdges(MeshEdges edges)
{
  meshEdgesShown_ = edges;
  edges_->SetVisibility(edges != MeshEdges::None);
  if (edges == MeshEdges::All && meshEdgeData_->GetNumberOfLines() == 0)
    meshEdgeData_->SetLines(linesOf(polygonEdges()));
  update();
}

/// The sides of all polygons of the file that are drawn, each once, as pairs of points.
std::vector<std::array<Index, 2>> MeshActor::polygonEdges() const
{
  const Mesh& mesh = model_.mesh;
  std::vector<char> isFaceHidden(static_cast<std::size_t>(mesh.faces.size()), 0);
  for (std::size_t t = 0; t < isHidden_.size(); ++t) isFaceHidden[model_.triangulation.faceOf[t]] = isHidden_[t];
  const std::vector<Index> pointOf = shaded_->pointOf(mesh.vertexCount());
  std::vector<std::array<Index, 2>> edges;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto corners = mesh.faces[f];
    for (std::size_t k = 0; isFaceHidden[f] == 0 && k < corners.size(); ++k) {
      const Index a = pointOf[corners[k]];
      const Index b = pointOf[corners[(k + 1) % corners.size()]];
      if (a >= 0 && b >= 0 && a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  return sortedOnce(std::move(edges));
}

void MeshActor::setHidden(std::vector<char> isHidden)
{
  if (isHidden_ == isHidden) return;
  isHidden_ = std::move(isHidden);
  if (isHidden_.empty()) return draw(toCells(shaded_->triangles), linesOf(shaded_->creases));
  const auto triangles = toCells(shaded_->triangles, [this](Index triangle) { return isHidden_[triangle] == 0; });
  draw(triangles, linesOf(shaded_->creasesWithout(isHidden_)));
}

void MeshActor::setHiddenAs(const MeshActor& other)
{
  isHidden_ = other.isHidden_;
  draw(other.surfaceData_->GetPolys(), other.edgeData_->GetLines());
}

void MeshActor::draw(vtkCellArray* triangles, vtkCellArray* creases)
{
  surfaceData_->SetPolys(triangles);
  edgeData_->SetLines(creases);
  meshEdgeData_->SetLines(nullptr);
  if (coarse_) coarse_->setHidden(isHidden_);
  setMeshEdges(meshEdgesShown_);
}

void MeshActor::setSurfaceDisplay(SurfaceDisplay display)
{
  constexpr std::array kRepresentations{VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS};
  surface_->GetProperty()->SetRepresentation(kRepresentations[static_cast<std::size_t>(display)]);
}

void MeshActor::setDetail(Detail detail)
{
  detail_ = detail;
  if (detail == Detail::Coarse && coarseMapper_->GetInput() == nullptr) {
    coarseMapper_->SetInputData(&coarse().data());
    colorCoarse();
  }
  update();
}

bool MeshActor::isCoarse() const
{
  const Index drawn = surfaceData_->GetNumberOfPolys();
  return detail_ == Detail::Coarse && 2 * drawn > 3 * kCoarseTriangles && coarse().triangles().size() < drawn;
}

void MeshActor::lookFrom(const Vector3& eye)
{
  eye_ = eye;
  update();
}

void MeshActor::setSection(const std::optional<SectionPlane>& section)
{
  // Mappers compile their shaders again when planes are added or removed, not when one moves.
  if (!section) {
    sectionPlanes_->RemoveAllItems();
  } else {
    sectionPlane_->SetOrigin(section->origin.data());
    sectionPlane_->SetNormal(section->normal.data());
    if (sectionPlanes_->GetNumberOfItems() == 0) sectionPlanes_->AddItem(sectionPlane_);
  }
  update();
}

const CoarseSurface& MeshActor::coarse() const
{
  if (!coarse_) {
    coarse_ = std::make_unique<CoarseSurface>(model_, *shaded_);
    coarse_->setHidden(isHidden_);
  }
  if (std::exchange(isCoarseOld_, false)) coarse_->follow(places_);
  return *coarse_;
}

void MeshActor::colorCoarse()
{
  if (coarseMapper_->GetInput() == nullptr) return;
  const bool isColored = surfaceMapper_->GetScalarVisibility() != 0;
  coarse_->color(isColored ? vtkDoubleArray::SafeDownCast(surfaceData_->GetPointData()->GetScalars()) : nullptr);
  coarseMapper_->SetScalarVisibility(surfaceMapper_->GetScalarVisibility());
  if (!isColored) return;
  coarseMapper_->SetLookupTable(surfaceMapper_->GetLookupTable());
  coarseMapper_->UseLookupTableScalarRangeOn();
  coarseMapper_->SetInterpolateScalarsBeforeMapping(surfaceMapper_->GetInterpolateScalarsBeforeMapping());
}

void MeshActor::update()
{
  const bool isCoarse = this->isCoarse();
  if (!isCoarse && areNormalsOld_) updateNormals();
  surface_->SetMapper(isCoarse ? coarseMapper_ : surfaceMapper_);
  const bool isOpened = sectionPlanes_->GetNumberOfItems() > 0;
  surface_->GetProperty()->SetBackfaceCulling(isCoarse && coarse().isSolid() && eye_ && !coarse().isNear(*eye_) &&
                                              !isOpened);
  meshEdges_->SetVisibility(meshEdgesShown_ == MeshEdges::All && !isCoarse);
}

void MeshActor::setColors(const std::vector<double>& values, const ColorScale& scale,
                          const std::vector<double>& pointValues)
{
  assert(pointValues.empty() || pointValues.size() == shaded_->vertexOf.size());
  vtkNew<vtkDoubleArray> shares;
  shares->SetName("shares of the scale");
  shares->SetNumberOfValues(static_cast<vtkIdType>(shaded_->vertexOf.size()));
  std::atomic<bool> isComplete = true;
  parallelBlocks(shares->GetNumberOfValues(), [&](Index k) {
    assert(shaded_->vertexOf[k] < static_cast<Index>(values.size()));
    const double place = tablePlace(scale, pointValues.empty() ? values[shaded_->vertexOf[k]] : pointValues[k]);
    if (std::isnan(place)) isComplete = false;
    shares->SetValue(k, place);
  });
  surfaceData_->GetPointData()->SetScalars(shares);
  surfaceMapper_->SetLookupTable(toLookupTable(scale));
  surfaceMapper_->UseLookupTableScalarRangeOn();
  surfaceMapper_->SetInterpolateScalarsBeforeMapping(isComplete);
  surfaceMapper_->ScalarVisibilityOn();
  colorCoarse();
}

void MeshActor::setPixelRatio(double ratio)
{
  setLineWidth(*edges_, kEdgePixels * ratio);
  setLineWidth(*meshEdges_, kMeshEdgePixels * ratio);
  setLineWidth(*surface_, kMeshEdgePixels * ratio);
  setPointSize(*surface_, kPointPixels * ratio);
}

}  // namespace holdfast
