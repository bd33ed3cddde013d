#include "holdfast/widgets/files/poly_data_normals.h"

#include <Eigen/Geometry>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

/// A stored normal that is out of date, by its tuple, with the vectors that it is normal to before and after.
struct Outdated {
  vtkIdType tuple = 0;
  Vector3 rest;
  Vector3 moved;
};

std::vector<Index> movedFaces(const Mesh& rest, const Positions& positions)
{
  std::vector<Index> faces;
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f])
      if (positions.row(v) != rest.positions.row(v)) {
        faces.push_back(f);
        break;
      }
  return faces;
}

/// In VTK the cells of a surface are numbered through: vertices, lines, polygons.
std::vector<Outdated> outdatedFaces(const vtkIdType firstPolygon, const Mesh& rest, const Positions& positions)
{
  std::vector<Outdated> outdated;
  for (const Index f : movedFaces(rest, positions))
    outdated.push_back(
        {firstPolygon + f, areaVector(rest.positions, rest.faces[f]), areaVector(positions, rest.faces[f])});
  return outdated;
}

std::vector<Outdated> outdatedPoints(const Mesh& rest, const Positions& positions)
{
  std::vector<char> isOutdated(rest.vertexCount(), 0);
  for (const Index f : movedFaces(rest, positions))
    for (const Index v : rest.faces[f]) isOutdated[v] = 1;

  Positions before = Positions::Zero(rest.vertexCount(), 3);
  Positions after = Positions::Zero(rest.vertexCount(), 3);
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f])
      if (isOutdated[v]) {
        before.row(v) += areaVector(rest.positions, rest.faces[f]);
        after.row(v) += areaVector(positions, rest.faces[f]);
      }

  std::vector<Outdated> outdated;
  for (Index v = 0; v < rest.vertexCount(); ++v)
    if (isOutdated[v]) outdated.push_back({v, before.row(v), after.row(v)});
  return outdated;
}

/// The array that holds normals: the one that the file declares as such, or the one that is called so.
vtkDataArray* storedNormals(vtkDataSetAttributes& attributes)
{
  vtkDataArray* normals = attributes.GetNormals();
  if (normals == nullptr) normals = attributes.GetArray("Normals");
  return normals != nullptr && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
}

/// A copy of `normals` with those that are outdated made anew; the original belongs to the file as it was read.
vtkSmartPointer<vtkDataArray> refreshed(vtkDataArray& normals, const std::vector<Outdated>& outdated)
{
  auto result = vtkSmartPointer<vtkDataArray>::Take(normals.NewInstance());
  result->DeepCopy(&normals);
  for (const Outdated& entry : outdated) {
    Vector3 stored;
    result->GetTuple(entry.tuple, stored.data());
    const double side = stored.dot(entry.rest) < 0 ? -1 : 1;
    const Vector3 normal = side * entry.moved.normalized();
    result->SetTuple(entry.tuple, normal.data());
  }
  result->Modified();
  return result;
}

}  // namespace

std::vector<std::string> refreshNormals(vtkPolyData& polyData, const Mesh& rest, const Positions& positions)
{
  std::vector<std::string> notes;
  const auto refresh = [&](vtkDataSetAttributes& attributes, const std::vector<Outdated>& outdated, const char* where) {
    vtkDataArray* normals = storedNormals(attributes);
    if (normals == nullptr || outdated.empty()) return;
    attributes.AddArray(refreshed(*normals, outdated));
    notes.push_back(std::to_string(outdated.size()) + " normals of " + where + " recomputed");
  };
  if (storedNormals(*polyData.GetPointData()) != nullptr)
    refresh(*polyData.GetPointData(), outdatedPoints(rest, positions), "points");
  const vtkIdType firstPolygon = polyData.GetNumberOfVerts() + polyData.GetNumberOfLines();
  if (storedNormals(*polyData.GetCellData()) != nullptr)
    refresh(*polyData.GetCellData(), outdatedFaces(firstPolygon, rest, positions), "faces");
  return notes;
}

}  // namespace holdfast
