#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/vtp_source.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

constexpr const char* kAppendedName = "AppendedData";

/// Throws an `InputError` with the line of `element`.
[[noreturn]] void failAt(const XmlElement& element, const VtpFile& file, const std::string& name,
                         const std::string& reason, const std::string& part)
{
  const std::string_view before = std::string_view(file.bytes).substr(0, element.place);
  throw InputError({name, std::ranges::count(before, '\n') + 1, part}, reason + "; the file is damaged, write it anew");
}

/// Reads what the first tag of a file says of its blocks.
class VtpOpener {
 public:
  VtpOpener(std::string bytes, const std::string& name) : name_(name) { file_.bytes = std::move(bytes); }

  [[nodiscard]] VtpFile open()
  {
    refuseWideText(file_.bytes, name_);
    file_.root = parseXml(file_.bytes, name_, kAppendedName);
    if (file_.root.name != "VTKFile" || file_.root.attribute("type") != "PolyData")
      throw InputError({name_, 0, ""}, "this is no PolyData file of VTK's; extract the surface of its data first");
    const auto order = known("byte_order", {"LittleEndian", "BigEndian"});
    const auto header = known("header_type", {"UInt32", "UInt64"});
    file_.encoding = {order == "BigEndian" ? std::endian::big : std::endian::little, header == "UInt64", compressor()};
    findAppendedData();
    return std::move(file_);
  }

 private:
  /// The value of an attribute of the root: one of `values`, of which the first is the default.
  [[nodiscard]] std::string_view known(const char* attribute, const std::array<std::string_view, 2>& values) const
  {
    const std::string_view value = file_.root.attribute(attribute).value_or(values[0]);
    if (std::ranges::find(values, value) == values.end()) failUnknown(attribute, value);
    return value;
  }

  [[nodiscard]] const BlockCompressor* compressor() const
  {
    const std::string_view name = file_.root.attribute("compressor").value_or("");
    const BlockCompressor* const compressor = findCompressor(name);
    if (compressor == nullptr && !name.empty()) failUnknown("compressor", name);
    return compressor;
  }

  [[noreturn]] void failUnknown(const char* attribute, std::string_view value) const
  {
    failAt(file_.root, file_, name_, fmt::format("{} '{}' is not known", attribute, value), file_.root.name);
  }

  void findAppendedData()
  {
    const XmlElement* const appended = file_.root.child(kAppendedName);
    const std::size_t end = appended == nullptr ? file_.bytes.size() : appended->place + appended->tagSize;
    file_.appendedPlace = std::min(file_.bytes.find('_', end), file_.bytes.size() - 1) + 1;
    file_.isAppendedBase64 = appended != nullptr && appended->attribute("encoding") == "base64";
  }

  VtpFile file_;
  const std::string& name_;
};

/// The cells of one kind in a piece.
struct VtpCells {
  std::string_view element;
  std::string_view cell;
  Index leastCorners;
};

constexpr VtpCells kVerts{"Verts", "vertex cell", 1};
constexpr VtpCells kLines{"Lines", "line", 2};
constexpr VtpCells kStrips{"Strips", "strip", 3};
constexpr VtpCells kPolys{"Polys", "polygon", 3};

/// Cells of one kind: cell k has the corners from `ends[k - 1]`, or 0, to before `ends[k]`.
struct CellCorners {
  std::vector<Index> ends;
  std::vector<Index> corners;

  [[nodiscard]] Index size() const { return std::ssize(ends); }
  [[nodiscard]] Index begin(Index k) const { return k == 0 ? 0 : ends[k - 1]; }
  [[nodiscard]] std::span<const Index> operator[](Index k) const
  {
    return std::span(corners).subspan(begin(k), ends[k] - begin(k));
  }
};

class VtpReader {
 public:
  VtpReader(VtpFile file, const std::string& name) : file_(std::move(file)), name_(name), arrays_(file_) {}

  [[nodiscard]] MeshDocument read()
  {
    const XmlElement* const surface = file_.root.child("PolyData");
    if (surface == nullptr) fail(file_.root, "there is no PolyData in it");
    if (surface->attribute("TimeValues"))
      throw InputError({name_, 0, ""}, "it holds several steps of time; write one of them to a file of its own");
    for (const XmlElement& child : surface->children)
      if (child.name == "Piece" && !isEmptyPiece(child)) readPiece(child);
    static_cast<void>(readArrays(*surface, "FieldData", std::nullopt));
    Mesh mesh{Eigen::Map<const Positions>(coordinates_.data(), std::ssize(coordinates_) / 3, 3), surfaceOfPieces()};
    if (std::ssize(labels_.vertices) == mesh.vertexCount()) mesh.labels.vertices = std::move(labels_.vertices);
    if (std::ssize(labels_.faces) == mesh.faces.size()) mesh.labels.faces = std::move(labels_.faces);
    return {std::move(mesh), makeVtpSource(std::move(file_), std::move(pieces_), std::move(notesOfMotion_))};
  }

