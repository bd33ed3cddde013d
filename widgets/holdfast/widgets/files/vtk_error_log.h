#pragma once
/// Errors of VTK, kept instead of printed on the console.

#include <string>

#include <vtkCommand.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// While one lives, nothing of VTK reaches the console: some of its warnings belong to no object.
class VtkErrorLog {
 public:
  VtkErrorLog();
  ~VtkErrorLog();
  VtkErrorLog(const VtkErrorLog&) = delete;
  VtkErrorLog& operator=(const VtkErrorLog&) = delete;

  /// Gets the errors of `object` from now on.
  void watch(vtkObject& object) { object.AddObserver(vtkCommand::ErrorEvent, observer_); }

  [[nodiscard]] bool isEmpty() const { return observer_->first.empty(); }
  /// The first error, without VTK's source line and object address: what came first caused the others.
  [[nodiscard]] const std::string& first() const { return observer_->first; }

 private:
  struct Observer final : vtkCommand {
    static Observer* New() { return new Observer; }
    void Execute(vtkObject* caller, unsigned long event, void* text) override;
    std::string first;
  };

  vtkSmartPointer<Observer> observer_;
};

}  // namespace holdfast
