#include "holdfast/io/ply_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/io/ply_header.h>
#include <holdfast/io/ply_scanner.h>
#include <holdfast/io/ply_source.h>

namespace holdfast {
namespace {

/// The parts of a header that make the mesh.
struct MeshElements {
  const PlyElement* vertex = nullptr;
  const PlyElement* face = nullptr;
  Index corners = -1;  // property of `face`
};

const PlyElement& requireElement(const PlyHeader& header, std::string_view name, const std::string& file)
{
  const PlyElement* const element = header.find(name);
  if (element == nullptr)
    throw InputError({file, 0, {}},
                     fmt::format("the header has no element {}: export the file as a polygon mesh", quotedToken(name)));
  if (element->count == 0)
    throw InputError({file, element->line, {}},
                     name == "face" ? "the mesh has no faces: export it as a polygon mesh, not as points"
                                    : "the mesh has no vertices: export it again");
  return *element;
}

Index cornersOf(const PlyElement& face, const std::string& file)
{
  const Index usual = face.find("vertex_indices");
  const Index corners = usual >= 0 ? usual : face.find("vertex_index");
  if (corners < 0 || !face.properties[corners].isList() || !isInteger(face.properties[corners].type))
    throw InputError({file, face.line, {}},
                     "the element 'face' needs the property 'list uchar int vertex_indices' (or "
                     "vertex_index) of a whole type: export the file as a polygon mesh");
  return corners;
}

MeshElements meshElements(const PlyHeader& header, const std::string& file)
{
  const PlyElement& vertex = requireElement(header, "vertex", file);
  for (const std::string_view name : {"x", "y", "z"}) {
    const Index property = vertex.find(name);
    if (property < 0 || vertex.properties[property].isList())
      throw InputError({file, vertex.line, {}},
                       fmt::format("the element 'vertex' has no number {}: it needs x, y and z", quotedToken(name)));
  }
  const PlyElement& face = requireElement(header, "face", file);
  return {&vertex, &face, cornersOf(face, file)};
}

/// Reads the body with one of the two scanners.
template <class Scanner>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, const MeshElements& elements, Scanner scanner)
      : header_(header), elements_(elements), scanner_(std::move(scanner))
  {
  }

  void read();
  [[nodiscard]] Mesh takeMesh() && { return std::move(mesh_); }
  [[nodiscard]] PlyPlace vertices() const { return vertices_; }

 private:
  void readVertices();
  void readFaces();
  void readCorners(const PlyProperty& property, Index face);
  void skipElement(const PlyElement& element);
  void skipProperty(const PlyProperty& property);
  Index listSize(const PlyProperty& property);
  [[nodiscard]] std::size_t leastRowBytes(const PlyElement& element) const;
  void expectRoom(const PlyElement& element, std::size_t rowBytes) const;

  const PlyHeader& header_;
  const MeshElements& elements_;
  Scanner scanner_;
  Mesh mesh_;
  PlyPlace vertices_;
  std::vector<Index> polygon_;
};

template <class Scanner>
void BodyReader<Scanner>::read()
{
  for (const PlyElement& element : header_.elements) {
    expectRoom(element, leastRowBytes(element));
    if (&element == elements_.vertex)
      readVertices();
    else if (&element == elements_.face)
      readFaces();
    else
      skipElement(element);
  }
  scanner_.expectEnd();
}

template <class Scanner>
void BodyReader<Scanner>::readVertices()
{
  vertices_ = scanner_.place();
  const PlyElement& vertex = *elements_.vertex;
  const std::array<Index, 3> columns{vertex.find("x"), vertex.find("y"), vertex.find("z")};
  mesh_.positions.resize(vertex.count, 3);
  for (Index v = 0; v < vertex.count; ++v) {
    scanner_.beginRow(vertex, v);
    for (Index p = 0; p < static_cast<Index>(vertex.properties.size()); ++p) {
      const auto column = std::find(columns.begin(), columns.end(), p);
      if (column == columns.end())
        skipProperty(vertex.properties[p]);
      else
        mesh_.positions(v, column - columns.begin()) = scanner_.value(vertex.properties[p]).number;
    }
    scanner_.endRow();
  }
}

