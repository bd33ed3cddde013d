#pragma once
/// \file
/// The inspector of what holds many vertices, or two places: regions, handles, relative constraints.

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/rest_places.h>
#include <holdfast/window/model/selected_vertices.h>

class QComboBox;
class QPushButton;

namespace holdfast {

/// How many vertices fixed, rigid and handle constraints hold.
class VerticesSection : public InspectorSection {
  Q_OBJECT

 public:
  VerticesSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  void count();
  void selectThem();

  SelectedVertices vertices_;
  std::shared_ptr<const DocumentState> counted_;
  Rows countedRows_;
  QLabel* count_ = nullptr;
  QLabel* how_ = nullptr;
  QPushButton* select_ = nullptr;
};

/// How handles turn and where they go. Frames have a section of their own.
class HandleSection : public InspectorSection {
  Q_OBJECT

 public:
  HandleSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  void chooseMethod(int method);
  void chooseCenter(int choice);
  void setTranslation(int axis, double value);
  /// Changes the turn of all handles that have one.
  void changeRotation(const QString& name, const std::function<void(AxisRotation&, const HandleConstraint&)>& change);
  [[nodiscard]] Vector3 centroidOf(const HandleConstraint& handle);

  SelectedVertices vertices_;
  QComboBox* method_ = nullptr;
  VectorEdit* axis_ = nullptr;
  NumberEdit* degrees_ = nullptr;
  QComboBox* centerChoice_ = nullptr;
  VectorEdit* center_ = nullptr;
  VectorEdit* translation_ = nullptr;
};

/// Which places relative constraints keep together, and how.
class RelativeSection : public InspectorSection {
  Q_OBJECT

 public:
  RelativeSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  void showPlace(QLabel& label, const SurfaceLocation& location);
  void chooseWay(int way);
  void setOffset(int axis, double value);
  /// The vector that is kept, in numbers.
  [[nodiscard]] Vector3 offsetOf(const RelativeConstraint& relative);

  RestPlaces places_;
  QLabel* from_ = nullptr;
  QLabel* to_ = nullptr;
  QComboBox* way_ = nullptr;
  VectorEdit* offset_ = nullptr;
};

}  // namespace holdfast
