#include "holdfast/widgets/marks/point_sprites.h"

#include <array>
#include <cmath>
#include <string>

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {
namespace {

/// The distance `d` of the pixel at `p`, in radii of the sprite, from the border of the shape, negative inside; and
/// whether it is light there. In the order of `SpriteShape`.
constexpr std::array<const char*, 5> kShapeCodes{
    "",  // a ball is VTK's
    "float d = min(length(p) - 0.50, max(abs(p.y) - 0.13, abs(p.x) - 0.84)); bool isLight = d > 0.0; d -= 0.14;",
    "float d = max(-p.y, 0.866 * abs(p.x) + 0.5 * p.y) - 0.37; bool isLight = d > 0.0 || length(p) < 0.16; d -= 0.11;",
    "float d = length(p) - 0.84; bool isLight = d > 0.0 || d < -0.34; d -= 0.15;",
    "float d = abs(length(p) - 0.82) - 0.10; bool isLight = d > 0.0; d -= 0.07;"};

std::string fragmentCode(SpriteShape shape)
{
  // How far before their place flat shapes are drawn, in radii, so that a tilted surface does not cut them. A ring is
  // seen as a whole; other shapes are not seen through a thin wall.
  const char* const lift = shape == SpriteShape::Ring ? "3.0" : "1.6";
  return std::string(
             "//VTK::Light::Impl\n"
             "  vec2 p = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);\n  ") +
         kShapeCodes[static_cast<std::size_t>(shape)] +
         "\n  if (d > 0.0) discard;\n"
         "  if (isLight) fragOutput0.rgb = vec3(0.98);\n"
         "  float lift = ZCalcR * " +
         lift +
         ";\n"
         "  gl_FragDepth = cameraParallel == 0 ? (ZCalcS - gl_FragCoord.z) / (lift - 1.0) + ZCalcS\n"
         "                                     : gl_FragCoord.z + ZCalcS * lift;\n";
}

void setBallLook(vtkActor& actor)
{
  vtkProperty& property = *actor.GetProperty();
  property.RenderPointsAsSpheresOn();
  property.SetAmbient(0.25);
  property.SetDiffuse(0.75);
  property.SetSpecular(0.35);
  property.SetSpecularPower(30);
}

}  // namespace

PointSprites::PointSprites(SpriteShape shape, SpriteDepth depth)
{
  if (depth == SpriteDepth::Behind)
    actor_ = vtkSmartPointer<BehindActor>::New();
  else
    actor_ = vtkSmartPointer<vtkActor>::New();
  showData(*actor_, *data_);
  setBallLook(*actor_);
  if (depth == SpriteDepth::Behind || shape != SpriteShape::Ball) actor_->GetProperty()->LightingOff();
  if (shape != SpriteShape::Ball)
    actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, fragmentCode(shape), false);
}

void PointSprites::set(const std::vector<Sprite>& sprites)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  colors->SetNumberOfComponents(3);
  for (const auto& [place, color] : sprites) {
    colors->InsertNextTuple3(std::round(255 * color.red), std::round(255 * color.green), std::round(255 * color.blue));
    cells->InsertNextCell({points->InsertNextPoint(place.data())});
  }
  data_->SetPoints(points);
  data_->SetVerts(cells);
  data_->GetPointData()->SetScalars(colors);
  actor_->SetVisibility(!sprites.empty());
}

void showPointsAsBalls(vtkActor& actor, const Color& color)
{
  setBallLook(actor);
  setColor(actor, color);
}

}  // namespace holdfast
