#include "holdfast/widgets/mesh/vtkHoldfastDeform.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVersionMacros.h>

#include <holdfast/deform/fields.h>
#include <holdfast/mesh/stated_places.h>
#include <holdfast/widgets/mesh/poly_data.h>
#include <holdfast/words/error.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastDeform);

vtkHoldfastDeform::vtkHoldfastDeform()
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkHoldfastDeform::ForgetAbort);
}

/// VTK 9.1 does it at each start; from 9.2 on an abort stays until it is taken back.
void vtkHoldfastDeform::ForgetAbort()
{
  this->SetAbortExecute(0);
}

bool vtkHoldfastDeform::IsAborted()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return this->CheckAbort();  // marks the output for the filters behind it
#else
  return this->GetAbortExecute() != 0;
#endif
}

void vtkHoldfastDeform::SetConstraints(const ConstraintList& constraints)
{
  this->Constraints = constraints;
  this->Modified();
}

void vtkHoldfastDeform::SetOptions(const DeformOptions& options)
{
  if (this->Options == options) return;
  this->Options = options;
  this->Current.reset();
  this->Modified();
}

DeformResult vtkHoldfastDeform::Deform(vtkPolyData& input)
{
  constexpr const char* kInput = "the input of the filter";
  if (this->Current == nullptr || this->CurrentInput != &input || this->CurrentTime != input.GetMTime()) {
    requireSoundCells(input, kInput);
    this->Current.reset();
    this->Current = std::make_unique<Deformer>(
        makeModel({positionsOf(input), polygonsOf(input, kInput)}, kInput, this->Options.weldTolerance), this->Options);
    this->CurrentInput = &input;
    this->CurrentTime = input.GetMTime();
  }
  StoppableProgress progress([this] { return this->IsAborted(); },
                             [this](std::string_view step) {
                               this->SetProgressText(std::string(step).c_str());
                               this->UpdateProgress(this->GetProgress());
                             });
  return this->Current->deform(this->Constraints, "the constraints of the filter", progress);
}

int vtkHoldfastDeform::RequestData(vtkInformation* /*request*/, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input == nullptr || output == nullptr) return 0;
  try {
    const DeformResult result = this->Deform(*input);
    this->LastReport = result.report;
    output->ShallowCopy(input);
    output->SetPoints(toPoints(withStatedPlaces(positionsOf(*input), result.positions)));
    for (const Field& field : fieldsOf(this->Current->model(), result))
      output->GetPointData()->AddArray(toArray(field));
  } catch (const Cancelled&) {
    output->Initialize();
  } catch (const InputError& error) {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkHoldfastDeform::PrintSelf(std::ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Constraints: " << this->Constraints.constraints.size() << '\n';
  os << indent << "Message: " << this->LastReport.solve.message << '\n';
}
