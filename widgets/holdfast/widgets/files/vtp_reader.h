#pragma once
/// This reader reads XML PolyData (.vtp) by VTK's XML parser. VTK's own reader believes the types, counts, offsets and
/// sizes that a file states. Where they are wrong, it ends the program.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <vtkAbstractArray.h>
#include <vtkDataCompressor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <holdfast/base/types.h>
#include <holdfast/io/text/byte_order.h>

namespace holdfast {

/// The contents of a file, and what the reader had to change.
struct VtpContents {
  vtkSmartPointer<vtkPolyData> polyData;
  std::set<std::string> lostKeys;  ///< names of the information keys that are not in `polyData`
  /// The names that arrays got in `polyData` because they had none, or because another array had the same one.
  std::set<std::string> newNames;
  std::string compressor;  ///< the compressor that the file names; empty where nothing is compressed
};

/// Reads the surface in the bytes of a file, with all its arrays. Pieces are joined. Throws `InputError` about `file`,
/// with the line. It does so where the file is no PolyData or has steps of time. It also does where an array is not
/// what its place needs.
///
/// All arrays and texts of elements together take no more bytes than the file has. Memory is therefore bounded by what
/// compression explains. O(bytes, uncompressed).
///
///     const VtpContents contents = readVtp(bytes, "part.vtp");
///     for (const std::string& key : contents.lostKeys) std::cerr << "not kept: " << key << '\n';
///     mapper->SetInputData(contents.polyData);
[[nodiscard]] VtpContents readVtp(const std::string& bytes, const std::string& file);

/// An element of XML with all that is in it. References to entities are resolved.
struct XmlElement {
  std::string name;
  std::size_t place = 0;  ///< the byte of the text at which the element begins
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  ///< the text between its tags, without that of its children
  std::vector<XmlElement> children;

  /// Returns the value of the attribute of that name. There is none where the element lacks it.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// Returns the first child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
};

/// Parses `text` and returns its root. Throws `InputError` about `file` for a text that is no XML. It does the same
/// where elements are nested more than 32 deep, and where entities make the text longer. O(text).
[[nodiscard]] XmlElement parseXml(const std::string& text, const std::string& file);

/// The way in which a file stores the numbers of its arrays (VTK File Formats, "XML File Formats").
struct VtpEncoding {
  std::endian order = std::endian::little;
  bool hasLongHeaders = false;  ///< sizes take eight bytes each, not four
  vtkSmartPointer<vtkDataCompressor> compressor;
  std::string_view appended;  ///< all that follows the underscore of AppendedData
  bool isAppendedBase64 = false;
  /// The number of bytes of the file that arrays may still take. Two arrays may begin in one place. Each of them then
  /// takes the bytes there.
  std::shared_ptr<std::uint64_t> bytesLeft;
};

/// A fault of an element. The caller knows the place of the element and adds it.
class VtpFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns an attribute as a whole number, 0 or more. Where the element lacks it, returns `absent`. Throws `VtpFault`
/// for anything else.
[[nodiscard]] Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent);

/// Reads the array of a DataArray or Array element. `tuples` is the number that its place needs, where that is known.
/// Throws `VtpFault` where its type is not known or its data are no whole tuples. It also throws where the file has no
/// bytes left for the array. Bytes that the file only claims to hold take no memory. O(bytes of the array).
[[nodiscard]] vtkSmartPointer<vtkAbstractArray> readVtpArray(const XmlElement& element, const VtpEncoding& encoding,
                                                             std::optional<Index> tuples);

}  // namespace holdfast
