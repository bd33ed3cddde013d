#pragma once
/// \file
/// The inspector of points: where they lie on the surface, with exact weights, and where they go.

#include <vector>

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/rest_places.h>

class QComboBox;
class QGridLayout;
class QPushButton;

namespace holdfast {

/// Where one point lies: ids and weights. Of several points nothing of that is shown.
class LocationSection : public InspectorSection {
  Q_OBJECT

 public:
  LocationSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  [[nodiscard]] const SurfaceLocation& location() const;
  void showFields();
  void showWeights(const AtFace* at);
  void chooseKind(int kind);
  void setId(double typed);
  void takeEnds();
  void setT(double typed);
  void setPlace(int axis, double typed);
  void takeWeights();
  void normalize();
  void relocate(const SurfaceLocation& location);

  RestPlaces places_;
  QComboBox* kind_ = nullptr;
  NumberEdit* first_ = nullptr;   // vertex, first end of the edge, or face
  NumberEdit* second_ = nullptr;  // second end of the edge
  NumberEdit* t_ = nullptr;
  VectorEdit* near_ = nullptr;
  QWidget* weights_ = nullptr;
  QGridLayout* weightLines_ = nullptr;
  std::vector<NumberEdit*> weightEdits_;
  QLabel* sum_ = nullptr;
  QPushButton* normalize_ = nullptr;
  QLabel* rest_ = nullptr;
};

/// Where points go: to a place, or by a shift.
class TargetSection : public InspectorSection {
  Q_OBJECT

 public:
  TargetSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  enum DependencyGroup { ToPlace, ByShift };
  void chooseWay(int way);
  void setPlace(int axis, double value);
  void setShift(int axis, double value);

  RestPlaces places_;
  QComboBox* way_ = nullptr;
  VectorEdit* place_ = nullptr;
  VectorEdit* shift_ = nullptr;
};

}  // namespace holdfast
