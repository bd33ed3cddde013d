#pragma once
/// An array of a VTP file is an element of its XML: numbers of one type, several of which may form a tuple.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/io/formats/vtp_block.h>
#include <holdfast/io/formats/xml_tree.h>
#include <holdfast/numbers/types.h>

namespace holdfast {

/// A VTP file is its bytes, the tree of its XML, and the way in which it stores blocks.
struct VtpFile {
  std::string bytes;
  XmlElement root;
  VtpEncoding encoding;
  std::size_t appendedPlace = 0;  ///< the byte behind the underscore of AppendedData
  bool isAppendedBase64 = false;

  [[nodiscard]] std::string_view appended() const { return std::string_view(bytes).substr(appendedPlace); }
};

/// A type of numbers has a name in files.
struct VtpType {
  std::string_view name;
  std::size_t size = 0;  ///< bytes of a number
  bool isWhole = false;
  std::string (*dataOfText)(std::string_view text) = nullptr;
  /// These two convert data. They are null for bits and texts.
  std::vector<double> (*doubles)(std::string_view data) = nullptr;
  std::vector<Index> (*indices)(std::string_view data) = nullptr;
};

/// An array holds what its element says, as data of one type.
struct VtpArray {
  const VtpType* type = nullptr;
  Index components = 1;  ///< of a tuple
  Index values = 0;      ///< how many there are: numbers, bits or texts
  std::string data;      ///< in the byte order of this machine

  [[nodiscard]] Index tuples() const { return values / components; }
  [[nodiscard]] bool isNumbers() const { return type->doubles != nullptr; }
  [[nodiscard]] std::vector<double> doubles() const { return type->doubles(data); }
  [[nodiscard]] std::vector<Index> indices() const { return type->indices(data); }
};

/// Returns an attribute as a whole number, 0 or more. Where the element lacks it, returns `absent`. Throws `VtpFault`
/// for anything else.
[[nodiscard]] Index wholeAttribute(const XmlElement& element, std::string_view name, Index absent);

/// Returns the format that an array states: "ascii", "binary" or "appended". The first is the default.
[[nodiscard]] std::string_view formatOf(const XmlElement& element);

/// Returns the block of an array in appended data. Throws `VtpFault` where the file has none there.
[[nodiscard]] VtpBlock appendedBlock(const XmlElement& element, const VtpFile& file);

/// A reader reads arrays of one file. All arrays together take no more of its bytes than there are. Memory is therefore
/// bounded by what compression explains, also where several arrays name one block.
class VtpArrayReader {
 public:
  /// `file` outlives this.
  explicit VtpArrayReader(const VtpFile& file) : file_(file), bytesLeft_(file.bytes.size()) {}

  /// Reads the array of a DataArray or Array element. `tuples` is the number that its place needs, where that is known.
  /// Throws `VtpFault` where its type is not known, its data are not as many whole tuples, or the file has no bytes
  /// left for it. O(bytes of the array).
  [[nodiscard]] VtpArray read(const XmlElement& element, std::optional<Index> tuples);

 private:
  [[nodiscard]] std::string dataOf(const XmlElement& element, const VtpType& type);
  [[nodiscard]] std::string storedData(const XmlElement& element, std::string_view format);
  [[nodiscard]] std::string taken(const VtpBlock& block);

  const VtpFile& file_;
  std::uint64_t bytesLeft_;
};

/// Coordinates and normals of a file are written as one of these types.
enum class VtpReal { Float32, Float64 };

/// Returns `values` as data in this byte order.
[[nodiscard]] std::string toVtpData(std::span<const double> values, VtpReal type, std::endian order);

}  // namespace holdfast
