#pragma once
/// \file
/// A window of VTK alone with an interactor, a surface in it, and a hand on its mouse and keys.

#include <memory>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <holdfast/deform/model.h>
#include <holdfast/widgets/picking/visible_surface.h>

class vtkAbstractWidget;
class vtkObject;
class vtkRenderWindow;

namespace holdfast::test {

/// What is held while the hand moves.
struct Held {
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
};

/// Sends events as an interactor of a real window does. Places are pixels from the lower left corner.
class Mouse {
 public:
  explicit Mouse(vtkRenderWindowInteractor& interactor) : interactor_(interactor) {}

  void moveTo(const DisplayPoint& place, const Held& held = {});
  void press(const DisplayPoint& place, const Held& held = {});
  void release(const DisplayPoint& place, const Held& held = {});
  /// Presses and releases there, without moving.
  void click(const DisplayPoint& place, const Held& held = {});
  /// Sends the second press with a repeat count of 1, as the adapters of VTK do.
  void doubleClick(const DisplayPoint& place, const Held& held = {});
  /// Presses at the first place, moves through all others, releases at the last.
  void drag(const std::vector<DisplayPoint>& way, const Held& held = {});
  void rightPress(const DisplayPoint& place, const Held& held = {});
  void rightRelease(const DisplayPoint& place, const Held& held = {});
  void middlePress(const DisplayPoint& place, const Held& held = {});
  void middleRelease(const DisplayPoint& place, const Held& held = {});
  /// Notches of the wheel, forward or, negative, backward.
  void wheel(const DisplayPoint& place, int notches);
  void leave();
  /// A key by its name: "Escape", "Return", "BackSpace", "v", "bracketleft". Characters get a CharEvent too.
  void key(const std::string& keySym, const Held& held = {});
  /// Each character a key: digits, '.', ',' and '-'.
  void type(const std::string& text);

 private:
  void send(unsigned long event, const DisplayPoint& place, const Held& held, int repeatCount = 0);

  vtkRenderWindowInteractor& interactor_;
};

/// A surface in an offscreen window, which a base-class interactor knows. Seen by a camera that looks along -z at the
/// middle of the mesh, y to the top.
class InteractionFixture {
 public:
  explicit InteractionFixture(Mesh mesh, int width = 400, int height = 300);
  ~InteractionFixture();
  InteractionFixture(const InteractionFixture&) = delete;
  InteractionFixture& operator=(const InteractionFixture&) = delete;

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const { return surface_; }
  [[nodiscard]] vtkRenderWindow& window() const { return *window_; }
  /// Of layer 0: shows the surface, lit, grey on black.
  [[nodiscard]] vtkRenderer& renderer() const { return *renderer_; }
  [[nodiscard]] vtkRenderWindowInteractor& interactor() const { return *interactor_; }
  [[nodiscard]] Mouse& mouse() { return hand_; }

  /// Puts the widget into the window, and switches it on.
  void enable(vtkAbstractWidget& widget);
  /// Looks along y at the whole mesh, z to the top.
  void lookFromFront();

  /// The pixel in which a place is shown, and that of a vertex.
  [[nodiscard]] DisplayPoint pixelOf(const Vector3& place) const;
  [[nodiscard]] DisplayPoint pixelOfVertex(Index vertex) const;

  /// The colour of a pixel as it is drawn now: red, green, blue from 0 to 255.
  [[nodiscard]] std::vector<int> colorAt(const DisplayPoint& pixel) const;
  /// Pixels of the present picture whose colour is within `tolerance` of this in each channel.
  [[nodiscard]] int countPixels(const std::vector<int>& color, int tolerance = 40) const;
  /// Writes the present picture as PNG, to be looked at.
  void save(const std::string& path) const;

 private:
  Model model_;
  std::shared_ptr<const VisibleSurface> surface_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  Mouse hand_{*interactor_};
};

/// Names of the events that an object invokes, in order, of those that are asked for.
class EventLog {
 public:
  EventLog(vtkObject& object, const std::vector<unsigned long>& events);
  ~EventLog();
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  [[nodiscard]] const std::vector<unsigned long>& events() const noexcept { return events_; }
  void clear() { events_.clear(); }

 private:
  vtkObject& object_;
  std::vector<unsigned long> events_;
  std::vector<unsigned long> tags_;
};

}  // namespace holdfast::test
