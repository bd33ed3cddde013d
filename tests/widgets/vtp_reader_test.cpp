#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt8Array.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkZLibDataCompressor.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtp_reader.h>

#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

std::string textOf(vtkAbstractArray* array)
{
  if (array == nullptr) return "none";
  std::ostringstream text;
  text << (array->GetName() == nullptr ? "" : array->GetName()) << ' ' << array->GetClassName() << ' '
       << array->GetNumberOfComponents();
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    text << ' ' << (array->GetComponentName(c) == nullptr ? "-" : array->GetComponentName(c));
  text.precision(17);
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k) text << ' ' << array->GetVariantValue(k).ToString();
  return text.str() + "\n";
}

std::string textOf(vtkFieldData& fields)
{
  std::string text;
  for (int k = 0; k < fields.GetNumberOfArrays(); ++k) text += textOf(fields.GetAbstractArray(k));
  if (auto* attributes = vtkDataSetAttributes::SafeDownCast(&fields))
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
      text += textOf(attributes->GetAbstractAttribute(type));
  return text;
}

std::string textOf(vtkCellArray& cells)
{
  std::string text;
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells.GetCellAtId(cell, count, ids);
    for (vtkIdType k = 0; k < count; ++k) text += std::to_string(ids[k]) + " ";
    text += "\n";
  }
  return text;
}

/// All that it holds.
std::string textOf(vtkPolyData& polyData)
{
  return textOf(polyData.GetPoints()->GetData()) + textOf(*polyData.GetVerts()) + textOf(*polyData.GetLines()) +
         textOf(*polyData.GetStrips()) + textOf(*polyData.GetPolys()) + textOf(*polyData.GetPointData()) +
         textOf(*polyData.GetCellData()) + textOf(*polyData.GetFieldData());
}

std::string readByVtk(const std::string& bytes)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  return textOf(*reader->GetOutput());
}

using Mode = std::tuple<int, int, int, int>;

/// Files that VTK's writer makes, in each of its ways: format, compressor, byte order, size of headers.
class VtpOfVtk : public testing::TestWithParam<Mode> {
 protected:
  static std::string written(vtkPolyData& polyData)
  {
    const auto [format, compressor, order, header] = GetParam();
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(&polyData);
    writer->SetDataMode(format == 3 ? vtkXMLWriter::Appended : format);
    writer->SetEncodeAppendedData(format == 3);
    writer->SetCompressorType(compressor);
    writer->SetByteOrder(order);
    writer->SetHeaderType(header);
    writer->SetBlockSize(64);  // several blocks
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
  }
};

INSTANTIATE_TEST_SUITE_P(
    AllWays, VtpOfVtk,
    testing::Combine(testing::Values(vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended, 3),
                     testing::Values(vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA),
                     testing::Values(vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian),
                     testing::Values(vtkXMLWriter::UInt32, vtkXMLWriter::UInt64)));

TEST_P(VtpOfVtk, AreReadAsByVtk)
{
  const auto polyData = test::richPolyData();
  polyData->GetPointData()->GetVectors()->SetComponentName(1, "across");
  vtkNew<vtkTypeUInt8Array> bytes;
  bytes->SetName("bytes");
  for (int k = 0; k < 6; ++k) bytes->InsertNextValue(static_cast<unsigned char>(50 * k));
  polyData->GetPointData()->AddArray(bytes);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfValues(5);
  ids->FillValue(1L << 40);
  polyData->GetCellData()->SetGlobalIds(ids);
  const std::string file = written(*polyData);
  EXPECT_EQ(textOf(*readVtp(file, "rich.vtp").polyData), readByVtk(file));
}

/// A triangle with more in its Piece and in the whole.
std::string triangle(const std::string& inPiece = "", const std::string& inWhole = "")
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

std::string pointData(const std::string& attributes, const std::string& values)
{
  return "<PointData><DataArray " + attributes + ">" + values + "</DataArray></PointData>\n";
}

