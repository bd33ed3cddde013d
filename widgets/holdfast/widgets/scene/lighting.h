#pragma once
/// The light and the background in which meshes are shown.

class vtkRenderer;

namespace holdfast {

/// A key light from above, a fill light and a head light; they move with the camera.
void addLights(vtkRenderer& renderer);

/// White below, light grey above.
void addBackground(vtkRenderer& renderer);

}  // namespace holdfast
