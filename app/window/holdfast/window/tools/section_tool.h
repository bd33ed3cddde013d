#pragma once
/// A plane that cuts the picture open.

#include <QObject>

#include <vtkImplicitPlaneWidget2.h>
#include <vtkNew.h>

#include <holdfast/widgets/interaction/stock_widgets.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// VTK's plane, beside whatever tool is chosen: what lies on the side that its arrow does not point to is cut away from
/// the picture and cannot be picked. The arrow turns it, the ball in its middle moves it.
class SectionTool : public QObject {
  Q_OBJECT

 public:
  SectionTool(Editor& editor, Viewport& viewport, QObject* parent);

  /// Cuts where the plane was left, at first through the middle, across the axis that is nearest to the sight.
  void setOn(bool isOn);

 private:
  void placeInDocument();
  void cut() { viewport_.setSection(SectionPlane{Vector3(plane_->GetOrigin()), Vector3(plane_->GetNormal())}); }

  Editor& editor_;
  Viewport& viewport_;
  vtkNew<SectionPlaneRepresentation> plane_;
  vtkNew<vtkImplicitPlaneWidget2> widget_;
  bool isOn_ = false;
  bool isPlaced_ = false;  // in this document
};

}  // namespace holdfast