std::string faultOf(const std::string& bytes)
{
  try {
    (void)readVtp(bytes, "f.vtp");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(VtpReader, ReadsWhatItsTestsBuildOn)
{
  EXPECT_EQ(faultOf(triangle(pointData(R"(type="Int8" Name="a" format="ascii")", "1 -2 3"))), "no fault");
}

TEST(VtpReader, NamesTypesThatAreNotKnown)
{
  const std::string whole =
      "<FieldData><DataArray Name=\"a\" NumberOfTuples=\"1\" format=\"ascii\">1</DataArray></FieldData>";
  EXPECT_THAT(faultOf(triangle("", whole)), HasSubstr("f.vtp:2: DataArray: \"a\": its type is ''"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Float63" Name="a" format="ascii")", "1 2 3"))),
              HasSubstr("f.vtp:6: DataArray: \"a\": its type is 'Float63'"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Float64" Name="a" format="text")", "1 2 3"))),
              HasSubstr("its format is 'text'"));
}

TEST(VtpReader, NamesTextsThatAreNumbers)
{
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="String" Name="a" format="ascii")", "1 2 3"))),
              HasSubstr("its last text has no end"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="String" Name="a" format="ascii")", "1.5 2.5 3.5"))),
              HasSubstr("'1.5' is no number that it can hold"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="String" Name="a" format="ascii")", "65 0 66 0"))),
              HasSubstr("it has 2 tuples where 3 must be"));
}

TEST(VtpReader, ArraysWithoutANameGetOne)
{
  EXPECT_THAT(readVtp(triangle(pointData(R"(type="Int8" format="ascii")", "1 2 3")), "f.vtp").newNames,
              testing::ElementsAre("unnamed"));
  const std::string texts = R"(<FieldData><Array type="String" format="ascii">65 0</Array></FieldData>)";
  EXPECT_THAT(readVtp(triangle("", texts), "f.vtp").newNames, testing::ElementsAre("unnamed"));
}

/// 32 or 64 bits, the lowest byte first.
std::string word(std::uint64_t value, int bytes = 8)
{
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k));
  return text;
}

/// A triangle whose field data are arrays in appended data, in 64-bit words, at these offsets.
std::string withAppended(const std::string& data, const std::vector<std::size_t>& offsets, const std::string& more = "",
                         const std::string& encoding = "raw")
{
  std::string arrays;
  for (std::size_t k = 0; k < offsets.size(); ++k)
    arrays += "<DataArray type=\"UInt8\" Name=\"a" + std::to_string(k) + "\" format=\"appended\" offset=\"" +
              std::to_string(offsets[k]) + "\"/>";
  std::string text = triangle("", "<FieldData>" + arrays + "</FieldData>");
  text.replace(text.find("<VTKFile "), 9, "<VTKFile header_type=\"UInt64\" " + more + " ");
  return text.replace(text.find("</VTKFile>"), 10,
                      "<AppendedData encoding=\"" + encoding + "\">_" + data + "</AppendedData></VTKFile>");
}

constexpr const char* kByZlib = "compressor=\"vtkZLibDataCompressor\"";

/// Blocks of zeros as they are stored: how many, their size and that of the last one, the sizes when compressed.
std::string compressedZeros(std::size_t blocks, std::size_t size)
{
  const std::string zeros(size, '\0');
  vtkNew<vtkZLibDataCompressor> compressor;
  std::string block(compressor->GetMaximumCompressionSpace(size), '\0');
  block.resize(compressor->Compress(reinterpret_cast<const unsigned char*>(zeros.data()), size,
                                    reinterpret_cast<unsigned char*>(block.data()), block.size()));
  std::string data = word(blocks) + word(size) + word(0);
  for (std::size_t k = 0; k < blocks; ++k) data += word(block.size());
  for (std::size_t k = 0; k < blocks; ++k) data += block;
  return data;
}

TEST(VtpReader, WhatCompressionExplainsOnceIsRead)
{
  const auto contents = readVtp(withAppended(compressedZeros(3, 1 << 20), {0}, kByZlib), "f.vtp");
  EXPECT_EQ(contents.polyData->GetFieldData()->GetArray("a0")->GetNumberOfValues(), 3 << 20);
}

