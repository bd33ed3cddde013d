#pragma once
/// XML PolyData (.vtp). A reader of our own over VTK's XML parser, because VTK's reader believes types, counts, offsets
/// and sizes that a file states, and ends the program where they are wrong.

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

struct VtpContents {
  vtkSmartPointer<vtkPolyData> polyData;
  std::set<std::string> lostKeys;  ///< names of the information keys that are not in `polyData`
  /// Names that arrays got in `polyData` because they had none, or that of another one.
  std::set<std::string> newNames;
  std::string compressor;  ///< as the file names it; empty where it compresses nothing
};

/// The surface in the bytes of a file, with all its arrays; pieces are joined. Throws `InputError` about `file`, with
/// the line, where it is no PolyData, has steps of time, or where an array is not what its place needs. What arrays
/// take of the file, and texts of elements, come to no more than the file: memory is bounded by what compression
/// explains. O(bytes, uncompressed).
[[nodiscard]] VtpContents readVtp(const std::string& bytes, const std::string& file);

/// An element with all that is in it. References to entities are resolved.
struct XmlElement {
  std::string name;
  std::size_t place = 0;  ///< byte of the text where it begins
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  ///< between its tags, without that of its children
  std::vector<XmlElement> children;

  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// The first child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
};

/// The root of `text`. Throws `InputError` about `file` for what is no XML, nested more than 32 deep, or made longer by
/// entities. O(text).
[[nodiscard]] XmlElement parseXml(const std::string& text, const std::string& file);

/// How a file stores the numbers of its arrays (VTK File Formats, "XML File Formats").
struct VtpEncoding {
  std::endian order = std::endian::little;
  bool hasLongHeaders = false;  ///< sizes take eight bytes, not four
  vtkSmartPointer<vtkDataCompressor> compressor;
  std::string_view appended;  ///< what follows the underscore of AppendedData
  bool isAppendedBase64 = false;
  /// Bytes of the file that arrays may still take. Arrays may begin in one place, and then take what is there twice.
  std::shared_ptr<std::uint64_t> bytesLeft;
};

/// A fault of an element; the caller knows its place.
class VtpFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An attribute as a whole number from 0, or `absent` where it is not there. Throws `VtpFault`.
[[nodiscard]] Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent);

/// The array of a DataArray or Array element. `tuples`: how many its place needs, where that is known. Throws
/// `VtpFault` where its type is not known, its data are no whole tuples, or the file has no bytes left for it. Takes no
/// memory for what the file only claims to hold. O(bytes of the array).
[[nodiscard]] vtkSmartPointer<vtkAbstractArray> readVtpArray(const XmlElement& element, const VtpEncoding& encoding,
                                                             std::optional<Index> tuples);

}  // namespace holdfast
