#pragma once
/// The rotation field on a sphere, Fig. 6 of the paper. It has a point for each vertex, a ball for each rotation that
/// is prescribed, and great arcs between the balls. `rotation_projection.h` says where a rotation is.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

namespace holdfast {

/// The colours of a picture beside those of the colour map.
struct SphereLook {
  Color background{0.97, 0.975, 0.98};
  Color shell{0.90, 0.915, 0.935};
  Color ink{0.13, 0.15, 0.19};
  Color mark{0.93, 0.38, 0.05};
  double pixelRatio = 1;      ///< pixels of the window for each pixel of the picture, in which sizes are
  bool areTextsDrawn = true;  ///< VTK draws them; else another painter writes `RotationSphere::texts` over the picture
};

/// A text of the picture: an angle, an axis, or the name of a constraint.
struct SphereText {
  std::string text;
  DisplayPoint place;   ///< the middle of the text; for a name its beginning, at half its height
  bool isName = false;  ///< it is the name of a constraint; names stand out
};

/// Returns the direction in which the camera looks, of length 1.
[[nodiscard]] inline Vector3 sightOf(vtkCamera& camera)
{
  return Vector3(camera.GetDirectionOfProjection());
}

/// Makes the camera show all `places`, of which there is at least one, from a little beside their middle. Where they
/// reach around the sphere, it shows the whole sphere.
void lookAtPlaces(vtkCamera& camera, const std::vector<Vector3>& places);

/// Shows what is in the picture `factor` times as large, within bounds.
void zoomSphere(vtkCamera& camera, double factor);

/// How near to a point a click must be, in pixels of the picture.
inline constexpr double kSphereReach = 8;

/// The sphere, and the points of one deformation at a time.
///
///     RotationSphere sphere;
///     sphere.addTo(*renderer);
///     sphere.show(placeRotations(model, deformation, nullptr));  // `deformation` is the result of `deform`
///     sphere.fitCamera();
class RotationSphere {
 public:
  RotationSphere();
  ~RotationSphere();

  /// Adds the sphere to a renderer that is in a window. Call it once. It sets the renderer's background and its camera.
  void addTo(vtkRenderer& renderer);
  /// Returns that renderer; null before.
  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }
  void setLook(const SphereLook& look);

  /// Shows the points of `placed`, which is not null. O(number of points that are drawn).
  void show(std::shared_ptr<const PlacedRotations> placed);
  /// Returns what was shown last. Before the first `show` it has no points.
  [[nodiscard]] const PlacedRotations& placed() const noexcept { return *placed_; }
  /// Colours the points as the mesh is coloured, by one value for each vertex of the file. Without a colouring they
  /// have one colour.
  void setColoring(const std::optional<Coloring>& coloring);
  /// Marks the point of a vertex of the file. There is no mark for none, and for a vertex that no face uses.
  void mark(std::optional<Index> vertex);

  /// Makes the camera see what is prescribed from the front, so that it fills the picture.
  void fitCamera() const;

  /// Returns the vertex of the file whose point is nearest to a pixel of the window, within `kSphereReach`. It returns
  /// one on the far side only where there is none on the near side. O(N).
  [[nodiscard]] std::optional<Index> pick(double displayX, double displayY) const;

  /// Returns the texts that have room in the picture that was drawn last.
  [[nodiscard]] std::vector<SphereText> texts() const;

  /// Returns the actor of the points. Its mapper colours them.
  [[nodiscard]] vtkActor& points() const { return *points_; }

 private:
  using Texts = std::vector<vtkSmartPointer<vtkTextActor>>;

  void applyLook();
  void colorPoints();
  void placeMark();
  void showScale();
  void showNames();
  void replace(Texts& texts, Texts with);
  void hideTexts();  // those far behind, and those that others leave no room
  [[nodiscard]] vtkSmartPointer<vtkTextActor> textAt(const std::string& text, const Vector3& place,
                                                     double pixels) const;
  [[nodiscard]] std::optional<Vector3> placeOf(Index vertex) const;

  std::shared_ptr<const PlacedRotations> placed_;
  std::optional<Coloring> coloring_;
  SphereLook look_;
  std::optional<Index> marked_;
  vtkSmartPointer<vtkRenderer> renderer_;
  unsigned long observer_ = 0;
  vtkNew<vtkPolyData> pointData_;
  vtkNew<vtkPolyData> boundaryData_;
  vtkNew<vtkPolyData> arcData_;
  vtkNew<vtkPolyData> markData_;
  vtkNew<BlendedActor> shell_;
  vtkNew<vtkActor> rings_;
  vtkNew<vtkActor> points_;
  vtkNew<vtkActor> balls_;
  vtkNew<vtkActor> arcs_;
  vtkNew<vtkActor> mark_;
  Texts scaleTexts_;
  Texts nameTexts_;
};

}  // namespace holdfast
