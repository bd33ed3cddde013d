#pragma once
/// \file
/// The numbers of an array in an XML file of VTK: as text, in base64 or as raw bytes, compressed or not.

#include <stdexcept>
#include <string>
#include <string_view>

#include <vtkSmartPointer.h>

#include <holdfast/base/types.h>
#include <holdfast/io/text/byte_order.h>
#include <holdfast/widgets/files/xml_element.h>

class vtkAbstractArray;
class vtkDataCompressor;

namespace holdfast {

/// How a file stores the numbers of its arrays (VTK File Formats, "XML File Formats").
struct VtpEncoding {
  ByteOrder order = ByteOrder::kLittle;
  bool hasLongHeaders = false;  ///< sizes take eight bytes, not four
  vtkSmartPointer<vtkDataCompressor> compressor;
  std::string_view appended;  ///< what follows the underscore of AppendedData
  bool isAppendedBase64 = false;
};

/// What is wrong with an element; the caller knows its place.
class VtpFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An attribute as a whole number from 0, or `absent` where it is not there. Throws `VtpFault`.
[[nodiscard]] Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent);

/// The array of a DataArray or Array element, of numbers or of texts, with its name and those of its components.
/// Throws `VtpFault` where the type is not known, the data are not whole, or are no whole number of tuples. Takes no
/// memory for what the file only claims to hold. O(bytes of the array).
[[nodiscard]] vtkSmartPointer<vtkAbstractArray> readVtpArray(const XmlElement& element, const VtpEncoding& encoding);

}  // namespace holdfast
