#include "support/mesh_examples.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>

namespace holdfast::test {
namespace {

// In templates, '@' stands for a coordinate and '#' for the type of coordinates.

constexpr const char* kObj = R"(# made by hand
mtllib plate.mtl
o plate
v @ @ @
v @ @ @ 1.0
v	@  @ @   0.25 0.5 1
v @ @ @ # a remark
vt 0 0
vt 1.0 0.50
vn 0 0 1
v @ @ \
  @
vn 0 0 1

g square
usemtl steel
s 1
f 1/1/1 2/2/1 3/1/1 4/2/1
g triangle
f -4//2 5//-1 \
  -3//2
l 1 2 3
p 5
)";

constexpr const char* kObjPlain = "v @ @ @\nv @ @ @\nv @ @ @\nv @ @ @\nv @ @ @\nf 1 2 3 4\nf 2 5 3";

constexpr const char* kOff = "OFF\n# counts\n5 2 0\n\n@ @ @\n@ @ @ # one\n@ @ @\n@ @ @\n@ @ @\n4 0 1 2 3\n3 1 4 2\n";

constexpr const char* kOffColors =
    "COFF 5 2\n@ @ @ 255 0 0 255\n@ @ @ 255 0 0\n@ @ @ 0.5 0.5 0.5 1\n@ @ @ 1 1 1\n@ @ @ 9 9 9 9\n"
    "4 0 1 2 3 255 128 0\n3  1 4 2  7\n# end\n";

constexpr const char* kOffNormals =
    "NOFF\n5 2 7\n@ @ @ 0 0 1\n@ @ @ 0 0 1\n@ @ @ 0 0 1\n@ @ @ 0 0 1\n@ @ @ 0 0 1\n4 0 1 2 3 0.1 0.2 0.3 1\n3 1 4 2\n";

constexpr const char* kOffAll =
    "STCNOFF\n5 2 0\n@ @ @ 0 0 1 9 8 7 0 1\n@ @ @ 0 0 1 9 8 7 6 0 1\n@ @ @ 0 0 1 9 8 7 0 1\n@ @ @ 0 0 1 9 8 7 0 1\n"
    "@ @ @ 0 0 1 9 8 7 0 1\n4 0 1 2 3\n3 1 4 2\n";

constexpr const char* kOffColorFirst =
    "NCOFF\n5 2 0\n@ @ @ 9 8 7 6 0 0 1\n@ @ @ 9 8 7 0 0 1\n@ @ @ 9 8 7 6 0 0 1\n@ @ @ 9 8 7 6 0 0 1\n"
    "@ @ @ 9 8 7 6 0 0 1\n4 0 1 2 3\n3 1 4 2\n";

constexpr const char* kPlyText = R"(ply
format ascii 1.0
comment element vertex 3
obj_info of no importance
element vertex 5
property uchar red
property # x
property # y
property # z
property list uchar int neighbours
property float nx
property float ny
property float nz
element material 1
property list uint float shine
element face 2
property uchar quality
property list uchar int vertex_indices
end_header
10 @ @ @ 2 3 4 0 0 1
20 @ @ @ 0 0 0 1
30 @  @	@ 1 7 0 0 1
40 @ @ @ 0 0 0 1
50 @ @ @ 0 0 0 1
3 0.10 0.20 0.30
7 4 0 1 2 3
8 3 1 4 2
)";

constexpr const char* kPlyStripsText = R"(ply
format ascii 1.0
element vertex 5
property # x
property # y
property # z
property float nx
property float ny
property float nz
element tristrips 2
property list int int vertex_indices
end_header
@ @ @ 0 0 1
@ @ @ 0 0 1
@ @ @ 0 0 1
@ @ @ 0 0 1
@ @ @ 0 0 1
5 0 1 3 2 -1
6 -1 1 4 2 2 -1
)";

constexpr const char* kStlText = R"(solid left  side
 facet normal 0 0 1
  outer loop
   vertex @ @ @
   vertex @ @ @
   vertex @ @ @
  endloop
 endfacet
endsolid left  side

SOLID
facet normal 0 0 1 outer loop
vertex @ @ @
vertex @ @ @
vertex @ @ @
endloop endfacet
ENDSOLID
)";

