// What the example data promise. The files are read here by a few lines of their own, so that the data are judged
// without the readers that they are there to try.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/mesh/mesh.h>

#include "support/source_tree.h"

namespace holdfast {
namespace {

const std::filesystem::path kData = test::dataFolder();

Mesh meshOf(const std::vector<Vector3>& points, const Polygons& faces)
{
  Mesh mesh{Positions(static_cast<Index>(points.size()), 3), faces};
  for (Index i = 0; i < mesh.vertexCount(); ++i) mesh.positions.row(i) = points[i].transpose();
  return mesh;
}

// "v" and "f" lines; what follows a slash is left out.
Mesh readObjData(const std::string& name)
{
  std::ifstream file(kData / name);
  std::vector<Vector3> points;
  Polygons faces;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      Vector3 point;
      words >> point.x() >> point.y() >> point.z();
      points.push_back(point);
    }
    if (key != "f") continue;
    std::vector<Index> corners;
    for (std::string corner; words >> corner;) corners.push_back(std::stol(corner) - 1);
    faces.add(corners);
  }
  return meshOf(points, faces);
}

template <typename Number>
Number take(std::istream& stream)
{
  Number number{};
  stream.read(reinterpret_cast<char*>(&number), sizeof number);
  return number;
}

// The layout that the generator writes: three doubles a vertex; a count and three ints a face.
Mesh readPlyData(const std::string& name)
{
  std::ifstream file(kData / name, std::ios::binary);
  std::map<std::string, Index> counts;
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string key, element;
    if (words >> key >> element && key == "element") words >> counts[element];
  }
  std::vector<Vector3> points(counts["vertex"]);
  for (Vector3& point : points) {
    for (double& coordinate : point) coordinate = take<double>(file);
  }
  Polygons faces;
  for (Index face = 0; face < counts["face"]; ++face) {
    take<unsigned char>(file);
    const Index a = take<int>(file), b = take<int>(file), c = take<int>(file);
    faces.add({a, b, c});
  }
  EXPECT_TRUE(file.good());
  return meshOf(points, faces);
}

Mesh readOffData(const std::string& name)
{
  std::ifstream file(kData / name);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  Index vertices = 0, count = 0, edges = 0;
  file >> vertices >> count >> edges;
  std::vector<Vector3> points(vertices);
  for (Vector3& point : points) file >> point.x() >> point.y() >> point.z();
  Polygons faces;
  for (Index face = 0; face < count; ++face) {
    Index corners = 0, a = 0, b = 0, c = 0;
    file >> corners >> a >> b >> c;
    faces.add({a, b, c});
  }
  EXPECT_TRUE(file.good());
  return meshOf(points, faces);
}

Mesh readData(const std::string& name)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  return extension == ".ply" ? readPlyData(name) : extension == ".off" ? readOffData(name) : readObjData(name);
}

double smallestAngleDegrees(const Mesh& mesh)
{
  double result = 180;
  for (Index face = 0; face < mesh.faces.size(); ++face) {
    const auto corners = mesh.faces[face];
    for (Index k = 0; k < 3; ++k) {
      const Vector3 at = mesh.positions.row(corners[k]);
      const Vector3 u = mesh.positions.row(corners[(k + 1) % 3]).transpose() - at;
      const Vector3 v = mesh.positions.row(corners[(k + 2) % 3]).transpose() - at;
      result = std::min(result, std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi);
    }
  }
  return result;
}

std::map<std::pair<Index, Index>, int> halfEdgeCounts(const Mesh& mesh)
{
  std::map<std::pair<Index, Index>, int> result;
  for (Index face = 0; face < mesh.faces.size(); ++face) {
    const auto corners = mesh.faces[face];
    for (std::size_t k = 0; k < corners.size(); ++k) ++result[{corners[k], corners[(k + 1) % corners.size()]}];
  }
  return result;
}

double signedVolume(const Mesh& mesh)
{
  double result = 0;
  for (Index face = 0; face < mesh.faces.size(); ++face) {
    const auto corners = mesh.faces[face];
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Vector3 a = mesh.positions.row(corners[0]), b = mesh.positions.row(corners[k - 1]),
                    c = mesh.positions.row(corners[k]);
      result += a.dot(b.cross(c)) / 6;
    }
  }
  return result;
}

class ClosedData : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Data, ClosedData,
                         testing::Values("bracket.obj", "bar.obj", "head.ply", "two_parts.obj", "quads.obj",
                                         "shaft_slivers.off"));

TEST_P(ClosedData, IsAClosedSurfaceFacingOutward)
{
  const Mesh mesh = readData(GetParam());
  ASSERT_GT(mesh.faces.size(), 0);
  const auto counts = halfEdgeCounts(mesh);
  for (const auto& [ends, count] : counts) {
    ASSERT_EQ(count, 1) << ends.first << " " << ends.second;
    ASSERT_TRUE(counts.contains({ends.second, ends.first})) << ends.first << " " << ends.second;
  }
  EXPECT_GT(signedVolume(mesh), 0);
}

class ExampleData : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Data, ExampleData,
                         testing::Values("bracket.obj", "bar.obj", "head.ply", "plate_unsymmetric.off"));

TEST_P(ExampleData, HasNoNeedles)
{
  EXPECT_GT(smallestAngleDegrees(readData(GetParam())), 25);
}

