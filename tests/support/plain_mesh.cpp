#include "support/plain_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.h"

namespace holdfast::test {
namespace {

double nextNumber(std::istream& stream)
{
  std::string word;
  stream >> word;
  return std::strtod(word.c_str(), nullptr);
}

PlainPoint nextPoint(std::istream& stream)
{
  PlainPoint point{};
  for (double& coordinate : point) coordinate = nextNumber(stream);
  return point;
}

PlainMesh readObj(const std::string& bytes)
{
  PlainMesh mesh;
  std::istringstream file(bytes);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") mesh.positions.push_back(nextPoint(words));
    if (key != "f") continue;
    std::vector<long> face;
    for (std::string corner; words >> corner;) {
      const long id = std::stol(corner);
      face.push_back(id > 0 ? id - 1 : static_cast<long>(mesh.positions.size()) + id);
    }
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

/// The next line that is neither empty nor a comment.
std::istringstream nextLine(std::istream& file)
{
  for (std::string line; std::getline(file, line);) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string::npos) return std::istringstream(line);
  }
  return {};
}

PlainMesh readOff(const std::string& bytes)
{
  PlainMesh mesh;
  std::istringstream file(bytes);
  std::istringstream line = nextLine(file);
  std::string magic;
  line >> magic;
  long vertices = 0;
  long faces = 0;
  if (!(line >> vertices >> faces)) nextLine(file) >> vertices >> faces;
  for (long v = 0; v < vertices; ++v) {
    line = nextLine(file);
    mesh.positions.push_back(nextPoint(line));
  }
  for (long f = 0; f < faces; ++f) {
    line = nextLine(file);
    std::size_t corners = 0;
    line >> corners;
    mesh.faces.emplace_back(corners);
    for (long& corner : mesh.faces.back()) line >> corner;
  }
  return mesh;
}

template <class Number>
Number take(std::istream& stream)
{
  std::array<char, sizeof(Number)> bytes{};
  stream.read(bytes.data(), bytes.size());
  Number number{};
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

void addFacet(PlainMesh& mesh)
{
  const long last = static_cast<long>(mesh.positions.size());
  if (last % 3 == 0) mesh.faces.push_back({last - 3, last - 2, last - 1});
}

PlainMesh readStl(const std::string& bytes)
{
  PlainMesh mesh;
  std::istringstream file(bytes);
  if (bytes.starts_with("solid")) {
    for (std::string word; file >> word;) {
      if (word != "vertex") continue;
      mesh.positions.push_back(nextPoint(file));
      addFacet(mesh);
    }
    return mesh;
  }
  file.ignore(80);
  for (auto left = take<std::uint32_t>(file); left > 0; --left) {
    file.ignore(12);
    for (int corner = 0; corner < 3; ++corner) {
      PlainPoint& point = mesh.positions.emplace_back();
      for (double& coordinate : point) coordinate = take<float>(file);
    }
    file.ignore(2);
    addFacet(mesh);
  }
  return mesh;
}

/// A property of a PLY element: one number, or a list of them with its length before it.
struct PlyProperty {
  std::string name;
  std::string type;
  std::string lengthType;  // empty for one number
};

struct PlyElement {
  std::string name;
  long count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool isText = false;
  std::vector<PlyElement> elements;
};

PlyHeader readPlyHeader(std::istream& file)
{
  PlyHeader header;
  for (std::string line; std::getline(file, line) && !line.starts_with("end_header");) {
    std::istringstream words(line);
    std::string key;
    std::string value;
    words >> key >> value;
    if (key == "format") header.isText = value == "ascii";
    if (key == "format" && value == "binary_big_endian") throw std::runtime_error("big endian PLY");
    if (key == "element") {
      header.elements.push_back({value, 0, {}});
      words >> header.elements.back().count;
    }
    if (key != "property") continue;
    PlyProperty property{{}, value, {}};
    if (value == "list") words >> property.lengthType >> property.type;
    words >> property.name;
    header.elements.back().properties.push_back(property);
  }
  return header;
}

double plyNumber(std::istream& file, const std::string& type, bool isText)
{
  if (isText) return nextNumber(file);
  if (type == "double" || type == "float64") return take<double>(file);
  if (type == "float" || type == "float32") return take<float>(file);
  if (type == "int" || type == "int32") return take<std::int32_t>(file);
  if (type == "uint" || type == "uint32") return take<std::uint32_t>(file);
  if (type == "short" || type == "int16") return take<std::int16_t>(file);
  if (type == "ushort" || type == "uint16") return take<std::uint16_t>(file);
  if (type == "char" || type == "int8") return take<std::int8_t>(file);
  if (type == "uchar" || type == "uint8") return take<std::uint8_t>(file);
  throw std::runtime_error("PLY type " + type);
}

void takePlyProperty(std::istream& file, const PlyProperty& property, bool isText, PlainMesh& mesh)
{
  std::size_t length = 1;
  if (!property.lengthType.empty()) length = static_cast<std::size_t>(plyNumber(file, property.lengthType, isText));
  std::vector<double> values(length);
  for (double& value : values) value = plyNumber(file, property.type, isText);
  if (property.name == "x") mesh.positions.emplace_back()[0] = values[0];
  if (property.name == "y") mesh.positions.back()[1] = values[0];
  if (property.name == "z") mesh.positions.back()[2] = values[0];
  if (property.name == "vertex_indices" || property.name == "vertex_index")
    mesh.faces.emplace_back(values.begin(), values.end());
}

PlainMesh readPly(const std::string& bytes)
{
  PlainMesh mesh;
  std::istringstream file(bytes);
  const PlyHeader header = readPlyHeader(file);
  for (const PlyElement& element : header.elements)
    for (long k = 0; k < element.count; ++k)
      for (const PlyProperty& property : element.properties) takePlyProperty(file, property, header.isText, mesh);
  return mesh;
}

}  // namespace

PlainMesh readPlainMesh(const std::filesystem::path& path)
{
  const std::string bytes = bytesOf(path);
  const std::string extension = path.extension().string();
  if (extension == ".obj") return readObj(bytes);
  if (extension == ".off") return readOff(bytes);
  if (extension == ".stl") return readStl(bytes);
  if (extension == ".ply") return readPly(bytes);
  throw std::runtime_error("no plain reader for " + path.string());
}

double diagonalOf(const PlainMesh& mesh)
{
  PlainPoint size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlainPoint& point : mesh.positions) {
      low = std::min(low, point[axis]);
      high = std::max(high, point[axis]);
    }
    size[axis] = high - low;
  }
  return std::hypot(size[0], size[1], size[2]);
}

}  // namespace holdfast::test
