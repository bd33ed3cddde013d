#pragma once
/// \file
/// Actors that are blended with what is there, without an order of their own.

#include <vtkOpenGLActor.h>

namespace holdfast {

/// Drawn together with what is opaque, in the order of the renderer's actors, blended with what is there and without
/// hiding what comes later: for thin lines and faint marks, in the renderer behind all that is opaque. VTK's own way
/// with translucent things gets their order right, and waits for the whole picture before it on a machine without a
/// GPU: it copies the depths.
class BlendedActor : public vtkOpenGLActor {
 public:
  static BlendedActor* New();
  vtkTypeMacro(BlendedActor, vtkOpenGLActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BlendedActor();
};

/// Draws only what lies behind what has been drawn before.
class BehindActor : public BlendedActor {
 public:
  static BehindActor* New();
  vtkTypeMacro(BehindActor, BlendedActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BehindActor();
};

}  // namespace holdfast
