#pragma once
/// Draws closed curves along the edges of a surface.

#include <memory>
#include <vector>

#include <vtkContourWidget.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_curve_representation.h>

namespace holdfast {

/// Clicks place vertices that shortest paths of edges join. A click within 12 pixels of the first one closes the curve;
/// then its places can be dragged, and a drag from elsewhere on it adds one. Clicks are as in `Click`.
///
/// `FollowCursor`, on by default, shows the way to the vertex under the cursor; `ContinuousDraw` and
/// `AllowNodePicking` are without effect. `CloseLoop` closes without an event. Disabling keeps the curve.
class SurfaceCurveWidget : public WidgetOf<SurfaceCurveRepresentation, vtkContourWidget> {
 public:
  static SurfaceCurveWidget* New();
  vtkTypeMacro(SurfaceCurveWidget, vtkContourWidget)

  [[nodiscard]] SurfaceCurveRepresentation* GetSurfaceCurveRepresentation() { return &this->Drawn(); }
  void SetEnabled(int enabling) override;

  /// Null (the default): no curve. Positions may change at any time; a surface of another model removes the curve.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Those of the surface's model; null (the default): clicks are refused.
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { this->Drawn().SetRegions(std::move(regions)); }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  [[nodiscard]] double GetPixelRatio() { return this->Drawn().GetPixelRatio(); }

  /// As of the representation: the vertices that were clicked, and those with all between.
  [[nodiscard]] std::vector<Index> GetPlaces() { return this->Drawn().GetPlaces(); }
  [[nodiscard]] std::vector<Index> GetPath() { return this->Drawn().GetPath(); }
  [[nodiscard]] bool IsClosed() { return this->Drawn().GetClosedLoop() != 0; }

  /// An open curve through these vertices instead, without an event. Surface and regions are set. False, and no curve,
  /// where one cannot be a place (`SurfaceCurveRepresentation::InsertPlace`).
  bool SetPlaces(const std::vector<Index>& vertices);
  /// No curve, without an event.
  void Clear();

  // As mouse and keys, with the same events.

  /// Puts a place at the end of an open curve. False where that is not possible.
  bool AddPlace(Index vertex);
  /// False for a closed curve, and for fewer than three places.
  bool Close();
  /// Takes the last place back; the curve is open then. False where there is none.
  bool RemoveLast();
  /// Takes a drag back, or else all places. False where there are none.
  bool Cancel();

  /// As VTK's, from points near vertices or, better, from vertices. An open line can be continued.
  void Initialize(vtkPolyData* line, int state = 1, vtkIdList* vertices = nullptr) override;
  using vtkContourWidget::Initialize;

 protected:
  SurfaceCurveWidget();
  ~SurfaceCurveWidget() override = default;

  void Stop() override;

 private:
  // One for each widget event: whether the VTK event has been used.
  bool Press();
  bool MoveTo();
  bool Release();
  void Leave();
  bool RemoveByHand();

  bool BeginDrag();
  void Hover(const DisplayPoint& cursor);
  void Changed();
  void Tell(unsigned long event);
  void ShowChanges();
  [[nodiscard]] bool IsDragging() { return this->Drawn().GetCurrentOperation() != vtkContourRepresentation::Inactive; }

  std::vector<Index> PlacesBefore;  // the drag that is under way
};

}  // namespace holdfast
