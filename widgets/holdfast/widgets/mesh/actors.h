#pragma once
/// Actors that are blended with what is there, without an order of their own, and repeated steps of setting up actors.

#include <vtkNew.h>
#include <vtkOpenGLActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// Drawn with the opaque actors, in their order, blended with the picture so far, without writing depths. VTK's own
/// translucent pass copies the depths and so waits for the whole picture on a machine without a GPU.
class BlendedActor : public vtkOpenGLActor {
 public:
  static BlendedActor* New();
  vtkTypeMacro(BlendedActor, vtkOpenGLActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BlendedActor() { ForceOpaqueOn(); }
};

/// A surface drawn farther from the eye than it is: by what its depth changes within a pixel, and a little more. Lines
/// that lie on it are then drawn whole at any angle.
class PushedActor : public vtkOpenGLActor {
 public:
  static PushedActor* New();
  vtkTypeMacro(PushedActor, vtkOpenGLActor)

  /// A share of that, 1 by default: what lies on the surface, below its lines, takes less.
  void SetPush(double share) { Push = share; }
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  PushedActor() = default;

 private:
  double Push = 1;
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

/// `Actor`: of three dimensions or of two.
template <class Actor>
void setColor(Actor& actor, const Color& color)
{
  actor.GetProperty()->SetColor(color.red, color.green, color.blue);
}

/// Pixels of the window.
inline void setLineWidth(vtkActor& actor, double pixels)
{
  actor.GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

inline void setPointSize(vtkActor& actor, double pixels)
{
  actor.GetProperty()->SetPointSize(static_cast<float>(pixels));
}

/// The actor draws `data` by a mapper of its own, which is returned.
inline vtkPolyDataMapper& showData(vtkActor& actor, vtkPolyData& data)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  actor.SetMapper(mapper);
  return *mapper;
}

}  // namespace holdfast
