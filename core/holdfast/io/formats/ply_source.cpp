#include "holdfast/io/formats/ply_source.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include <holdfast/io/formats/splice_writer.h>
#include <holdfast/io/formats/stored_normals.h>
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
  template <class Scanner>
  void spliceVertices(SpliceWriter& writer, Scanner scanner, const Positions& positions,
                      const NormalUpdate& update) const;
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

bool hasProperties(const PlyElement& element, const std::array<std::string_view, 3>& names)
{
  for (const std::string_view name : names) {
    const Index property = element.find(name);
    if (property < 0 || element.properties[property].isList()) return false;
  }
  return true;
}

bool hasFloatProperties(const PlyElement& element, const std::array<std::string_view, 3>& names)
{
  if (!hasProperties(element, names)) return false;
  for (const std::string_view name : names)
    if (isInteger(element.properties[element.find(name)].type)) return false;
  return true;
}

NormalUpdate PlySource::normals(const Positions& positions) const
{
  NormalUpdate none{{}, std::vector<bool>(positions.rows(), false), {}};
  if (!hasProperties(vertex(), kNormals)) return none;
  if (!hasFloatProperties(vertex(), kNormals)) {
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

template <class Scanner>
void PlySource::spliceVertices(SpliceWriter& writer, Scanner scanner, const Positions& positions,
                               const NormalUpdate& update) const
{
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
  if (header_.encoding == PlyEncoding::kText)
    spliceVertices(writer, PlyTextScanner(bytes_, {}, vertices_), positions, update);
  else
    spliceVertices(writer, PlyBinaryScanner(bytes_, {}, vertices_, byteOrder(header_.encoding)), positions, update);
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

}  // namespace

std::shared_ptr<const MeshSource> makePlySource(std::string bytes, PlyPlace vertices, Mesh rest)
{
  return std::make_shared<const PlySource>(std::move(bytes), vertices, std::move(rest));
}

}  // namespace holdfast
