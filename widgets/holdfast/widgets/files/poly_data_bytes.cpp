#include "holdfast/widgets/files/poly_data_bytes.h"

#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtk_error_log.h>

namespace holdfast {
namespace {

/// Runs a writer of VTK, which writes into a string of its own.
template <class Writer>
void write(Writer& writer, vtkPolyData& polyData, const char* extension)
{
  VtkErrorLog log;
  log.watch(writer);
  log.watch(*writer.GetExecutive());
  writer.SetInputData(&polyData);
  writer.WriteToOutputStringOn();
  const bool isWritten = writer.Write() != 0;
  if (!log.isEmpty()) throw OutputError(extension, "VTK cannot write this mesh: " + log.first());
  if (!isWritten) throw OutputError(extension, "VTK cannot write this mesh and gives no reason");
}

}  // namespace

std::string vtpBytes(vtkPolyData& polyData)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  write(*writer, polyData, ".vtp");
  return writer->GetOutputString();
}

std::string legacyBytes(vtkPolyData& polyData, const LegacyHeader& header)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetFileVersion(header.majorVersion < 5 ? vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2
                                                 : vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1);
  writer->SetHeader(header.title.c_str());
  write(*writer, polyData, ".vtk");
  return writer->GetOutputStdString();
}

}  // namespace holdfast