TEST(VtpReader, ArraysThatShareOneBlockTakeNoMoreThanTheFileExplains)
{
  EXPECT_THAT(faultOf(withAppended(compressedZeros(2, 1 << 20), std::vector<std::size_t>(1000, 0), kByZlib)),
              HasSubstr("share their data"));
  EXPECT_THAT(faultOf(withAppended(word(1 << 20) + std::string(1 << 20, 'x'), std::vector<std::size_t>(200, 0))),
              HasSubstr("share their data"));
  EXPECT_EQ(faultOf(withAppended(word(3) + "abc", {0, 0, 0})), "no fault") << "they fit into the file";
}

TEST(VtpReader, EntitiesMakeNoTextLongerThanTheFile)
{
  std::string text = triangle(pointData(R"(type="Int8" Name="a")", "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;"));
  text = "<!DOCTYPE x [<!ENTITY b \"" + std::string(2000, ' ') + "\">]>" + text;
  EXPECT_THAT(faultOf(text), HasSubstr("entities make it longer"));
}

TEST(VtpReader, EmptyPiecesTakeNoMemoryAndSmallOnesAreJoined)
{
  std::string pieces;
  for (int k = 0; k < 20'000; ++k) pieces += "<Piece NumberOfPoints=\"0\"/>";
  EXPECT_EQ(readVtp(triangle("", pieces), "f.vtp").polyData->GetNumberOfPoints(), 3);
  std::string many = triangle();
  const std::size_t begin = many.find("<Piece");
  const std::string piece = many.substr(begin, many.find("</Piece>") + 8 - begin);
  for (int k = 0; k < 999; ++k) many.insert(begin, piece);
  const auto joined = readVtp(many, "f.vtp").polyData;
  EXPECT_EQ(joined->GetNumberOfPoints(), 3000);
  EXPECT_EQ(joined->GetNumberOfPolys(), 1000);
}

TEST(VtpReader, MoreArraysThanProgramsWriteAreRefused)
{
  std::string arrays;
  for (int k = 0; k < 10'001; ++k) arrays += R"(<DataArray type="Int8" Name="a" format="ascii">1</DataArray>)";
  EXPECT_THAT(faultOf(triangle("", "<FieldData>" + arrays + "</FieldData>")), HasSubstr("more than 10000 arrays"));
}

TEST(VtpReader, BlocksClaimNoMoreThanCompressionCanHold)
{
  const std::string block = word(1) + word(std::uint64_t{1} << 50) + word(0) + word(4) + "abcd";
  EXPECT_THAT(faultOf(withAppended(block, {0}, kByZlib)), HasSubstr("claims too large a size"));
}

TEST(VtpReader, AnOffsetOnePastTheEndIsNone)
{
  const std::string data = word(2) + "ab";
  const std::size_t end = data.size() + std::string("</AppendedData></VTKFile>\n").size();
  EXPECT_THAT(faultOf(withAppended(data, {end})), HasSubstr("would begin where the file has none"));
  EXPECT_THAT(faultOf(withAppended(data, {end - 1})), HasSubstr("cut short"));
}

TEST(VtpReader, EmptyArraysHaveFewComponents)
{
  const auto empty = [](const std::string& components) {
    return "<FieldData><DataArray type=\"Int8\" Name=\"a\" NumberOfComponents=\"" + components +
           "\" format=\"ascii\"></DataArray></FieldData>";
  };
  EXPECT_EQ(faultOf(triangle("", empty("1"))), "no fault");
  EXPECT_EQ(faultOf(triangle("", empty("9"))), "no fault") << "tensors";
  EXPECT_THAT(faultOf(triangle("", empty("10"))), HasSubstr("its 0 numbers are not whole tuples of 10"));
  EXPECT_THAT(faultOf(triangle("", empty("0"))), HasSubstr("not whole tuples of 0"));
}

TEST(VtpReader, SizesThatWrapAreCutShort)
{
  const std::uint64_t wrapping = (std::uint64_t{1} << 61);  // so many words of 8 bytes are none
  EXPECT_THAT(faultOf(withAppended(word(wrapping) + word(8) + word(0) + word(4), {0}, kByZlib)),
              HasSubstr("cut short"));
  EXPECT_THAT(faultOf(withAppended(word(wrapping - 3) + word(8) + word(0), {0}, kByZlib)), HasSubstr("cut short"));
  EXPECT_THAT(faultOf(withAppended(word(~std::uint64_t{0} - 7) + word(1), {0})), HasSubstr("cut short"));
  const std::string twoBlocks = word(2) + word(8) + word(0) + word(~std::uint64_t{0}) + word(3) + "ab";
  EXPECT_THAT(faultOf(withAppended(twoBlocks, {0}, kByZlib)), HasSubstr("cut short")) << "their sum is 2";
}

TEST(VtpReader, BitsAreReadAsTextAndPacked)
{
  const auto bitsOf = [](const std::string& bytes) {
    const VtpContents contents = readVtp(bytes, "f.vtp");
    vtkDataArray* const array = contents.polyData->GetPointData()->GetArray("a");
    EXPECT_EQ(array->GetDataType(), VTK_BIT);
    std::string bits;
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k) bits += array->GetComponent(k, 0) != 0 ? '1' : '0';
    return bits;
  };
  EXPECT_EQ(bitsOf(triangle(pointData(R"(type="Bit" Name="a" format="ascii")", "1 0 1"))), "101");
  // One byte, 0b01100000, after its size.
  EXPECT_EQ(bitsOf(triangle(pointData(R"(type="Bit" Name="a" format="binary")", "AQAAAGA="))), "011");
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Bit" Name="a" format="binary")", "AgAAAGBg"))), HasSubstr("3 bits"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Bit" Name="a" format="ascii")", "1 0"))), HasSubstr("2 tuples"));
}

