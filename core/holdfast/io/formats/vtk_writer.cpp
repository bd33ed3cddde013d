#include <cassert>

#include <fmt/format.h>

#include <holdfast/io/field_file.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/formats/vtp_array.h>
#include <holdfast/mesh/stated_places.h>

namespace holdfast {
namespace {

std::span<const double> numbersOf(const Positions& positions)
{
  return {positions.data(), static_cast<std::size_t>(positions.size())};
}

template <class Numbers>
std::string intBytes(const Numbers& numbers, std::endian order)
{
  std::string bytes;
  for (const Index number : numbers) bytes += toBytes(static_cast<std::int32_t>(number), order);
  return bytes;
}

/// The values of faces that are written.
Field ofSurface(const Field& field, const Polygons& faces)
{
  assert(std::ssize(field.values) == field.components * faces.size());
  Field result{field.name, field.components, {}};
  for (Index f = 0; f < faces.size(); ++f)
    if (faces.isSurface(f))
      result.values.insert(result.values.end(), field.values.begin() + f * field.components,
                           field.values.begin() + (f + 1) * field.components);
  return result;
}

/// Writes the XML of a file, and the blocks behind it, side by side.
class VtpWriter {
 public:
  VtpWriter() { encoding_.hasLongHeaders = true; }

  [[nodiscard]] std::string write(const Positions& positions, const Polygons& faces, std::span<const Field> pointFields,
                                  std::span<const Field> faceFields)
  {
    xml_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
        positions.rows(), faces.size());
    addFields("PointData", pointFields);
    addFields("CellData", faceFields);
    inElement("Points", [&] { addDoubles("Points", 3, numbersOf(positions)); });
    inElement("Polys", [&] {
      addArray("Int32", "connectivity", 1, intBytes(faces.corners(), encoding_.order));
      addArray("Int32", "offsets", 1, intBytes(faces.starts().subspan(1), encoding_.order));
    });
    return xml_ + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + blocks_ +
           "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  template <class Content>
  void inElement(std::string_view name, const Content& content)
  {
    xml_ += fmt::format("<{}>\n", name);
    content();
    xml_ += fmt::format("</{}>\n", name);
  }

  void addFields(std::string_view name, std::span<const Field> fields)
  {
    inElement(name, [&] {
      for (const Field& field : fields) addDoubles(field.name, field.components, field.values);
    });
  }

  void addDoubles(std::string_view name, Index components, std::span<const double> values)
  {
    addArray("Float64", name, components, toVtpData(values, VtpReal::Float64, encoding_.order));
  }

  void addArray(std::string_view type, std::string_view name, Index components, const std::string& data)
  {
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        toXml(name), components, blocks_.size());
    blocks_ += toVtpBlock(data, false, encoding_, 0);
  }

  VtpEncoding encoding_;
  std::string xml_;
  std::string blocks_;
};

}  // namespace

Serialized writeVtp(const Mesh& rest, const Positions& positions)
{
  return {VtpWriter().write(positions, rest.faces, {}, {}), {}};
}

Serialized writeVtk(const Mesh& rest, const Positions& positions)
{
  const Polygons& faces = rest.faces;
  std::string bytes = fmt::format("# vtk DataFile Version 3.0\nHoldfast\nBINARY\nDATASET POLYDATA\nPOINTS {} double\n",
                                  positions.rows());
  bytes += toVtpData(numbersOf(positions), VtpReal::Float64, std::endian::big);
  bytes += fmt::format("\nPOLYGONS {} {}\n", faces.size(), faces.size() + faces.cornerCount());
  for (Index f = 0; f < faces.size(); ++f)
    bytes +=
        toBytes(static_cast<std::int32_t>(faces[f].size()), std::endian::big) + intBytes(faces[f], std::endian::big);
  return {bytes + '\n', {}};
}

Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                       std::span<const Field> faceFields)
{
  for ([[maybe_unused]] const Field& field : pointFields)
    assert(std::ssize(field.values) == field.components * mesh.vertexCount());
  std::vector<Field> ofFaces;
  for (const Field& field : faceFields) ofFaces.push_back(ofSurface(field, mesh.faces));
  return {VtpWriter().write(positions, surfaceOf(mesh).faces, pointFields, ofFaces), {}};
}

}  // namespace holdfast
