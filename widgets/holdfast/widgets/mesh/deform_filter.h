#pragma once
/// A deformation as a filter of VTK.

#include <memory>

#include <vtkPolyDataAlgorithm.h>

#include <holdfast/deform/deformer.h>

namespace holdfast {

/// Deforms the polygons of its input under constraints. The output is the input with moved points, as doubles, and with
/// the fields of `fieldsOf` as arrays of its points. As long as only targets change, nothing is factorised again.
///
/// Errors (an unusable mesh or list) are VTK errors with the sentence of the `InputError`; the output is empty then. A
/// solution that cannot be used, and conflicts, are in the report. Progress events tell the steps (`GetProgressText`).
/// `SetAbortExecute` ends the execution under way at its next step, and no later one; the output is empty then, until
/// the filter or its input is modified.
class DeformFilter : public vtkPolyDataAlgorithm {
 public:
  static DeformFilter* New();
  vtkTypeMacro(DeformFilter, vtkPolyDataAlgorithm)
  void PrintSelf(std::ostream& os, vtkIndent indent) override;

  /// None by default: the shape at rest.
  void SetConstraints(const ConstraintList& constraints);
  [[nodiscard]] const ConstraintList& GetConstraints() const { return this->Constraints; }

  void SetOptions(const DeformOptions& options);
  [[nodiscard]] const DeformOptions& GetOptions() const { return this->Options; }

  /// That of the last update.
  [[nodiscard]] const Report& GetReport() const { return this->LastReport; }

  DeformFilter(const DeformFilter&) = delete;
  DeformFilter& operator=(const DeformFilter&) = delete;

 protected:
  DeformFilter();
  ~DeformFilter() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  [[nodiscard]] DeformResult Deform(vtkPolyData& input);
  [[nodiscard]] bool IsAborted();
  void ForgetAbort();

  ConstraintList Constraints;
  DeformOptions Options;
  Report LastReport;
  std::unique_ptr<Deformer> Current;
  vtkPolyData* CurrentInput = nullptr;  // compared, never read
  vtkMTimeType CurrentTime = 0;
};

}  // namespace holdfast
