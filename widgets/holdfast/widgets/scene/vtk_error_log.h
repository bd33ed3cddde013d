#pragma once
/// A log keeps errors of VTK that would otherwise be printed on the console.

#include <string>

#include <vtkCommand.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// A log keeps the first error of the objects that it watches. While any log lives, nothing of VTK reaches the console
/// of the process: some of VTK's warnings belong to no object.
///
///     VtkErrorLog log;
///     log.watch(*writer);
///     writer->Write();
///     if (!log.isEmpty()) std::cerr << log.first() << '\n';
class VtkErrorLog {
 public:
  VtkErrorLog();
  ~VtkErrorLog();
  VtkErrorLog(const VtkErrorLog&) = delete;
  VtkErrorLog& operator=(const VtkErrorLog&) = delete;

  /// Receives the errors of `object` from now on.
  void watch(vtkObject& object) { object.AddObserver(vtkCommand::ErrorEvent, observer_); }

  [[nodiscard]] bool isEmpty() const { return observer_->first.empty(); }
  /// Returns the first error, without VTK's source line and object address. The first error caused those that came
  /// after it.
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