constexpr const char* kVtpText = R"(<?xml version="1.0"?>
<!-- as a program wrote it -->
<VTKFile type='PolyData' version="0.1" byte_order = "LittleEndian">
  <PolyData>
    <FieldData><DataArray type="String" Name="author" NumberOfTuples="1" format="ascii">65 0</DataArray></FieldData>
    <Piece NumberOfPoints="5" NumberOfVerts="1" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="2">
      <Points>
        <DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
          <InformationKey name="kept" location="here"/>
          @ @ @   @ @ @
          @	@ @
          @ @ @ @ @ @
        </DataArray>
      </Points>
      <PointData Normals="n">
        <DataArray type="Float32" Name="n" NumberOfComponents="3">0 0 1 0 0 1 0 0 1.0 0 0 1 0 0 1</DataArray>
        <DataArray type="Int8" Name="label" format="ascii">1 2 3 4 5</DataArray>
      </PointData>
      <CellData><DataArray type="Bit" Name="chosen" format="ascii">1 0 1</DataArray></CellData>
      <Verts><DataArray type="Int32" Name="connectivity">4</DataArray><DataArray type="Int32" Name="offsets">1</DataArray></Verts>
      <Polys>
        <DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3  1 4 2</DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">4 7</DataArray>
      </Polys>
    </Piece>
  </PolyData>
</VTKFile>
)";

std::string spelled(double value, Spelling spelling)
{
  std::array<char, 64> text{};
  if (spelling == Spelling::AsWritten)
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%+.4f", value))};
}

std::string filled(const std::string& pattern, const Positions& positions, Spelling spelling)
{
  std::string text;
  Index next = 0;
  for (const char c : pattern) {
    if (c == '@') {
      text += spelled(positions(next / 3, next % 3), spelling);
      ++next;
    } else if (c == '#' && pattern.starts_with("ply")) {
      text += spelling == Spelling::AsRead ? "float" : "double";
    } else {
      text += c;
    }
  }
  return text;
}

std::string withCarriageReturns(const std::string& text)
{
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

enum class Order { kLittle, kBig };

template <class Number>
std::string raw(Number value, Order order)
{
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  std::string text(bytes.begin(), bytes.end());
  return order == Order::kLittle ? text : std::string(text.rbegin(), text.rend());
}

/// Like the text example, of another order of elements, and with both kinds of numbers beside the coordinates.
std::string binaryPly(const Positions& positions, Spelling spelling, Order order, const std::string& restType)
{
  const std::string type = spelling == Spelling::AsRead ? restType : "double";
  std::string bytes = std::string("ply\nformat binary_") + (order == Order::kLittle ? "little" : "big") +
                      "_endian 1.0\ncomment kept as it is\nelement face 2\nproperty list int ushort vertex_index\n"
                      "property double area\nelement vertex 5\nproperty short tag\nproperty " +
                      type + " x\nproperty " + type + " y\nproperty list uint8 float32 weights\nproperty " + type +
                      " z\nproperty double nx\nproperty float ny\nproperty float32 nz\nelement nothing 7\n"
                      "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for (const auto& face : std::vector<std::vector<std::uint16_t>>{{0, 1, 2, 3}, {1, 4, 2}}) {
    bytes += raw(static_cast<std::int32_t>(face.size()), order);
    for (const std::uint16_t corner : face) bytes += raw(corner, order);
    bytes += raw(0.1, order);
  }
  const auto coordinate = [&](double value) {
    if (type == "double") return raw(value, order);
    if (type == "int") return raw(static_cast<std::int32_t>(value), order);
    return raw(static_cast<float>(value), order);
  };
  for (Index v = 0; v < positions.rows(); ++v) {
    bytes += raw(static_cast<std::int16_t>(-v), order) + coordinate(positions(v, 0)) + coordinate(positions(v, 1));
    bytes += static_cast<char>(v % 2);
    if (v % 2 == 1) bytes += raw(0.3F, order);
    bytes += coordinate(positions(v, 2)) + raw(0.0, order) + raw(0.0F, order) + raw(1.0F, order);
  }
  return bytes + raw(std::int32_t{0}, order) + raw(std::int32_t{1}, order);
}

