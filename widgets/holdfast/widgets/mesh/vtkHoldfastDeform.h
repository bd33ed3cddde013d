#pragma once
/// This filter of VTK deforms a mesh.

#include <memory>

#include <vtkPolyDataAlgorithm.h>

#include <holdfast/deform/deformer.h>

// Members are named as VTK names its own: NOLINTBEGIN(readability-identifier-naming)

/// Deforms the polygons of its input under constraints. The output is the input with moved points, as doubles. The
/// fields of `fieldsOf` are arrays of its points. As long as only targets change, nothing is factorised again.
///
///     vtkNew<vtkHoldfastDeform> deform;
///     deform->SetInputConnection(reader->GetOutputPort());
///     deform->SetConstraints(readConstraints("points.csv"));
///     deform->Update();
///     std::cout << deform->GetReport().solve.message << '\n';
///     mapper->SetInputConnection(deform->GetOutputPort());
///
/// An unusable mesh or list is an error of VTK with the sentence of the `InputError`. The output is empty then. A
/// solution that cannot be used is in the report, and so are conflicts.
///
/// Progress events tell the steps (`GetProgressText`). `SetAbortExecute` ends the execution under way at its next step,
/// and no later execution. The output is then empty until the filter or its input is modified.
class vtkHoldfastDeform : public vtkPolyDataAlgorithm {
 public:
  static vtkHoldfastDeform* New();
  vtkTypeMacro(vtkHoldfastDeform, vtkPolyDataAlgorithm)
  void PrintSelf(std::ostream& os, vtkIndent indent) override;

  /// Sets the constraints. By default there are none, and the output has the shape at rest.
  void SetConstraints(const holdfast::ConstraintList& constraints);
  [[nodiscard]] const holdfast::ConstraintList& GetConstraints() const { return this->Constraints; }

  /// Sets the options. With other options than before, the next update prepares the mesh anew.
  void SetOptions(const holdfast::DeformOptions& options);
  [[nodiscard]] const holdfast::DeformOptions& GetOptions() const { return this->Options; }

  /// Returns the report of the last update.
  [[nodiscard]] const holdfast::Report& GetReport() const { return this->LastReport; }

  vtkHoldfastDeform(const vtkHoldfastDeform&) = delete;
  vtkHoldfastDeform& operator=(const vtkHoldfastDeform&) = delete;

 protected:
  vtkHoldfastDeform();
  ~vtkHoldfastDeform() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  [[nodiscard]] holdfast::DeformResult Deform(vtkPolyData& input);
  [[nodiscard]] bool IsAborted();
  void ForgetAbort();

  holdfast::ConstraintList Constraints;
  holdfast::DeformOptions Options;
  holdfast::Report LastReport;
  std::unique_ptr<holdfast::Deformer> Current;
  vtkPolyData* CurrentInput = nullptr;  // compared, never read
  vtkMTimeType CurrentTime = 0;
};

// NOLINTEND(readability-identifier-naming)
