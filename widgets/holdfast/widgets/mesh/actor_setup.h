#pragma once
/// Repeated steps of setting up an actor.

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

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

/// Lines lie on the surface: they are shifted towards the eye, by the slope of the surface and by units of depth.
inline void drawLinesNearer(vtkPolyDataMapper& mapper, double factor, double units)
{
  mapper.SetResolveCoincidentTopologyToPolygonOffset();
  mapper.SetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
}

}  // namespace holdfast
