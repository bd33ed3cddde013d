#pragma once
/// Some actors here are blended with the picture without an order of their own. The functions are steps that set up
/// actors.

#include <vtkNew.h>
#include <vtkOpenGLActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// An actor that is drawn with the opaque actors, in their order. It is blended with the picture so far and writes no
/// depths. VTK's own translucent pass copies the depths. On a machine without a GPU it therefore waits for the whole
/// picture.
class BlendedActor : public vtkOpenGLActor {
 public:
  static BlendedActor* New();
  vtkTypeMacro(BlendedActor, vtkOpenGLActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BlendedActor() { ForceOpaqueOn(); }
};

/// A surface that is drawn farther from the eye than it is. The distance is the change of its depth within a pixel, and
/// a little more. Lines that lie on the surface are then drawn whole at any angle.
class PushedActor : public vtkOpenGLActor {
 public:
  static PushedActor* New();
  vtkTypeMacro(PushedActor, vtkOpenGLActor)

  /// Sets the share of that distance, 1 by default. A tint that lies on the surface, below its lines, takes less.
  void setPush(double share) { push_ = share; }
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  PushedActor() = default;

 private:
  double push_ = 1;
};

/// An actor of which only the part behind the picture so far is drawn.
class BehindActor : public BlendedActor {
 public:
  static BehindActor* New();
  vtkTypeMacro(BehindActor, BlendedActor)

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

 protected:
  BehindActor() { GetProperty()->SetOpacity(0.30); }
};

/// Sets the colour of an actor, of three dimensions or of two.
template <class Actor>
void setColor(Actor& actor, const Color& color)
{
  actor.GetProperty()->SetColor(color.red, color.green, color.blue);
}

/// Sets the width of lines, in pixels of the window.
inline void setLineWidth(vtkActor& actor, double pixels)
{
  actor.GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

/// Sets the diameter of points, in pixels of the window.
inline void setPointSize(vtkActor& actor, double pixels)
{
  actor.GetProperty()->SetPointSize(static_cast<float>(pixels));
}

/// Makes the actor draw `data` by a mapper of its own. Returns the mapper.
inline vtkPolyDataMapper& showData(vtkActor& actor, vtkPolyData& data)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  actor.SetMapper(mapper);
  return *mapper;
}

}  // namespace holdfast
