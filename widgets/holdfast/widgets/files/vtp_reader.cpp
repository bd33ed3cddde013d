#include "holdfast/widgets/files/vtp_reader.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>
#include <vtkZLibDataCompressor.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

constexpr std::string_view kAppendedTag = "<AppendedData";

/// VTK looks through all names for each array that it adds: this many take a second.
constexpr std::size_t kMostArrays = 10'000;

/// Where the XML of a file ends, and what follows it.
struct Parts {
  std::string markup;  ///< whole XML, without appended data
  std::string_view appended;
};

/// Where the tag of appended data begins, comments and sections of plain text aside.
std::size_t appendedTagOf(std::string_view bytes)
{
  constexpr std::array<std::array<std::string_view, 2>, 2> kAsides{{{"<!--", "-->"}, {"<![CDATA[", "]]>"}}};
  for (std::size_t place = bytes.find('<'); place != std::string_view::npos; place = bytes.find('<', place + 1)) {
    const std::string_view rest = bytes.substr(place);
    if (rest.starts_with(kAppendedTag)) return place;
    for (const auto& [begin, end] : kAsides)
      if (rest.starts_with(begin)) {
        place = bytes.find(end, place + begin.size());
        break;
      }
    if (place == std::string_view::npos) break;
  }
  return std::string_view::npos;
}

/// Appended data need not be XML: expat does not get them.
Parts partsOf(const std::string& bytes)
{
  const std::size_t tag = appendedTagOf(bytes);
  if (tag == std::string::npos) return {bytes, {}};
  const std::size_t end = std::min(bytes.find('>', tag), bytes.size() - 1) + 1;
  const std::size_t underscore = std::min(bytes.find('_', end), bytes.size() - 1);
  return {bytes.substr(0, end) + "</AppendedData></VTKFile>", std::string_view(bytes).substr(underscore + 1)};
}

/// Scalars="temperature" and the like. VTK passes over what cannot be.
void setActive(const XmlElement& element, vtkDataSetAttributes& fields)
{
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type) {
    const auto name = element.attribute(vtkDataSetAttributes::GetAttributeTypeAsString(type));
    if (name) fields.SetActiveAttribute(std::string(*name).c_str(), type);
  }
}

void addLostKeys(const XmlElement& element, std::set<std::string>& names)
{
  const std::string_view name = element.attribute("name").value_or("");
  if (element.name == "InformationKey" && name != "L2_NORM_RANGE" && name != "L2_NORM_FINITE_RANGE")
    names.emplace(name);
  for (const XmlElement& child : element.children) addLostKeys(child, names);
}

