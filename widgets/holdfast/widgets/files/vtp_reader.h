#pragma once
/// XML PolyData (.vtp). A reader of our own over VTK's XML parser, because VTK's reader believes types, counts, offsets
/// and sizes that a file states, and ends the program where they are wrong.

#include <set>
#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace holdfast {

struct VtpContents {
  vtkSmartPointer<vtkPolyData> polyData;
  std::set<std::string> lostKeys;  ///< names of the information keys that are not in `polyData`
};

/// The surface in the bytes of a file, with all its arrays; pieces are joined. Of information keys only those of the
/// range of an array are not lost, which VTK computes anew. Throws `InputError` about `file`, with
/// the line, where the file is not XML, not PolyData, has steps of time, or where an array is not what its place needs:
/// its type, its name, the count of its numbers, offsets that grow. O(bytes).
[[nodiscard]] VtpContents readVtp(const std::string& bytes, const std::string& file);

}  // namespace holdfast
