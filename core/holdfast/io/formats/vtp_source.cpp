#include "holdfast/io/formats/vtp_source.h"

#include <algorithm>
#include <cassert>
#include <set>

#include <fmt/format.h>

#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/formats/vtp_editor.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

/// What normals, of faces or of points, are normal to before and after a deformation, and whether they are out of date.
struct NormalSides {
  explicit NormalSides(Index count) : rest(Positions::Zero(count, 3)), moved(rest), isOutdated(count, 0) {}

  Positions rest;
  Positions moved;
  std::vector<char> isOutdated;
};

NormalSides sidesOfFaces(const Mesh& rest, const Positions& positions)
{
  NormalSides sides(rest.faces.size());
  for (Index f = 0; f < rest.faces.size(); ++f) {
    const auto corners = rest.faces[f];
    sides.rest.row(f) = areaVector(rest.positions, corners);
    sides.moved.row(f) = areaVector(positions, corners);
    sides.isOutdated[f] =
        std::ranges::any_of(corners, [&](Index v) { return !hasSameRow(rest.positions, positions, v); });
  }
  return sides;
}

NormalSides sidesOfPoints(const Mesh& rest, const NormalSides& faces)
{
  NormalSides sides(rest.vertexCount());
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f]) {
      sides.rest.row(v) += faces.rest.row(f);
      sides.moved.row(v) += faces.moved.row(f);
      if (faces.isOutdated[f] != 0) sides.isOutdated[v] = 1;
    }
  return sides;
}

class VtpSource final : public MeshSource {
 public:
  VtpSource(VtpFile file, std::vector<VtpPiece> pieces, std::vector<std::string> notesOfMotion)
      : file_(std::move(file)), pieces_(std::move(pieces)), notesOfMotion_(std::move(notesOfMotion))
  {
  }

  [[nodiscard]] std::string extension() const override { return ".vtp"; }

  [[nodiscard]] bool isText() const override
  {
    return std::ranges::all_of(
        pieces_, [](const VtpPiece& piece) { return piece.points == nullptr || formatOf(*piece.points) == "ascii"; });
  }

  [[nodiscard]] std::vector<std::string> extras() const override
  {
    std::vector<std::string> names;
    std::set<std::string> known;
    const auto add = [&](const XmlElement& parent, const char* fields) {
      const XmlElement* const element = parent.child(fields);
      if (element == nullptr) return;
      for (const XmlElement& array : element->children)
        if (std::string name = fmt::format("array \"{}\"", array.attribute("Name").value_or(""));
            known.insert(name).second)
          names.push_back(std::move(name));
    };
    const XmlElement& surface = *file_.root.child("PolyData");
    for (const char* const fields : {"PointData", "CellData"})
      for (const XmlElement& piece : surface.children) add(piece, fields);
    add(surface, "FieldData");
    return names;
  }

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions) const override
  {
    assert(positions.rows() == rest.vertexCount());
    Index v = 0;
    while (v < positions.rows() && hasSameRow(rest.positions, positions, v)) ++v;
    if (v == positions.rows()) return {file_.bytes, {}};
    try {
      VtpEditor editor(file_);
      for (const VtpPiece& piece : pieces_)
        if (piece.points != nullptr)
          editor.replace(*piece.points,
                         {positions.data() + 3 * piece.firstPoint, static_cast<std::size_t>(3 * piece.pointCount)},
                         VtpReal::Float64);
      std::vector<std::string> notes = refreshNormals(editor, rest, positions);
      notes.insert(notes.end(), notesOfMotion_.begin(), notesOfMotion_.end());
      return {editor.finish(), std::move(notes)};
    } catch (const VtpFault& fault) {
      throw OutputError(extension(), fault.what());
    }
  }

 private:
  [[nodiscard]] std::vector<std::string> refreshNormals(VtpEditor& editor, const Mesh& rest,
                                                        const Positions& positions) const
  {
    const bool hasPoints = std::ranges::any_of(pieces_, [](const VtpPiece& p) { return p.pointNormals != nullptr; });
    const bool hasCells = std::ranges::any_of(pieces_, [](const VtpPiece& p) { return p.cellNormals != nullptr; });
    if (!hasPoints && !hasCells) return {};
    const NormalSides faces = sidesOfFaces(rest, positions);
    const NormalSides points = hasPoints ? sidesOfPoints(rest, faces) : NormalSides(0);
    Index ofPoints = 0;
    Index ofFaces = 0;
    for (const VtpPiece& piece : pieces_) {
      if (piece.pointNormals != nullptr)
        ofPoints += refresh(editor, *piece.pointNormals, points, {piece.firstPoint, piece.pointCount, 0});
      // A strip has one normal for all its triangles, which says little: it stays.
      if (piece.cellNormals != nullptr)
        ofFaces +=
            refresh(editor, *piece.cellNormals, faces, {piece.firstFace, piece.polygonCount, piece.firstPolygon});
    }
    std::vector<std::string> notes;
    if (ofPoints > 0) notes.push_back(fmt::format("{} normals of points recomputed", ofPoints));
    if (ofFaces > 0) notes.push_back(fmt::format("{} normals of faces recomputed", ofFaces));
    return notes;
  }

  /// Which sides the normals of an array belong to, and the first tuple of these.
  struct Range {
    Index firstSide;
    Index count;
    Index firstTuple;
  };

  /// Returns how many normals changed. Each new one lies on the side of the stored one.
  [[nodiscard]] Index refresh(VtpEditor& editor, const XmlElement& array, const NormalSides& sides,
                              const Range& range) const
  {
    const auto outdated = std::span(sides.isOutdated).subspan(range.firstSide, range.count);
    const Index count = std::ranges::count(outdated, 1);
    if (count == 0) return 0;
    std::vector<double> normals = VtpArrayReader(file_).read(array, std::nullopt).doubles();
    for (Index k = 0; k < range.count; ++k) {
      if (outdated[k] == 0) continue;
      Eigen::Map<Vector3> normal(&normals[3 * (range.firstTuple + k)]);
      const double side = normal.dot(sides.rest.row(range.firstSide + k)) < 0 ? -1 : 1;
      normal = side * unitOrZero(sides.moved.row(range.firstSide + k));
    }
    editor.replace(array, normals, array.attribute("type") == "Float64" ? VtpReal::Float64 : VtpReal::Float32);
    return count;
  }

  VtpFile file_;
  std::vector<VtpPiece> pieces_;
  std::vector<std::string> notesOfMotion_;
};

}  // namespace

std::shared_ptr<const MeshSource> makeVtpSource(VtpFile file, std::vector<VtpPiece> pieces,
                                                std::vector<std::string> notesOfMotion)
{
  return std::make_shared<const VtpSource>(std::move(file), std::move(pieces), std::move(notesOfMotion));
}

}  // namespace holdfast
