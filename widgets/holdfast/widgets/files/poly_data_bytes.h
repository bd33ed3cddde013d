#pragma once
/// \file
/// VTK's surfaces as the contents of files. Doubles keep every bit.

#include <string>

class vtkPolyData;

namespace holdfast {

/// An XML file (.vtp), arrays as raw binary after the XML. The same bytes for the same data. Throws `OutputError`.
[[nodiscard]] std::string vtpBytes(vtkPolyData& polyData);

/// What a legacy file says besides its data.
struct LegacyHeader {
  std::string title;     ///< the second line, at most 255 characters
  int majorVersion = 5;  ///< programs older than VTK 9 read files before 5 only
};

/// A legacy file (.vtk). Always in the binary form: VTK writes text with 11 digits, and a double needs 17. Throws
/// `OutputError`.
[[nodiscard]] std::string legacyBytes(vtkPolyData& polyData, const LegacyHeader& header);

}  // namespace holdfast