/// Writes all strips in one row, as Stanford does in its scans.
std::string binaryPlyStrips(const Positions& positions, Spelling spelling, Order order)
{
  const bool isFloat = spelling == Spelling::AsRead;
  const std::string type = isFloat ? "float" : "double";
  std::string bytes = std::string("ply\nformat binary_") + (order == Order::kLittle ? "little" : "big") +
                      "_endian 1.0\nelement vertex 5\nproperty " + type + " x\nproperty " + type + " y\nproperty " +
                      type + " z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  for (Index v = 0; v < positions.rows(); ++v)
    for (Index k = 0; k < 3; ++k)
      bytes += isFloat ? raw(static_cast<float>(positions(v, k)), order) : raw(positions(v, k), order);
  const std::vector<std::int32_t> strips{0, 1, 3, 2, -1, 1, 4, 2, 2, -1};
  bytes += raw(static_cast<std::int32_t>(strips.size()), order);
  for (const std::int32_t vertex : strips) bytes += raw(vertex, order);
  return bytes;
}

/// Arrays before and behind the points in appended data; unused elements of no cells, whose offsets follow too.
std::string appendedVtp(const Positions& positions, Spelling spelling, Order order)
{
  const bool isFloat = spelling == Spelling::AsRead;
  std::string blocks;
  const auto offsetOf = [&](const std::string& data) {
    const std::size_t offset = blocks.size();
    blocks += raw(static_cast<std::uint32_t>(data.size()), order) + data;
    return "format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>";
  };
  std::string normals;
  std::string coordinates;
  for (Index v = 0; v < positions.rows(); ++v) {
    normals += raw(0.0, order) + raw(0.0, order) + raw(1.0, order);
    for (Index k = 0; k < 3; ++k)
      coordinates += isFloat ? raw(static_cast<float>(positions(v, k)), order) : raw(positions(v, k), order);
  }
  std::string corners;
  for (const std::int32_t corner : {0, 1, 2, 3, 1, 4, 2}) corners += raw(corner, order);
  std::string xml = std::string("<VTKFile type=\"PolyData\" byte_order=\"") +
                    (order == Order::kLittle ? "Little" : "Big") +
                    "Endian\"><PolyData><Piece NumberOfPoints=\"5\" NumberOfPolys=\"2\" NumberOfLines=\"0\">\n";
  xml += "<PointData><DataArray type=\"Float64\" Name=\"Normals\" NumberOfComponents=\"3\" " + offsetOf(normals);
  xml += std::string("</PointData>\n<Points><DataArray type=\"") + (isFloat ? "Float32" : "Float64") +
         "\" NumberOfComponents=\"3\" " + offsetOf(coordinates) + "</Points>\n";
  xml += "<Lines><DataArray type=\"Int32\" Name=\"connectivity\" " + offsetOf("") + "</Lines>\n";
  xml += "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" " + offsetOf(corners);
  xml += "<DataArray type=\"UInt8\" Name=\"offsets\" " + offsetOf("\4\7") + "</Polys>\n";
  return xml + "</Piece></PolyData><AppendedData encoding=\"raw\"> _" + blocks + "</AppendedData></VTKFile>";
}

std::string binaryStl(const Positions& positions)
{
  std::string bytes = "solid, and yet binary";
  bytes.resize(80, '\0');
  bytes += raw(std::uint32_t{2}, Order::kLittle);
  for (Index f = 0; f < 2; ++f) {
    bytes += raw(0.0F, Order::kLittle) + raw(0.0F, Order::kLittle) + raw(1.0F, Order::kLittle);
    for (Index k = 0; k < 9; ++k) bytes += raw(static_cast<float>(positions(3 * f + k / 3, k % 3)), Order::kLittle);
    bytes += raw(static_cast<std::uint16_t>(17 + f), Order::kLittle);
  }
  return bytes;
}

/// Square and triangle with shared vertices.
MeshExample shared(const std::string& name, const std::string& extension)
{
  MeshExample example{name, extension, false, true, Positions(5, 3), {}, {}};
  example.rest << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0;
  example.faces.add({0, 1, 2, 3});
  example.faces.add({1, 4, 2});
  return example;
}