 private:
  [[nodiscard]] bool isEmptyPiece(const XmlElement& piece) const
  {
    return std::ranges::all_of(std::array<std::string_view, 5>{"Points", "Verts", "Lines", "Strips", "Polys"},
                               [&](std::string_view kind) { return count(piece, kind) == 0; });
  }

  void readPiece(const XmlElement& element)
  {
    VtpPiece piece;
    piece.firstPoint = std::ssize(coordinates_) / 3;
    piece.pointCount = count(element, "Points");
    if (piece.pointCount > 0) piece.points = &readPoints(element, piece.pointCount);
    piece.firstPolygon = readCells(element, kVerts).size() + readCells(element, kLines).size();
    piece.firstFace = faces_.size();
    const CellCorners polygons = readCells(element, kPolys);
    const CellCorners strips = readCells(element, kStrips);
    piece.polygonCount = polygons.size();
    addPolygons(element, polygons, piece);
    addStrips(element, strips, piece);
    const std::vector<Index> ofPoints = readArrays(element, "PointData", piece.pointCount);
    const Index cellCount = piece.firstPolygon + polygons.size() + strips.size();
    const std::vector<Index> ofCells = readArrays(element, "CellData", cellCount);
    std::ranges::copy(ofPoints, std::back_inserter(labels_.vertices));
    if (!ofCells.empty())
      std::ranges::copy(std::span(ofCells).subspan(piece.firstPolygon, polygons.size()),
                        std::back_inserter(labels_.faces));
    piece.pointNormals = storedNormals(element.child("PointData"));
    piece.cellNormals = storedNormals(element.child("CellData"));
    pieces_.push_back(piece);
  }

  [[nodiscard]] const XmlElement& readPoints(const XmlElement& piece, Index number)
  {
    const XmlElement* const points = piece.child("Points");
    if (points == nullptr || points->children.size() != 1) fail(piece, "its Points must hold one array");
    const XmlElement& element = points->children[0];
    const VtpArray array = readArray(element, number);
    if (!array.isNumbers() || array.components != 3) fail(element, "points must have three coordinates each");
    std::ranges::copy(array.doubles(), std::back_inserter(coordinates_));
    if (array.type->name != "Float64") hasNarrowPoints_ = true;
    return element;
  }

  [[nodiscard]] CellCorners readCells(const XmlElement& piece, const VtpCells& kind)
  {
    const Index number = count(piece, kind.element);
    if (number == 0) return {};
    const XmlElement* const element = piece.child(kind.element);
    if (element == nullptr) fail(piece, fmt::format("there are no {}", kind.element));
    CellCorners cells{readIds(*element, "offsets"), readIds(*element, "connectivity")};
    if (cells.size() != number) fail(*element, fmt::format("{} offsets for {} cells", cells.size(), number));
    if (cells.ends.back() != std::ssize(cells.corners))
      fail(*element,
           fmt::format("the last offset is {}, and there are {} corners", cells.ends.back(), cells.corners.size()));
    requireSoundEnds(*element, cells, kind);
    return cells;
  }

  void requireSoundEnds(const XmlElement& element, const CellCorners& cells, const VtpCells& kind) const
  {
    for (Index k = 0; k < cells.size(); ++k)
      if (cells.ends[k] < cells.begin(k) + kind.leastCorners || cells.ends[k] > std::ssize(cells.corners))
        failAt(element, file_, name_,
               fmt::format("it goes from corner {} to before corner {} of {}, and needs at least {}", cells.begin(k),
                           cells.ends[k], cells.corners.size(), kind.leastCorners),
               fmt::format("{} {}", kind.cell, k));
  }

  [[nodiscard]] std::vector<Index> readIds(const XmlElement& cells, std::string_view name)
  {
    const auto found =
        std::ranges::find_if(cells.children, [&](const XmlElement& child) { return child.attribute("Name") == name; });
    if (found == cells.children.end()) fail(cells, fmt::format("there is no array \"{}\"", name));
    const VtpArray array = readArray(*found, std::nullopt);
    if (!array.isNumbers() || !array.type->isWhole || array.components != 1)
      fail(*found, fmt::format("\"{}\" must be whole numbers", name));
    return array.indices();
  }

  [[nodiscard]] Index count(const XmlElement& piece, std::string_view kind) const
  {
    try {
      return wholeAttribute(piece, fmt::format("NumberOf{}", kind), 0);
    } catch (const VtpFault& fault) {
      fail(piece, fault.what());
    }
  }

  [[nodiscard]] VtpArray readArray(const XmlElement& element, std::optional<Index> tuples)
  {
    try {
      return arrays_.read(element, tuples);
    } catch (const VtpFault& fault) {
      const auto name = element.attribute("Name");
      fail(element, name ? fmt::format("\"{}\": {}", *name, fault.what()) : fault.what());
    }
  }