class VtpReader {
 public:
  VtpReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file), parts_(partsOf(bytes)) {}

  [[nodiscard]] VtpContents read()
  {
    const XmlElement root = parseXml(parts_.markup, file_);
    readEncoding(root);
    const XmlElement* const surface = root.child("PolyData");
    if (surface == nullptr) fail(root, "there is no PolyData in it");
    if (surface->attribute("TimeValues"))
      throw InputError({file_, 0, ""}, "it holds several steps of time; write one of them to a file of its own");
    auto polyData = joined(readPieces(*surface));
    readFields(*surface, "FieldData", std::nullopt, *polyData->GetFieldData());
    VtpContents contents{polyData, {}, newNames_, std::string(root.attribute("compressor").value_or(""))};
    addLostKeys(*surface, contents.lostKeys);
    return contents;
  }

 private:
  void readEncoding(const XmlElement& root)
  {
    if (root.name != "VTKFile" || root.attribute("type") != "PolyData")
      throw InputError({file_, 0, ""}, "this is no PolyData file of VTK's; extract the surface of its data first");
    const auto order = root.attribute("byte_order").value_or("LittleEndian");
    const auto header = root.attribute("header_type").value_or("UInt32");
    const auto compressor = root.attribute("compressor").value_or("");
    if (order != "LittleEndian" && order != "BigEndian") fail(root, fmt::format("byte_order '{}' is not known", order));
    if (header != "UInt32" && header != "UInt64") fail(root, fmt::format("header_type '{}' is not known", header));
    encoding_.order = order == "BigEndian" ? std::endian::big : std::endian::little;
    encoding_.hasLongHeaders = header == "UInt64";
    if (compressor == "vtkZLibDataCompressor")
      encoding_.compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
    else if (compressor == "vtkLZ4DataCompressor")
      encoding_.compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
    else if (compressor == "vtkLZMADataCompressor")
      encoding_.compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
    else if (!compressor.empty())
      fail(root, fmt::format("compressor '{}' is not known", compressor));
    encoding_.bytesLeft = std::make_shared<std::uint64_t>(bytes_.size());
    encoding_.appended = parts_.appended;
    if (const XmlElement* const appended = root.child("AppendedData"))
      encoding_.isAppendedBase64 = appended->attribute("encoding") == "base64";
  }

  /// Few at a time: a surface of VTK takes a hundred times what a small piece takes in the file.
  [[nodiscard]] std::vector<vtkSmartPointer<vtkPolyData>> readPieces(const XmlElement& surface)
  {
    constexpr std::size_t kMostPieces = 256;
    std::vector<vtkSmartPointer<vtkPolyData>> pieces;
    for (const XmlElement& child : surface.children) {
      if (child.name != "Piece" || isEmptyPiece(child)) continue;
      pieces.push_back(readPiece(child));
      if (pieces.size() == kMostPieces) pieces = {joined(pieces)};
    }
    return pieces;
  }

  [[nodiscard]] bool isEmptyPiece(const XmlElement& piece) const
  {
    return std::ranges::all_of(std::array{"Points", "Verts", "Lines", "Strips", "Polys"},
                               [&](const char* kind) { return count(piece, kind) == 0; });
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> readPiece(const XmlElement& piece)
  {
    auto polyData = vtkSmartPointer<vtkPolyData>::New();
    polyData->SetPoints(readPoints(piece));
    polyData->SetVerts(readCells(piece, "Verts"));
    polyData->SetLines(readCells(piece, "Lines"));
    polyData->SetStrips(readCells(piece, "Strips"));
    polyData->SetPolys(readCells(piece, "Polys"));
    requireSoundCells(*polyData, file_);
    readFields(piece, "PointData", polyData->GetNumberOfPoints(), *polyData->GetPointData());
    readFields(piece, "CellData", polyData->GetNumberOfCells(), *polyData->GetCellData());
    return polyData;
  }

  [[nodiscard]] vtkSmartPointer<vtkPoints> readPoints(const XmlElement& piece) const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    const Index number = count(piece, "Points");
    if (number == 0) return points;
    const XmlElement* const element = piece.child("Points");
    if (element == nullptr || element->children.size() != 1) fail(piece, "its Points must hold one array");
    const auto array = readArray(element->children[0], number);
    auto* const coordinates = vtkDataArray::SafeDownCast(array);
    if (coordinates == nullptr || coordinates->GetNumberOfComponents() != 3)
      fail(element->children[0], "points must have three coordinates each");
    points->SetData(coordinates);
    return points;
  }

  /// A file has the offset at which each cell ends; VTK also needs 0 before them.
  [[nodiscard]] vtkSmartPointer<vtkCellArray> readCells(const XmlElement& piece, const char* kind) const
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    const Index number = count(piece, kind);
    if (number == 0) return cells;
    const XmlElement* const element = piece.child(kind);
    if (element == nullptr) fail(piece, fmt::format("there are no {}", kind));
    const auto ends = readIds(*element, "offsets");
    const auto corners = readIds(*element, "connectivity");
    if (ends->GetNumberOfValues() != number)
      fail(*element, fmt::format("{} offsets for {} cells", ends->GetNumberOfValues(), number));
    if (ends->GetValue(number - 1) != corners->GetNumberOfValues())
      fail(*element, fmt::format("the last offset is {}, and there are {} corners", ends->GetValue(number - 1),
                                 corners->GetNumberOfValues()));
    vtkNew<vtkTypeInt64Array> offsets;
    offsets->SetNumberOfValues(number + 1);
    offsets->SetValue(0, 0);
    for (Index k = 0; k < number; ++k) offsets->SetValue(k + 1, ends->GetValue(k));
    cells->SetData(offsets, corners);
    return cells;
  }

  [[nodiscard]] vtkSmartPointer<vtkTypeInt64Array> readIds(const XmlElement& cells, std::string_view name) const
  {
    const auto found =
        std::ranges::find_if(cells.children, [&](const XmlElement& child) { return child.attribute("Name") == name; });
    if (found == cells.children.end()) fail(cells, fmt::format("there is no array \"{}\"", name));
    const auto array = readArray(*found, std::nullopt);
    auto* const numbers = vtkDataArray::SafeDownCast(array);
    if (numbers == nullptr || numbers->GetNumberOfComponents() != 1)
      fail(*found, fmt::format("\"{}\" must be whole numbers", name));
    auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
    ids->DeepCopy(numbers);
    return ids;
  }

  /// `tuples`: of each array; what the file says where that is not given. VTK knows arrays by their names: those
  /// without one, and those with that of another one, get one of their own.
  void readFields(const XmlElement& parent, const char* name, std::optional<Index> tuples, vtkFieldData& fields)
  {
    const XmlElement* const element = parent.child(name);
    if (element == nullptr) return;
    std::set<std::string> names;
    std::map<std::string, int> lastNumber;  // of those that have wanted a name
    for (const XmlElement& child : element->children) {
      if (child.name != "DataArray" && child.name != "Array") fail(child, "this is no array");
      if (names.size() == kMostArrays)
        throw InputError({file_, 0, name},
                         fmt::format("more than {} arrays are not read; leave some out", kMostArrays));
      const auto array = readArray(child, tuples);
      const std::string stated = array->GetName() == nullptr ? "" : array->GetName();
      const std::string wanted = stated.empty() ? "unnamed" : stated;
      std::string own = wanted;
      for (int& number = lastNumber[wanted]; !names.insert(own).second;)
        own = fmt::format("{} {}", wanted, ++number + 1);
      if (own != stated) newNames_.insert(own);
      array->SetName(own.c_str());
      fields.AddArray(array);
    }
    if (auto* const attributes = vtkDataSetAttributes::SafeDownCast(&fields)) setActive(*element, *attributes);
  }

  [[nodiscard]] vtkSmartPointer<vtkAbstractArray> readArray(const XmlElement& element,
                                                            std::optional<Index> tuples) const
  {
    try {
      auto array = readVtpArray(element, encoding_, tuples);
      const Index held = array->GetNumberOfTuples();
      const Index needed = tuples ? *tuples : wholeAttribute(element, "NumberOfTuples", held);
      if (held != needed) throw VtpFault(fmt::format("it has {} tuples where {} must be", held, needed));
      return array;
    } catch (const VtpFault& fault) {
      const auto name = element.attribute("Name");
      fail(element, name ? fmt::format("\"{}\": {}", *name, fault.what()) : fault.what());
    }
  }

  [[nodiscard]] Index count(const XmlElement& piece, const std::string& kind) const
  {
    try {
      return wholeAttribute(piece, "NumberOf" + kind, 0);
    } catch (const VtpFault& fault) {
      fail(piece, fault.what());
    }
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> joined(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces) const
  {
    if (pieces.empty()) return vtkSmartPointer<vtkPolyData>::New();
    if (pieces.size() == 1) return pieces.front();
    vtkNew<vtkAppendPolyData> append;
    for (const auto& piece : pieces) append->AddInputData(piece);
    append->Update();
    vtkPolyData* const whole = append->GetOutput();
    for (const auto& piece : pieces)
      if (piece->GetPointData()->GetNumberOfArrays() != whole->GetPointData()->GetNumberOfArrays() ||
          piece->GetCellData()->GetNumberOfArrays() != whole->GetCellData()->GetNumberOfArrays())
        throw InputError({file_, 0, ""}, "its pieces have different arrays; join them into one piece first");
    return whole;
  }

  [[noreturn]] void fail(const XmlElement& element, const std::string& reason) const
  {
    const std::string_view before = std::string_view(bytes_).substr(0, element.place);
    throw InputError({file_, std::count(before.begin(), before.end(), '\n') + 1, element.name},
                     reason + "; the file is damaged, write it anew");
  }

  const std::string& bytes_;
  const std::string& file_;
  Parts parts_;
  VtpEncoding encoding_;
  std::set<std::string> newNames_;
};

}  // namespace

VtpContents readVtp(const std::string& bytes, const std::string& file)
{
  const VtkErrorLog silent;
  return VtpReader(bytes, file).read();
}

}  // namespace holdfast
