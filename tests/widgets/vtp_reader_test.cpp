#include <sstream>
#include <string>
#include <tuple>

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

TEST(VtpReader, NamesArraysWithoutAName)
{
  EXPECT_THAT(faultOf(triangle(pointData(R"(type="Int8" format="ascii")", "1 2 3"))), HasSubstr("no Name"));
  EXPECT_THAT(faultOf(triangle("", R"(<FieldData><Array type="String" format="ascii">65 0</Array></FieldData>)")),
              HasSubstr("no Name"));
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
