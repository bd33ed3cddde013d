#pragma once
/// \file
/// What VTK has to say about an operation, kept instead of printed on the console.

#include <string>

#include <vtkCommand.h>
#include <vtkSmartPointer.h>

class vtkObject;

namespace holdfast {

/// Keeps the errors of the VTK objects that it watches. While one lives, nothing of VTK reaches the console: some of
/// its warnings belong to no object and cannot be watched.
class VtkErrorLog {
 public:
  VtkErrorLog();
  ~VtkErrorLog();
  VtkErrorLog(const VtkErrorLog&) = delete;
  VtkErrorLog& operator=(const VtkErrorLog&) = delete;

  /// Hears `object` from now on, as long as either of them lives.
  void watch(vtkObject& object);

  [[nodiscard]] bool isEmpty() const { return observer_->first.empty(); }
  /// The first error, without VTK's source line and object address: what came first caused the others.
  [[nodiscard]] const std::string& first() const { return observer_->first; }

  /// For VTK's calls that take an observer and pass it on to objects of their own.
  [[nodiscard]] vtkCommand* observer() { return observer_; }

 private:
  struct Observer final : vtkCommand {
    static Observer* New();
    void Execute(vtkObject* caller, unsigned long event, void* text) override;
    std::string first;
  };

  vtkSmartPointer<Observer> observer_;
};

}  // namespace holdfast
