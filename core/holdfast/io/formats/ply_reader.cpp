#include "holdfast/io/formats/ply_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/counted.h>
#include <holdfast/base/error.h>
#include <holdfast/io/formats/ply_header.h>
#include <holdfast/io/formats/ply_scanner.h>
#include <holdfast/io/formats/ply_source.h>

namespace holdfast {
namespace {

/// The parts of a header that make the mesh.
struct MeshElements {
  const PlyElement* vertex = nullptr;
  const PlyElement* surface = nullptr;
  Index corners = -1;  // property of `surface`
};

[[noreturn]] void failWithoutFaces(const std::string& file, Index line)
{
  throw InputError({file, line, {}}, "the mesh has no faces: export it as a polygon mesh, not as points");
}

/// `element`, which is called `name` and must be there.
const PlyElement& require(const PlyElement* element, std::string_view name, const std::string& file)
{
  if (element != nullptr) return *element;
  throw InputError({file, 0, {}},
                   fmt::format("the header has no element {}: export the file as a polygon mesh", quotedToken(name)));
}

Index cornersOf(const PlyElement& surface, const std::string& file)
{
  const Index usual = surface.find("vertex_indices");
  const Index corners = usual >= 0 ? usual : surface.find("vertex_index");
  if (corners < 0 || !surface.properties[corners].isList() || !isInteger(surface.properties[corners].type))
    throw InputError({file, surface.line, {}},
                     fmt::format("the element {} needs the property 'list {} int vertex_indices' (or vertex_index) of "
                                 "a whole type: export the file as a polygon mesh",
                                 quotedToken(surface.name), surface.hasStrips() ? "int" : "uchar"));
  return corners;
}

MeshElements meshElements(const PlyHeader& header, const std::string& file)
{
  const PlyElement& vertex = require(header.find("vertex"), "vertex", file);
  if (vertex.count == 0) throw InputError({file, vertex.line, {}}, "the mesh has no vertices: export it again");
  for (const std::string_view name : {"x", "y", "z"}) {
    const Index property = vertex.find(name);
    if (property < 0 || vertex.properties[property].isList())
      throw InputError({file, vertex.line, {}},
                       fmt::format("the element 'vertex' has no number {}: it needs x, y and z", quotedToken(name)));
  }
  const PlyElement& surface = require(header.surface(), "face", file);
  if (surface.count == 0) failWithoutFaces(file, surface.line);
  return {&vertex, &surface, cornersOf(surface, file)};
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
  void readSurface();
  void readCorners(const PlyProperty& property, Index face);
  void readStrips(const PlyProperty& property);
  void addStrip();
  void requireVertex(Index vertex, std::string_view owner, Index id) const;
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
  std::vector<Index> polygon_;  // the face or the strip that is being read
  Index strip_ = 0;
};

template <class Scanner>
void BodyReader<Scanner>::read()
{
  for (const PlyElement& element : header_.elements) {
    expectRoom(element, leastRowBytes(element));
    if (&element == elements_.vertex)
      readVertices();
    else if (&element == elements_.surface)
      readSurface();
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
void BodyReader<Scanner>::readSurface()
{
  const PlyElement& surface = *elements_.surface;
  mesh_.faces.reserve(surface.count, 3 * surface.count);
  for (Index row = 0; row < surface.count; ++row) {
    scanner_.beginRow(surface, row);
    for (Index p = 0; p < static_cast<Index>(surface.properties.size()); ++p) {
      if (p != elements_.corners)
        skipProperty(surface.properties[p]);
      else if (surface.hasStrips())
        readStrips(surface.properties[p]);
      else
        readCorners(surface.properties[p], row);
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
    requireVertex(vertex, "face", face);
    polygon_.push_back(vertex);
  }
  mesh_.faces.add(polygon_);
}

template <class Scanner>
void BodyReader<Scanner>::readStrips(const PlyProperty& property)
{
  constexpr Index kEndOfStrip = -1;
  const Index size = listSize(property);
  for (Index k = 0; k < size; ++k) {
    const Index vertex = scanner_.integer(property.type, "a corner of a strip");
    if (vertex == kEndOfStrip) {
      addStrip();
      continue;
    }
    requireVertex(vertex, "strip", strip_);
    polygon_.push_back(vertex);
  }
  addStrip();
}

/// Adds the triangles of the strip in `polygon_`, and begins the next one. An end may follow an end.
template <class Scanner>
void BodyReader<Scanner>::addStrip()
{
  if (polygon_.empty()) return;
  if (polygon_.size() < 3)
    scanner_.fail(fmt::format("strip {} has {}: it needs three or more; remove it", strip_,
                              counted(static_cast<Index>(polygon_.size()), "corner")));
  for (std::size_t k = 0; k + 2 < polygon_.size(); ++k) {
    const Index a = polygon_[k + k % 2];
    const Index b = polygon_[k + 1 - k % 2];
    const Index c = polygon_[k + 2];
    if (a != b && b != c && c != a) mesh_.faces.add({a, b, c});
  }
  polygon_.clear();
  ++strip_;
}

template <class Scanner>
void BodyReader<Scanner>::requireVertex(Index vertex, std::string_view owner, Index id) const
{
  if (vertex >= 0 && vertex < elements_.vertex->count) return;
  scanner_.fail(fmt::format("vertex {} of {} {} does not exist: the file has {} vertices, numbered from 0", vertex,
                            owner, id, elements_.vertex->count));
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
  if (&element == elements_.surface && !element.hasStrips())
    bytes += 3 * scanner_.leastBytes(element.properties[elements_.corners].type);
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
MeshDocument readBody(std::string bytes, const PlyHeader& header, const MeshElements& elements, Scanner scanner,
                      const std::string& file)
{
  BodyReader<Scanner> reader(header, elements, std::move(scanner));
  reader.read();
  const PlyPlace vertices = reader.vertices();
  Mesh mesh = std::move(reader).takeMesh();
  if (mesh.faces.isEmpty()) failWithoutFaces(file, elements.surface->line);
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
    return readBody(std::move(bytes), header, elements, PlyTextScanner(view, file, body), file);
  return readBody(std::move(bytes), header, elements, PlyBinaryScanner(view, file, body, byteOrder(header.encoding)),
                  file);
}

}  // namespace holdfast