template <class Scanner>
void BodyReader<Scanner>::readFaces()
{
  const PlyElement& face = *elements_.face;
  mesh_.faces.reserve(face.count, 3 * face.count);
  for (Index f = 0; f < face.count; ++f) {
    scanner_.beginRow(face, f);
    for (Index p = 0; p < static_cast<Index>(face.properties.size()); ++p) {
      if (p == elements_.corners)
        readCorners(face.properties[p], f);
      else
        skipProperty(face.properties[p]);
    }
    scanner_.endRow();
  }
}

template <class Scanner>
void BodyReader<Scanner>::readCorners(const PlyProperty& property, Index face)
{
  const Index size = listSize(property);
  if (size < 3) scanner_.fail(fmt::format("face {} has {} corners: it needs three or more; remove it", face, size));
  polygon_.clear();
  for (Index k = 0; k < size; ++k) {
    const Index vertex = scanner_.integer(property.type, "a corner of the face");
    if (vertex < 0 || vertex >= elements_.vertex->count)
      scanner_.fail(fmt::format("vertex {} of face {} does not exist: the file has {} vertices, numbered from 0",
                                vertex, face, elements_.vertex->count));
    polygon_.push_back(vertex);
  }
  mesh_.faces.add(polygon_);
}

template <class Scanner>
void BodyReader<Scanner>::skipElement(const PlyElement& element)
{
  if (element.properties.empty()) return;  // rows of nothing, however many
  for (Index row = 0; row < element.count; ++row) {
    scanner_.beginRow(element, row);
    for (const PlyProperty& property : element.properties) skipProperty(property);
    scanner_.endRow();
  }
}

template <class Scanner>
void BodyReader<Scanner>::skipProperty(const PlyProperty& property)
{
  const Index values = property.isList() ? listSize(property) : 1;
  scanner_.skip(property.type, values);
}

template <class Scanner>
Index BodyReader<Scanner>::listSize(const PlyProperty& property)
{
  const Index size = scanner_.integer(*property.countType, "the length of a list");
  if (size < 0) scanner_.fail(fmt::format("the length {} of a list is negative: correct it", size));
  return size;
}

template <class Scanner>
std::size_t BodyReader<Scanner>::leastRowBytes(const PlyElement& element) const
{
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += scanner_.leastBytes(property.countType.value_or(property.type));
  if (&element == elements_.face) bytes += 3 * scanner_.leastBytes(element.properties[elements_.corners].type);
  return bytes;
}

template <class Scanner>
void BodyReader<Scanner>::expectRoom(const PlyElement& element, std::size_t rowBytes) const
{
  if (rowBytes == 0 || static_cast<std::size_t>(element.count) <= scanner_.room() / rowBytes) return;
  scanner_.fail(
      fmt::format("the header promises {} rows of element {}, of {} bytes at least, but only {} bytes follow: "
                  "the file is truncated, or the count is wrong",
                  element.count, quotedToken(element.name), rowBytes, scanner_.remaining()));
}

template <class Scanner>
MeshDocument readBody(std::string bytes, const PlyHeader& header, const MeshElements& elements, Scanner scanner)
{
  BodyReader<Scanner> reader(header, elements, std::move(scanner));
  reader.read();
  const PlyPlace vertices = reader.vertices();
  Mesh mesh = std::move(reader).takeMesh();
  return {mesh, makePlySource(std::move(bytes), vertices, mesh)};
}

}  // namespace

MeshDocument readPly(std::string bytes, const std::string& file)
{
  const PlyHeader header = parsePlyHeader(bytes, file);
  const MeshElements elements = meshElements(header, file);
  const PlyPlace body{header.bodyOffset, header.bodyLine};
  const std::string_view view = bytes;
  if (header.encoding == PlyEncoding::kText)
    return readBody(std::move(bytes), header, elements, PlyTextScanner(view, file, body));
  return readBody(std::move(bytes), header, elements, PlyBinaryScanner(view, file, body, byteOrder(header.encoding)));
}

}  // namespace holdfast
