#pragma once
/// \file
/// Pictures of deformed meshes, several beside one another, with the widgets of the product.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/scene.h>

namespace holdfast::paper {

/// A mesh and its deformation by the library: what `holdfast-batch` makes of the same files, with the same bits.
struct Deformed {
  std::unique_ptr<const Model> model;  ///< stays in place
  DeformResult result;
};

/// Of files. Throws `InputError` for those that cannot be used.
[[nodiscard]] Deformed deformed(const std::string& mesh, const std::string& constraints,
                                const DeformOptions& options = {});

/// Straight lines on the picture, in model units.
struct Lines {
  std::vector<std::array<Vector3, 2>> segments;
  Color color{0.80, 0.15, 0.10};
};

/// One deformation in a picture.
struct Panel {
  std::string label;  ///< drawn in its corner
  const Deformed* shown = nullptr;
  ColorBy colorBy = ColorBy::None;
  MeshEdges edges = MeshEdges::Sharp;
  RestGhost ghost = RestGhost::Hidden;
  std::vector<Lines> lines = {};
  ColorRange range = AutomaticRange{};
};

/// What a panel shows.
enum class Frame {
  AllPanels,  ///< the same in each, as near as the meshes of all fit: to be compared
  OwnMesh
};

/// How the panels of a picture are seen.
struct Look {
  Vector3 back = {1, -2, 1};  ///< from the mesh to the eye; not zero
  Vector3 up = {0, 0, 1};     ///< not along `back`
  PictureSize panel{480, 420};
  int columns = 2;
  Frame frame = Frame::AllPanels;
  std::vector<Index> focus = {};  ///< of all vertices, those that fill the panels; none: all
};

/// The panels of a picture, each by itself. They need an X server. Throws `OutputError` where one cannot be drawn.
[[nodiscard]] std::vector<Picture> drawnPanels(const std::vector<Panel>& panels, const Look& look);

/// Draws panels in rows of `columns` into a PNG file. Throws as `drawnPanels`, and std::runtime_error where the file
/// cannot be written.
void drawPanels(const std::string& path, const std::vector<Panel>& panels, const Look& look);

/// The rotation field of `shown` on the sphere, coloured by angle, as a panel. Throws as `drawnPanels`.
[[nodiscard]] Picture drawnSphere(const std::string& label, const Deformed& shown, const PictureSize& size);

/// Pictures of equal size in rows of `columns`, the first at the top left; white where none is left.
[[nodiscard]] Picture tiled(const std::vector<Picture>& pictures, int columns);

}  // namespace holdfast::paper