TEST_P(ExampleData, HasNoTwoVerticesInOnePlaceAndNoneUnused)
{
  const Mesh mesh = readData(GetParam());
  std::set<std::array<double, 3>> places;
  std::set<Index> used;
  for (Index i = 0; i < mesh.vertexCount(); ++i) {
    places.insert({mesh.positions(i, 0), mesh.positions(i, 1), mesh.positions(i, 2)});
  }
  for (Index face = 0; face < mesh.faces.size(); ++face) used.insert(mesh.faces[face].begin(), mesh.faces[face].end());
  EXPECT_EQ(static_cast<Index>(places.size()), mesh.vertexCount());
  EXPECT_EQ(static_cast<Index>(used.size()), mesh.vertexCount());
}

TEST(BracketData, VerticesOfTheBoreLieOnItsCircles)
{
  const Mesh mesh = readObjData("bracket.obj");
  Index onRim = 0;
  for (const auto& position : mesh.positions.rowwise()) {
    const double distance = std::hypot(position.x(), position.z() - 50);
    if (position.y() == 10 && distance < 15.1) {
      EXPECT_NEAR(distance, 15, 1e-6);
      ++onRim;
    }
  }
  EXPECT_EQ(onRim, 64);
}

// The mesh that a constraint file or a point list belongs to: the part of its name before the first dot.
std::string meshNameOf(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  const std::string stem = name.substr(0, name.find('.'));
  for (const char* extension : {".obj", ".off", ".ply", ".stl"}) {
    if (std::filesystem::exists(kData / (stem + extension))) return stem + extension;
  }
  return {};
}

std::vector<std::filesystem::path> filesEndingWith(const std::string& ending)
{
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(kData)) {
    if (entry.path().string().ends_with(ending)) result.push_back(entry.path());
  }
  return result;
}

TEST(ShaftData, HasTheSliversThatItIsThereFor)
{
  const Mesh mesh = readData("shaft_slivers.off");
  EXPECT_NEAR(smallestAngleDegrees(mesh), 0.573, 1e-3);
  std::set<Index> used;
  for (Index face = 0; face < mesh.faces.size(); ++face)
    for (const Index vertex : mesh.faces[face]) used.insert(vertex);
  EXPECT_EQ(static_cast<Index>(used.size()), mesh.vertexCount());
}

TEST(ConstraintData, HasAMeshUniqueNamesAndKnownTypes)
{
  const auto files = filesEndingWith(".constraints.json");
  ASSERT_GE(files.size(), 6);
  for (const auto& path : files) {
    SCOPED_TRACE(path);
    EXPECT_NE(meshNameOf(path), "");
    std::ifstream file(path);
    const auto json = nlohmann::json::parse(file);
    EXPECT_EQ(json.at("format"), "holdfast-constraints");
    EXPECT_THAT(json.at("version"), testing::AnyOf(1, 2));
    std::set<std::string> names;
    for (const auto& constraint : json.at("constraints")) {
      EXPECT_THAT(constraint.at("type"),
                  testing::AnyOf("fixed", "handle", "point", "rigid", "relative", "slide", "coincident", "mirror"));
      EXPECT_TRUE(names.insert(constraint.at("name")).second) << constraint.at("name");
    }
  }
}

TEST(ConstraintData, NamesOnlyVerticesAndFacesThatTheBracketHas)
{
  const Mesh mesh = readObjData("bracket.obj");
  const auto counts = halfEdgeCounts(mesh);
  for (const char* name : {"bracket.constraints.json", "bracket.conflict.constraints.json"}) {
    std::ifstream file(kData / name);
    const auto json = nlohmann::json::parse(file);
    for (const auto& constraint : json.at("constraints")) {
      const auto at = constraint.value("at", nlohmann::json::object());
      EXPECT_LT(at.value("vertex", Index{0}), mesh.vertexCount());
      EXPECT_LT(at.value("face", Index{0}), mesh.faces.size());
      const auto edge = at.value("edge", std::vector<Index>{});
      EXPECT_TRUE(edge.empty() || counts.contains({edge[0], edge[1]})) << at;
    }
  }
}

double distanceToNearestVertex(const Mesh& mesh, const Vector3& place)
{
  return (mesh.positions.rowwise() - place.transpose()).rowwise().norm().minCoeff();
}

TEST(PointListData, StartsOnItsMeshAndMovesByLessThanATenthOfItsSize)
{
  constexpr double kLongestEdge = 3;
  const auto files = filesEndingWith(".measured.csv");
  ASSERT_EQ(files.size(), 4);
  for (const auto& path : files) {
    SCOPED_TRACE(path);
    const Mesh mesh = readData(meshNameOf(path));
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "name,x,y,z,target_x,target_y,target_z");
    while (std::getline(file, line)) {
      std::string coordinates = line.substr(line.find(','));
      std::ranges::replace(coordinates, ',', ' ');
      std::istringstream numbers(coordinates);
      Vector3 rest, target;
      numbers >> rest.x() >> rest.y() >> rest.z() >> target.x() >> target.y() >> target.z();
      ASSERT_FALSE(numbers.fail()) << line;
      EXPECT_LT(distanceToNearestVertex(mesh, rest), kLongestEdge) << line;
      EXPECT_LT((target - rest).norm(), 10) << line;
    }
  }
}

}  // namespace
}  // namespace holdfast