TEST(VtpReader, SeesWhatCommentsAndReferencesHide)
{
  const std::string hidden = pointData(R"(type="Float64" Name="a" NumberOfComponents="99999999" format="ascii")", "1");
  EXPECT_THAT(faultOf(triangle("<!-- it's a quote -->\n" + hidden)), HasSubstr("not whole tuples of 99999999"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Int8" Name="a" format="&#98;inary")", "////////"))),
              HasSubstr("its data are cut short"));
}

TEST(VtpReader, NamesNumbersThatDoNotFitTheirType)
{
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Int8" Name="a" format="ascii")", "1 2 300"))), HasSubstr("'300'"));
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="UInt8" Name="a" format="ascii")", "1 -1 3"))), HasSubstr("'-1'"));
}

TEST(VtpReader, NamesElementsThatAreNestedTooDeep)
{
  std::string deep;
  for (int k = 0; k < 500000; ++k) deep += "<a>";
  EXPECT_THAT(faultOf(deep), HasSubstr("nested too deep"));
}

TEST(VtpReader, NamesStepsOfTime)
{
  std::string steps = triangle();
  steps.replace(steps.find("<PolyData>"), 10, "<PolyData TimeValues=\"0 1\">");
  EXPECT_THAT(faultOf(steps), HasSubstr("several steps of time"));
}

TEST(VtpReader, TellsWhichInformationKeysAreLost)
{
  const std::string keys = R"(1 2 3<InformationKey name="L2_NORM_RANGE" location="vtkDataArray" length="2"/>
<InformationKey name="UNITS_LABEL" location="vtkDataArray">K</InformationKey>)";
  const VtpContents contents = readVtp(triangle(pointData(R"(type="Int8" Name="a" format="ascii")", keys)), "f.vtp");
  EXPECT_THAT(contents.lostKeys, testing::ElementsAre("UNITS_LABEL"));
}

TEST(VtpReader, JoinsPieces)
{
  std::string two = triangle(pointData(R"(type="Int8" Name="a" format="ascii")", "1 2 3"));
  const std::size_t begin = two.find("<Piece");
  const std::size_t end = two.find("</Piece>") + 8;
  two.insert(end, two.substr(begin, end - begin));
  EXPECT_EQ(textOf(*readVtp(two, "two.vtp").polyData), readByVtk(two));
  EXPECT_EQ(readVtp(two, "two.vtp").polyData->GetNumberOfPoints(), 6);
  two.replace(two.rfind("Name=\"a\""), 8, "Name=\"b\"");
  EXPECT_THAT(faultOf(two), HasSubstr("pieces have different arrays"));
}

}  // namespace
}  // namespace holdfast
