#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/counted.h>
#include <holdfast/base/error.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/ply_header.h>
#include <holdfast/io/formats/ply_scanner.h>
#include <holdfast/io/formats/splice_writer.h>
#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 3> kCoordinates{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kNormals{"nx", "ny", "nz"};

class PlySource final : public MeshSource {
 public:
  PlySource(std::string bytes, PlyPlace vertices, Mesh rest)
      : bytes_(std::move(bytes)), header_(parsePlyHeader(bytes_, {})), vertices_(vertices), rest_(std::move(rest))
  {
  }

  [[nodiscard]] std::string extension() const override { return ".ply"; }
  [[nodiscard]] std::vector<std::string> extras() const override;
  [[nodiscard]] Serialized withPositions(const Positions& positions) const override;

 private:
  [[nodiscard]] const PlyElement& vertex() const { return *header_.find("vertex"); }
  [[nodiscard]] NormalUpdate normals(const Positions& positions) const;
  [[nodiscard]] bool promoteHeader(SpliceWriter& writer) const;
  void spliceVertices(SpliceWriter& writer, const Positions& positions, const NormalUpdate& update) const;
  [[nodiscard]] bool needsReplacing(PlyType type, double before, double after) const;

  std::string bytes_;
  PlyHeader header_;  // has views into bytes_
  PlyPlace vertices_;
  Mesh rest_;
};

/// 0, 1 or 2 for each property of `element` that is called `names[0..2]`, -1 for the others.
std::vector<int> roles(const PlyElement& element, const std::array<std::string_view, 3>& names)
{
  std::vector<int> role(element.properties.size(), -1);
  for (int k = 0; k < 3; ++k) {
    const Index property = element.find(names[k]);
    if (property >= 0) role[property] = k;
  }
  return role;
}

/// Whether the element has each of the numbers `names`, all of types that are `wanted`.
bool hasNumbers(const PlyElement& element, const std::array<std::string_view, 3>& names, bool (*wanted)(PlyType))
{
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
    const Index property = element.find(name);
    return property >= 0 && !element.properties[property].isList() && wanted(element.properties[property].type);
  });
}

NormalUpdate PlySource::normals(const Positions& positions) const
{
  NormalUpdate none{{}, std::vector<bool>(positions.rows(), false), {}};
  if (!hasNumbers(vertex(), kNormals, [](PlyType) { return true; })) return none;
  if (!hasNumbers(vertex(), kNormals, [](PlyType type) { return !isInteger(type); })) {
    none.notes.emplace_back("normals kept from before: nx, ny, nz are of a whole type");
    return none;
  }
  return updateNormals(rest_.faces, cornerVertices(rest_.faces), positions.rows(), rest_.positions, positions);
}

bool PlySource::promoteHeader(SpliceWriter& writer) const
{
  bool isPromoted = false;
  const std::vector<int> coordinate = roles(vertex(), kCoordinates);
  for (std::size_t p = 0; p < coordinate.size(); ++p) {
    const PlyProperty& property = vertex().properties[p];
    if (coordinate[p] < 0 || property.type == PlyType::kDouble) continue;
    writer.replace(property.typeWord, "double");
    isPromoted = true;
  }
  return isPromoted;
}

bool PlySource::needsReplacing(PlyType type, double before, double after) const
{
  const bool isPromoted = header_.encoding != PlyEncoding::kText && type != PlyType::kDouble;
  return isPromoted || !hasSameBits(before, after);
}

void PlySource::spliceVertices(SpliceWriter& writer, const Positions& positions, const NormalUpdate& update) const
{
  PlyScanner scanner(bytes_, {}, header_.encoding, vertices_);
  const std::vector<int> coordinate = roles(vertex(), kCoordinates);
  const std::vector<int> normal = roles(vertex(), kNormals);
  for (Index v = 0; v < positions.rows(); ++v) {
    scanner.beginRow(vertex(), v);
    for (std::size_t p = 0; p < coordinate.size(); ++p) {
      const PlyProperty& property = vertex().properties[p];
      if (property.isList()) {
        scanner.skip(property.type, scanner.integer(*property.countType, property.name));
        continue;
      }
      const std::string_view place = scanner.value(property).place;
      const int k = coordinate[p];
      if (k >= 0 && needsReplacing(property.type, rest_.positions(v, k), positions(v, k)))
        writer.replace(place, plyBytes(positions(v, k), PlyType::kDouble, header_.encoding));
      else if (normal[p] >= 0 && update.isNew[v])
        writer.replace(place, plyBytes(update.normals(v, normal[p]), property.type, header_.encoding));
    }
    scanner.endRow();
  }
}

