// A deformation inside a pipeline of VTK: read, deform, write with the fields as arrays.
//   vtk_pipeline MESH.obj CONSTRAINTS RESULT.vtp
#include <iostream>

#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/holdfast.h>
#include <holdfast/widgets/mesh/vtkHoldfastDeform.h>

int main(int argc, char** argv)
try {
  if (argc != 4) throw std::runtime_error("vtk_pipeline MESH.obj CONSTRAINTS RESULT.vtp");
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHoldfastDeform> deform;
  deform->SetInputConnection(reader->GetOutputPort());
  deform->SetConstraints(holdfast::readConstraints(argv[2]));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(deform->GetOutputPort());
  writer->SetFileName(argv[3]);
  if (writer->Write() == 0) throw std::runtime_error("the result cannot be written");
  std::cout << deform->GetReport().solve.message << '\n';
  return deform->GetReport().solve.status == holdfast::SolveStatus::Ok ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
