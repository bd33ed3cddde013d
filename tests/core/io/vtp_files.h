#pragma once
/// \file
/// VTP files as texts, made without any of the code under test.

#include <cstdint>
#include <string>
#include <vector>

namespace holdfast::test {

/// A triangle with more in its Piece and in the whole. Its Piece begins in line 2 or behind `inWhole`.
inline std::string vtpTriangle(const std::string& inPiece = "", const std::string& inWhole = "")
{
  return R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
)" + inWhole +
         R"(<Piece NumberOfPoints="3" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></Polys>
)" + inPiece +
         "</Piece></PolyData></VTKFile>\n";
}

inline std::string vtpPointData(const std::string& attributes, const std::string& values)
{
  return "<PointData><DataArray " + attributes + ">" + values + "</DataArray></PointData>\n";
}

/// `text` with the first `old` replaced.
inline std::string replaced(std::string text, const std::string& old, const std::string& by)
{
  return text.replace(text.find(old), old.size(), by);
}

/// 32 or 64 bits, the lowest byte first.
inline std::string vtpWord(std::uint64_t value, int bytes = 8)
{
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k));
  return text;
}

/// The file `text` with 64-bit sizes, `more` attributes of its root, and these appended data.
inline std::string withVtpAppended(const std::string& text, const std::string& data, const std::string& more = "",
                                   const std::string& encoding = "raw")
{
  return replaced(replaced(text, "<VTKFile ", "<VTKFile header_type=\"UInt64\" " + more + " "), "</VTKFile>",
                  "<AppendedData encoding=\"" + encoding + "\">_" + data + "</AppendedData></VTKFile>");
}

/// A triangle whose field data are arrays in appended data at these offsets.
inline std::string withVtpFields(const std::string& data, const std::vector<std::size_t>& offsets,
                                 const std::string& more = "", const std::string& encoding = "raw")
{
  std::string arrays;
  for (std::size_t k = 0; k < offsets.size(); ++k)
    arrays += "<DataArray type=\"UInt8\" Name=\"a" + std::to_string(k) + "\" format=\"appended\" offset=\"" +
              std::to_string(offsets[k]) + "\"/>";
  return withVtpAppended(vtpTriangle("", "<FieldData>" + arrays + "</FieldData>"), data, more, encoding);
}

}  // namespace holdfast::test
