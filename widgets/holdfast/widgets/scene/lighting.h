#pragma once
/// Meshes are shown in this light and before this background.

class vtkRenderer;

namespace holdfast {

/// Adds a key light from above, a fill light and a head light. They move with the camera.
void addLights(vtkRenderer& renderer);

/// Makes the background white below and light grey above.
void addBackground(vtkRenderer& renderer);

}  // namespace holdfast