Serialized PlySource::withPositions(const Positions& positions) const
{
  assert(positions.rows() == rest_.vertexCount());
  const std::vector<bool> moved = movedVertices(rest_.positions, positions);
  if (std::find(moved.begin(), moved.end(), true) == moved.end()) return {bytes_, {}};
  NormalUpdate update = normals(positions);
  SpliceWriter writer(bytes_);
  if (promoteHeader(writer)) update.notes.emplace_back("coordinates promoted to double");
  spliceVertices(writer, positions, update);
  return {std::move(writer).finish(), std::move(update.notes)};
}

/// "vertex properties nx, ny, nz"; empty where `element` has no properties but those in `known`.
std::string otherProperties(const PlyElement& element, const std::vector<std::string_view>& known)
{
  std::string names;
  for (const PlyProperty& property : element.properties)
    if (std::find(known.begin(), known.end(), property.name) == known.end())
      names += (names.empty() ? "" : ", ") + property.name;
  return names.empty() ? names : fmt::format("{} properties {}", element.name, names);
}

std::vector<std::string> PlySource::extras() const
{
  std::vector<std::string> names;
  for (const PlyElement& element : header_.elements) {
    std::string name;
    if (element.name == "vertex")
      name = otherProperties(element, {"x", "y", "z"});
    else if (&element == header_.surface())
      name = otherProperties(element, {"vertex_indices", "vertex_index"});
    else
      name = fmt::format("element {}", element.name);
    if (!name.empty()) names.push_back(std::move(name));
  }
  return names;
}

/// The source of a document whose file is `bytes` and whose mesh is `rest`; its rows of vertices begin at `vertices`.
/// The header is read from `bytes` again.
std::shared_ptr<const MeshSource> makePlySource(std::string bytes, PlyPlace vertices, Mesh rest)
{
  return std::make_shared<const PlySource>(std::move(bytes), vertices, std::move(rest));
}

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

class BodyReader {
 public:
  BodyReader(const PlyHeader& header, const MeshElements& elements, PlyScanner scanner)
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
  PlyScanner scanner_;
  Mesh mesh_;
  PlyPlace vertices_;
  std::vector<Index> polygon_;  // the face or the strip that is being read
  Index strip_ = 0;
};

void BodyReader::read()
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

void BodyReader::readVertices()
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

void BodyReader::readSurface()
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

void BodyReader::readCorners(const PlyProperty& property, Index face)
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

void BodyReader::readStrips(const PlyProperty& property)
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
void BodyReader::addStrip()
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

void BodyReader::requireVertex(Index vertex, std::string_view owner, Index id) const
{
  if (vertex >= 0 && vertex < elements_.vertex->count) return;
  scanner_.fail(fmt::format("vertex {} of {} {} does not exist: the file has {} vertices, numbered from 0", vertex,
                            owner, id, elements_.vertex->count));
}

void BodyReader::skipElement(const PlyElement& element)
{
  if (element.properties.empty()) return;  // rows of nothing, however many
  for (Index row = 0; row < element.count; ++row) {
    scanner_.beginRow(element, row);
    for (const PlyProperty& property : element.properties) skipProperty(property);
    scanner_.endRow();
  }
}

void BodyReader::skipProperty(const PlyProperty& property)
{
  const Index values = property.isList() ? listSize(property) : 1;
  scanner_.skip(property.type, values);
}

Index BodyReader::listSize(const PlyProperty& property)
{
  const Index size = scanner_.integer(*property.countType, "the length of a list");
  if (size < 0) scanner_.fail(fmt::format("the length {} of a list is negative: correct it", size));
  return size;
}

std::size_t BodyReader::leastRowBytes(const PlyElement& element) const
{
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += scanner_.leastBytes(property.countType.value_or(property.type));
  if (&element == elements_.surface && !element.hasStrips())
    bytes += 3 * scanner_.leastBytes(element.properties[elements_.corners].type);
  return bytes;
}

void BodyReader::expectRoom(const PlyElement& element, std::size_t rowBytes) const
{
  if (rowBytes == 0 || static_cast<std::size_t>(element.count) <= scanner_.room() / rowBytes) return;
  scanner_.fail(
      fmt::format("the header promises {} rows of element {}, of {} bytes at least, but only {} bytes follow: "
                  "the file is truncated, or the count is wrong",
                  element.count, quotedToken(element.name), rowBytes, scanner_.remaining()));
}

}  // namespace

MeshDocument readPly(std::string bytes, const std::string& file)
{
  const PlyHeader header = parsePlyHeader(bytes, file);
  const MeshElements elements = meshElements(header, file);
  BodyReader reader(header, elements, PlyScanner(bytes, file, header.encoding, {header.bodyOffset, header.bodyLine}));
  reader.read();
  const PlyPlace vertices = reader.vertices();
  Mesh mesh = std::move(reader).takeMesh();
  if (mesh.faces.isEmpty()) failWithoutFaces(file, elements.surface->line);
  return {mesh, makePlySource(std::move(bytes), vertices, mesh)};
}

}  // namespace holdfast
