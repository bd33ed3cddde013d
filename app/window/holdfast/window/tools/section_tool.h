#pragma once
/// A plane that cuts the picture open.

#include <QObject>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/stock_widgets.h>
#include <holdfast/window/model/editor.h>

class vtkImplicitPlaneWidget2;

namespace holdfast {

class Viewport;

/// VTK's plane, beside whatever tool is chosen: what lies on the side that its arrow does not point to is cut away from
/// the picture and cannot be picked. The arrow turns it, the ball in its middle moves it, and beside the mesh it can be
/// pushed by itself. The mesh, its constraints and its files stay as they are.
class SectionTool : public QObject {
  Q_OBJECT

 public:
  SectionTool(Editor& editor, Viewport& viewport, QObject* parent);
  ~SectionTool() override;

  /// Cuts through the middle of what is shown, across the axis of the world that is nearest to the sight, so that the
  /// half before it goes; or where the plane was left; or not at all.
  void setOn(bool isOn);

 private:
  void placeInDocument();
  void cut();

  Editor& editor_;
  Viewport& viewport_;
  vtkNew<SectionPlaneRepresentation> plane_;
  vtkNew<vtkImplicitPlaneWidget2> widget_;
  bool isOn_ = false;
  bool isPlaced_ = false;  // in this document
};

}  // namespace holdfast
