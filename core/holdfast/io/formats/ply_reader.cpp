#include <algorithm>
#include <array>
#include <cstdint>

#include <holdfast/io/formats/ply_scanner.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

using ThreeNames = std::array<std::string_view, 3>;

constexpr ThreeNames kCoordinates{"x", "y", "z"};
constexpr ThreeNames kNormals{"nx", "ny", "nz"};

/// The places in `element` of the numbers `names`; nothing where one is missing or a list.
std::optional<std::array<Index, 3>> placesOf(const PlyElement& element, const ThreeNames& names)
{
  std::array<Index, 3> places{};
  for (std::size_t k = 0; k < 3; ++k) {
    places[k] = element.find(names[k]);
    if (places[k] < 0 || element.properties[places[k]].isList()) return std::nullopt;
  }
  return places;
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

class PlyReader {
 public:
  PlyReader(std::string bytes, const std::string& file)
      : bytes_(std::move(bytes)), file_(file), header_(parsePlyHeader(bytes_, file)), scanner_(bytes_, file, header_)
  {
    layout_.byteOrder = header_.byteOrder;
  }

  MeshDocument read()
  {
    findVertex();
    findSurface();
    for (const PlyElement& element : header_.elements) readElement(element);
    if (std::optional<std::string> remark = scanner_.endRemark()) layout_.remarks.push_back(*std::move(remark));
    remarkStrips();
    if (mesh_.faces.isEmpty()) failWithoutFaces();
    if (layout_.normalCount > 0)
      layout_.normalOfCorner.assign(mesh_.faces.corners().begin(), mesh_.faces.corners().end());
    return makeDocument(std::move(bytes_), std::move(layout_), std::move(mesh_));
  }

 private:
  /// `element`, which is called `name` and must be there.
  [[nodiscard]] const PlyElement* required(const PlyElement* element, std::string_view name) const
  {
    if (element == nullptr)
      throw InputError({file_, 0, {}}, fmt::format("the header has no element {}: export the file as a polygon mesh",
                                                   quotedToken(name)));
    return element;
  }

  [[noreturn]] void failWithoutFaces() const
  {
    throw InputError({file_, surface_->line, {}}, "the mesh has no faces: export it as a polygon mesh, not as points");
  }

  void findVertex()
  {
    vertex_ = required(header_.find("vertex"), "vertex");
    if (vertex_->count == 0) throw InputError({file_, vertex_->line, {}}, "the mesh has no vertices: export it again");
    for (const std::string_view name : kCoordinates)
      if (const Index p = vertex_->find(name); p < 0 || vertex_->properties[p].isList())
        throw InputError({file_, vertex_->line, {}},
                         fmt::format("the element 'vertex' has no number {}: it needs x, y and z", quotedToken(name)));
    const std::array<Index, 3> coordinates = *placesOf(*vertex_, kCoordinates);
    std::optional<std::array<Index, 3>> normals = placesOf(*vertex_, kNormals);
    const auto typeOf = [&](Index p) { return vertex_->properties[p].type; };
    if (normals && std::ranges::any_of(*normals, [&](Index p) { return isInteger(typeOf(p)); })) {
      layout_.notesOfMotion.emplace_back("normals kept from before: nx, ny, nz are of a whole type");
      normals.reset();
    }
    if (normals) layout_.normalCount = vertex_->count;
    numbers_.resize(vertex_->properties.size());
    for (Index k = 0; k < 3; ++k) {
      numbers_[coordinates[k]] = k;
      layout_.coordinateTypes[k] = typeOf(coordinates[k]);
      if (!normals) continue;
      numbers_[(*normals)[k]] = normalNumber(0, k);
      layout_.normalTypes[k] = typeOf((*normals)[k]);
    }
    for (std::size_t p = 0; p < numbers_.size(); ++p)
      if (numbers_[p] >= 0 && vertex_->properties[p].type != NumberType::Double)
        layout_.typeWords.push_back(vertex_->properties[p].typeOffset);
    if (!layout_.typeWords.empty()) layout_.notesOfMotion.emplace_back("coordinates promoted to double");
    const auto areTogether = [](const std::array<Index, 3>& p) { return p[1] == p[0] + 1 && p[2] == p[1] + 1; };
    layout_.areTogether = areTogether(coordinates) && (!normals || areTogether(*normals));
  }

  void findSurface()
  {
    surface_ = required(header_.surface(), "face");
    if (surface_->count == 0) failWithoutFaces();
    const Index usual = surface_->find("vertex_indices");
    corners_ = usual >= 0 ? usual : surface_->find("vertex_index");
    if (corners_ < 0 || !surface_->properties[corners_].isList() || !isInteger(surface_->properties[corners_].type))
      throw InputError({file_, surface_->line, {}},
                       fmt::format("the element {} needs the property 'list {} int vertex_indices' (or vertex_index) "
                                   "of a whole type: export the file as a polygon mesh",
                                   quotedToken(surface_->name), surface_->hasStrips() ? "int" : "uchar"));
  }

  void readElement(const PlyElement& element)
  {
    scanner_.expectRoom(element, leastRowBytes(element));
    if (&element == vertex_) {
      mesh_.positions.resize(element.count, 3);
      layout_.numbers.reserve(element.count);
    }
    if (&element == surface_)
      mesh_.faces.reserve(element.count,
                          std::min(3 * element.count, scanner_.mostValues(element.properties[corners_])));
    noteExtras(element);
    if (element.properties.empty()) return;  // rows of nothing, however many
    for (Index row = 0; row < element.count; ++row) {
      scanner_.beginRow(element, row);
      for (const PlyProperty& property : element.properties) readProperty(element, property, row);
      scanner_.endRow();
    }
  }

  void noteExtras(const PlyElement& element)
  {
    std::string name = fmt::format("element {}", element.name);
    if (&element == vertex_)
      name = otherProperties(element, {"x", "y", "z"});
    else if (&element == surface_)
      name = otherProperties(element, {"vertex_indices", "vertex_index"});
    if (!name.empty()) layout_.extras.push_back(std::move(name));
  }

  [[nodiscard]] std::size_t leastRowBytes(const PlyElement& element) const
  {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += scanner_.leastBytes(property.countType.value_or(property.type));
    return bytes;
  }

  void readProperty(const PlyElement& element, const PlyProperty& property, Index row)
  {
    if (&element == vertex_)
      if (const std::optional<Index> number = numbers_[&property - vertex_->properties.data()]) {
        const bool isNormal = *number < 0;
        const Index k = isNormal ? -1 - *number : *number;
        if (k == 0 || !layout_.areTogether)
          layout_.numbers.push_back({scanner_.offset(), isNormal ? normalNumber(row, k) : 3 * row + k});
        if (!isNormal) {
          mesh_.positions(row, k) = scanner_.number(property);
          return;
        }
      }
    const Index size = property.isList() ? listSize(property) : 1;
    if (&element != surface_ || &property != &element.properties[corners_])
      scanner_.skip(property.type, size);
    else if (element.hasStrips())
      readStrips(property, size);
    else
      readCorners(property, size, row);
  }

  Index listSize(const PlyProperty& property)
  {
    const Index size = scanner_.integer(*property.countType, "the length of a list");
    if (size < 0) scanner_.fail("the length {} of a list is negative: correct it", size);
    return size;
  }

  void readCorners(const PlyProperty& property, Index size, Index face)
  {
    polygon_.clear();
    for (Index k = 0; k < size; ++k) {
      const Index vertex = scanner_.integer(property.type, "a corner of the face");
      requireVertex(vertex, "face", face);
      polygon_.push_back(vertex);
    }
    mesh_.faces.add(polygon_);
  }

  void readStrips(const PlyProperty& property, Index size)
  {
    constexpr Index kEndOfStrip = -1;
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
  void addStrip()
  {
    if (polygon_.empty()) return;
    shortStrips_ += polygon_.size() < 3 ? 1 : 0;
    for (std::size_t k = 0; k + 2 < polygon_.size(); ++k) {
      const Index a = polygon_[k + k % 2];
      const Index b = polygon_[k + 1 - k % 2];
      const Index c = polygon_[k + 2];
      if (a != b && b != c && c != a) mesh_.faces.add({a, b, c});
    }
    polygon_.clear();
    ++strip_;
  }

  void remarkStrips()
  {
    if (shortStrips_ > 0)
      layout_.remarks.push_back(counted(shortStrips_, "strip") +
                                " of fewer than three corners; the file keeps what makes no triangle");
  }

  void requireVertex(Index vertex, std::string_view owner, Index id) const
  {
    if (vertex < 0 || vertex >= vertex_->count)
      scanner_.fail("vertex {} of {} {} does not exist: the file has {} vertices, numbered from 0", vertex, owner, id,
                    vertex_->count);
  }

  std::string bytes_;
  std::string file_;
  PlyHeader header_;
  PlyScanner scanner_;
  const PlyElement* vertex_ = nullptr;
  const PlyElement* surface_ = nullptr;
  std::vector<std::optional<Index>> numbers_;  // of the first vertex: what its properties are to `NumberPlace`
  Index corners_ = -1;                         // property of `surface_`
  Mesh mesh_;
  FileLayout layout_{".ply", {}, {}};
  std::vector<Index> polygon_;  // the face or the strip that is being read
  Index strip_ = 0;
  Index shortStrips_ = 0;
};

}  // namespace

void checkPlyHead(std::string_view head, const std::string& file)
{
  refuseWideText(head, file);
  requirePlyMagic(TextCursor(head, file));
}

MeshDocument readPly(std::string bytes, const std::string& file)
{
  refuseWideText(bytes, file);
  return PlyReader(std::move(bytes), file).read();
}

}  // namespace holdfast
