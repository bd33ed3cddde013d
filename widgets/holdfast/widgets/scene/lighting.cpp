#include "holdfast/widgets/scene/lighting.h"

#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {
namespace {

constexpr Color kBottom{1.0, 1.0, 1.0};
constexpr Color kTop{0.90, 0.915, 0.935};

}  // namespace

void addLights(vtkRenderer& renderer)
{
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.95);
  lights->SetKeyToFillRatio(2.6);
  lights->SetKeyToHeadRatio(3.2);
  lights->SetKeyLightAngle(42, 18);
  lights->SetKeyLightWarmth(0.53);
  lights->SetFillLightWarmth(0.47);
  lights->AddLightsToRenderer(&renderer);
}

void addBackground(vtkRenderer& renderer)
{
  renderer.SetBackground(kBottom.red, kBottom.green, kBottom.blue);
  renderer.SetBackground2(kTop.red, kTop.green, kTop.blue);
  renderer.GradientBackgroundOn();
}

}  // namespace holdfast