/// Half the square and the triangle, each with vertices of its own.
MeshExample soup(const std::string& name)
{
  MeshExample example{name, ".stl", false, true, Positions(6, 3), {}, {}};
  example.rest << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 0, 2, 0.5, 0, 1, 1, 0;
  example.faces.add({0, 1, 2});
  example.faces.add({3, 4, 5});
  return example;
}

/// The same in two strips, the second of which ends in a triangle that names a vertex twice.
MeshExample strips(const std::string& name)
{
  MeshExample example = shared(name, ".ply");
  example.faces = {};
  example.faces.add({0, 1, 3});
  example.faces.add({3, 1, 2});
  example.faces.add({1, 4, 2});
  return example;
}

MeshExample text(MeshExample example, const std::string& pattern)
{
  example.isText = true;
  example.bytes = [pattern](const Positions& p, Spelling spelling) { return filled(pattern, p, spelling); };
  return example;
}

MeshExample windowsText(MeshExample example, const std::string& pattern)
{
  return text(std::move(example), withCarriageReturns(pattern));
}

MeshExample ply(const std::string& name, Order order, const std::string& restType)
{
  MeshExample example = shared(name, ".ply");
  if (restType == "int") example.rest(4, 1) = 1;
  example.bytes = [=](const Positions& p, Spelling spelling) { return binaryPly(p, spelling, order, restType); };
  return example;
}

MeshExample plyStrips(const std::string& name, Order order)
{
  MeshExample example = strips(name);
  example.bytes = [=](const Positions& p, Spelling spelling) { return binaryPlyStrips(p, spelling, order); };
  return example;
}

MeshExample vtp(const std::string& name, Order order)
{
  MeshExample example = shared(name, ".vtp");
  example.bytes = [=](const Positions& p, Spelling spelling) { return appendedVtp(p, spelling, order); };
  return example;
}

std::vector<MeshExample> makeExamples()
{
  std::vector<MeshExample> examples{
      text(shared("Obj", ".obj"), kObj),
      windowsText(shared("ObjWindows", ".obj"), kObj),
      text(shared("ObjPlain", ".obj"), kObjPlain),
      text(shared("ObjByteOrderMark", ".obj"), std::string("\xEF\xBB\xBF") + kObjPlain),
      text(shared("Off", ".off"), kOff),
      windowsText(shared("OffWindows", ".off"), kOff),
      text(shared("OffColors", ".off"), kOffColors),
      text(shared("OffNormals", ".off"), kOffNormals),
      text(shared("OffAll", ".off"), kOffAll),
      text(shared("OffColorFirst", ".off"), kOffColorFirst),
      text(shared("PlyText", ".ply"), kPlyText),
      windowsText(shared("PlyTextWindows", ".ply"), kPlyText),
      ply("PlyLittleFloat", Order::kLittle, "float"),
      ply("PlyLittleDouble", Order::kLittle, "double"),
      ply("PlyLittleInt", Order::kLittle, "int"),
      ply("PlyBigFloat", Order::kBig, "float"),
      ply("PlyBigDouble", Order::kBig, "double"),
      text(strips("PlyStripsText"), kPlyStripsText),
      windowsText(strips("PlyStripsTextWindows"), kPlyStripsText),
      plyStrips("PlyStripsLittle", Order::kLittle),
      plyStrips("PlyStripsBig", Order::kBig),
      text(shared("VtpText", ".vtp"), kVtpText),
      windowsText(shared("VtpTextWindows", ".vtp"), kVtpText),
      vtp("VtpLittle", Order::kLittle),
      vtp("VtpBig", Order::kBig),
      text(soup("StlText"), kStlText),
      windowsText(soup("StlTextWindows"), kStlText),
      soup("StlBinary"),
  };
  examples.back().bytes = [](const Positions& p, Spelling) { return binaryStl(p); };
  examples.back().holdsDoubles = false;
  return examples;
}

}  // namespace

const std::vector<MeshExample>& meshExamples()
{
  static const std::vector<MeshExample> kExamples = makeExamples();
  return kExamples;
}

std::ostream& operator<<(std::ostream& stream, const MeshExample& example)
{
  return stream << example.name;
}

}  // namespace holdfast::test
