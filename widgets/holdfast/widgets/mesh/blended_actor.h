#pragma once
/// Actors that are blended with what is there, without an order of their own.

#include <vtkOpenGLActor.h>
#include <vtkProperty.h>

namespace holdfast {

/// Drawn with the opaque actors, in their order, blended with the picture so far, without writing depths: for thin
/// lines and faint marks, which come after all opaque actors. VTK's own translucent pass sorts by depth, but copies the
/// depths and so waits for the whole picture on a machine without a GPU.
class BlendedActor : public vtkOpenGLActor {
 public:
  static BlendedActor* New();
  vtkTypeMacro(BlendedActor, vtkOpenGLActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BlendedActor() { ForceOpaqueOn(); }
};

/// Draws only what is behind the picture so far.
class BehindActor : public BlendedActor {
 public:
  static BehindActor* New();
  vtkTypeMacro(BehindActor, BlendedActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BehindActor() { GetProperty()->SetOpacity(0.30); }
};

}  // namespace holdfast