  /// Each array must be whole. It is kept as it stands in the file. Returns the labels: the whole numbers of the array
  /// that the file declares as global ids. Returns nothing where it declares none.
  [[nodiscard]] std::vector<Index> readArrays(const XmlElement& parent, const char* name, std::optional<Index> tuples)
  {
    const XmlElement* const element = parent.child(name);
    if (element == nullptr) return {};
    const auto ids = element->attribute("GlobalIds");
    std::vector<Index> labels;
    for (const XmlElement& child : element->children) {
      if (child.name != "DataArray" && child.name != "Array") fail(child, "this is no array");
      const VtpArray array = readArray(child, tuples);
      if (ids && child.attribute("Name") == ids && array.isNumbers() && array.type->isWhole && array.components == 1)
        labels = array.indices();
    }
    return labels;
  }

  void requirePoints(const XmlElement& element, const CellCorners& cells, Index cell, const VtpCells& kind,
                     const VtpPiece& piece) const
  {
    for (const Index corner : cells[cell])
      if (corner < 0 || corner >= piece.pointCount)
        failAt(*element.child(kind.element), file_, name_,
               fmt::format("it refers to point {}, but the points are numbered from 0 to {}", corner,
                           piece.pointCount - 1),
               fmt::format("{} {}", kind.cell, cell));
  }

  void addPolygons(const XmlElement& element, const CellCorners& cells, const VtpPiece& piece)
  {
    for (Index k = 0; k < cells.size(); ++k) {
      requirePoints(element, cells, k, kPolys, piece);
      std::vector<Index> corners(cells[k].begin(), cells[k].end());
      for (Index& corner : corners) corner += piece.firstPoint;
      faces_.add(corners);
    }
  }

  /// Every second triangle of a strip is in reverse order, so that all have the same side up. Those that name a point
  /// twice only continue it.
  void addStrip(std::span<const Index> strip, Index firstPoint)
  {
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
      const Index a = firstPoint + strip[k];
      const Index b = firstPoint + strip[k + 1 + k % 2];
      const Index c = firstPoint + strip[k + 2 - k % 2];
      if (a != b && b != c && c != a) triangles_.add({a, b, c});
    }
  }

  /// The array that holds normals: the one that the file declares as such, or the one that is called so.
  [[nodiscard]] const XmlElement* storedNormals(const XmlElement* fields)
  {
    if (fields == nullptr) return nullptr;
    const std::string_view name = fields->attribute("Normals").value_or("Normals");
    for (const XmlElement& array : fields->children) {
      if (array.attribute("Name") != name || array.attribute("NumberOfComponents") != "3") continue;
      const auto type = array.attribute("type");
      if (type == "Float32" || type == "Float64") return &array;
      notesOfMotion_.push_back(fmt::format("normals kept from before: \"{}\" is of the type {}", name, *type));
    }
    return nullptr;
  }

  void addStrips(const XmlElement& element, const CellCorners& cells, const VtpPiece& piece)
  {
    for (Index k = 0; k < cells.size(); ++k) {
      requirePoints(element, cells, k, kStrips, piece);
      addStrip(cells[k], piece.firstPoint);
      hasStrips_ = true;
    }
  }

  /// The polygons of all pieces, and behind them the triangles of all strips.
  [[nodiscard]] Polygons surfaceOfPieces()
  {
    if (faces_.isEmpty() && !hasStrips_)
      throw InputError({name_, 0, ""},
                       "there are no polygons, and only surfaces made of polygons can be deformed; give a file with "
                       "Polys or Strips");
    for (Index f = 0; f < triangles_.size(); ++f) faces_.add(triangles_[f]);
    if (faces_.isEmpty())
      throw InputError({name_, 0, ""}, "no strip has a triangle of three different points; give a file with Polys");
    if (hasNarrowPoints_)
      notesOfMotion_.emplace_back("coordinates that were in single precision are written as doubles");
    return std::move(faces_);
  }

  [[noreturn]] void fail(const XmlElement& element, const std::string& reason) const
  {
    failAt(element, file_, name_, reason, element.name);
  }

  VtpFile file_;
  const std::string& name_;
  VtpArrayReader arrays_;
  std::vector<VtpPiece> pieces_;
  std::vector<double> coordinates_;
  Polygons faces_;
  Polygons triangles_;  // of strips
  Labels labels_;       // of points and of polygons, where all pieces have them
  bool hasStrips_ = false;
  bool hasNarrowPoints_ = false;
  std::vector<std::string> notesOfMotion_;
};

}  // namespace

void checkVtpHead(std::string_view head, const std::string& file)
{
  refuseWideText(head, file);
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '<')
    throw InputError({file, 1, ""}, "this is no whole XML file: it does not begin with '<'; get it again");
}

MeshDocument readVtp(std::string bytes, const std::string& file)
{
  return VtpReader(VtpOpener(std::move(bytes), file).open(), file).read();
}

}  // namespace holdfast
