#pragma once
/// Finds constraints by their marks: the one under the cursor, and the one that was clicked.

#include <memory>
#include <optional>
#include <utility>

#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/mesh/section_plane.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// Finds constraints by their marks in the picture. It draws nothing: `SceneContents` draw the marks.
class ConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static ConstraintMarkRepresentation* New();
  vtkTypeMacro(ConstraintMarkRepresentation, vtkWidgetRepresentation)

  /// Sets the marks that can be found. With null, the default, no mark is found.
  void SetMarks(std::shared_ptr<const MarkSet> marks) { assign(*this, this->Marks, std::move(marks)); }

  /// Sets the surface that is drawn. Regions are then found by their faces, too. With null, the default, they are found
  /// by their marks only.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  /// Sets the section plane. Marks whose places it cuts away are not found. By default there is no plane.
  void SetSection(const std::optional<SectionPlane>& section) { this->Section = section; }

  /// Sets how near to the cursor a mark is found, in pixels of a display of ordinary resolution. The default is 9.
  vtkSetClampMacro(ReachPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// Returns the constraint of the mark that is nearest to a pixel of the renderer's window, as a place in the list.
  /// The mark may be hidden by the surface. A mark of a single point comes before one of a region in the same place.
  /// Without a mark near the pixel, it returns the first region that has all corners of the face there. O(marks).
  [[nodiscard]] std::optional<Index> FindConstraint(double displayX, double displayY) const;

  /// Tells whether any mark is of this constraint. O(marks).
  [[nodiscard]] bool HasMarksOf(Index constraint) const;

  void BuildRepresentation() override {}

 protected:
  ConstraintMarkRepresentation() = default;
  ~ConstraintMarkRepresentation() override = default;

 private:
  [[nodiscard]] std::optional<Index> FindRegion(double displayX, double displayY) const;

  std::shared_ptr<const MarkSet> Marks;
  std::shared_ptr<const VisibleSurface> Surface;
  std::optional<SectionPlane> Section;
  double ReachPixels = 9;
  double PixelRatio = 1;
};

/// The call data of `PickEvent`: what a click has chosen.
struct ConstraintPick {
  std::optional<Index> constraint;  ///< place in the list; none where the click was beside all constraints
  bool isAdded = false;             ///< Shift or Ctrl was held: the constraint is to join or leave the selection
};

/// Reports the constraint under the cursor and the one that was clicked. It selects nothing and draws nothing itself. A
/// click is as `Click` describes. The second press of a double click begins no click.
///
///     vtkNew<ConstraintMarkWidget> marks;
///     marks->SetInteractor(interactor);
///     marks->SetMarks(scene.sharedMarks());  // `scene` is a `SceneContents`
///     marks->AddObserver(vtkCommand::HighlightEvent, &tool, &Tool::highlight);  // call data: `Index*`, or null
///     marks->AddObserver(vtkCommand::PickEvent, &tool, &Tool::pick);            // call data: `ConstraintPick*`
///     marks->On();
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent           Move: highlights the constraint under the cursor
///     LeaveEvent               HoverLeave: highlights none
///     LeftButtonPressEvent     Select: begins a click
///     LeftButtonReleaseEvent   EndSelect: ends the click, and reports it; with Shift or Ctrl it has `isAdded`
///
/// These are the events that it invokes:
///
///     HighlightEvent           another constraint is under the cursor; call data: `Index*`, or null for none
///     PickEvent                a click, also beside all constraints; call data: `ConstraintPick*`
class ConstraintMarkWidget : public WidgetOf<ConstraintMarkRepresentation> {
 public:
  static ConstraintMarkWidget* New();
  vtkTypeMacro(ConstraintMarkWidget, vtkAbstractWidget)

  [[nodiscard]] ConstraintMarkRepresentation* GetConstraintMarkRepresentation() { return &this->Drawn(); }

  /// Sets the marks that can be found; with null there are none. A highlighted constraint stays so until the cursor
  /// moves, or until it has no marks any more.
  void SetMarks(std::shared_ptr<const MarkSet> marks);
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Drawn().SetSurface(std::move(surface)); }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }

  /// Returns the constraint that is highlighted because it is under the cursor; none where there is none.
  [[nodiscard]] std::optional<Index> GetHighlighted() const { return this->Highlighted; }

 protected:
  ConstraintMarkWidget();
  ~ConstraintMarkWidget() override = default;

 private:
  void Hover();
  void Leave() { this->Highlight(std::nullopt); }
  void Stop() override { this->Leave(); }
  void Release();

  [[nodiscard]] std::optional<Index> ConstraintAtCursor();
  void Highlight(std::optional<Index> constraint);

  std::optional<Index> Highlighted;
};

}  // namespace holdfast
