#pragma once
/// \file
/// What lies behind something else, drawn faintly.

#include <holdfast/widgets/mesh/blended_actor.h>

namespace holdfast {

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
