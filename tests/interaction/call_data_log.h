#pragma once
/// \file
/// What objects of VTK say to their observers.

#include <optional>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace holdfast::test {

/// Copies of the call data of one event of an object, in order; none where there were no data.
template <class T>
class CallDataLog {
 public:
  CallDataLog(vtkObject& object, unsigned long event) : object_(object)
  {
    command_->SetClientData(this);
    command_->SetCallback([](vtkObject*, unsigned long, void* self, void* callData) {
      const T* const data = static_cast<const T*>(callData);
      static_cast<CallDataLog*>(self)->data_.push_back(data ? std::optional<T>(*data) : std::nullopt);
    });
    tag_ = object.AddObserver(event, command_);
  }
  ~CallDataLog() { object_.RemoveObserver(tag_); }
  CallDataLog(const CallDataLog&) = delete;
  CallDataLog& operator=(const CallDataLog&) = delete;

  [[nodiscard]] const std::vector<std::optional<T>>& data() const noexcept { return data_; }

 private:
  vtkObject& object_;
  vtkNew<vtkCallbackCommand> command_;
  unsigned long tag_ = 0;
  std::vector<std::optional<T>> data_;
};

}  // namespace holdfast::test
