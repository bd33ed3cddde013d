// The classes that are named as VTK's are print themselves, with their superclass, in the state in which they are made.
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>

#include <holdfast/widgets/interaction/vtkHoldfastConstraintMarkWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastOrientationWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastRegionWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastRotationSphereStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSectionPlaneRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h>
#include <holdfast/widgets/mesh/vtkHoldfastDeform.h>

namespace holdfast {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

template <class Class>
void expectPrinted()
{
  vtkNew<Class> object;
  std::ostringstream text;
  object->Print(text);
  EXPECT_THAT(object->GetClassName(), StartsWith("vtkHoldfast"));
  EXPECT_THAT(text.str(), AllOf(StartsWith(object->GetClassName()), HasSubstr("Reference Count: ")));
}

template <class... Classes>
void expectAllPrinted()
{
  (expectPrinted<Classes>(), ...);
}

TEST(VtkPrinting, BeginsWithTheNameAndHasTheSuperclass)
{
  expectAllPrinted<vtkHoldfastConstraintMarkRepresentation, vtkHoldfastConstraintMarkWidget, vtkHoldfastDeform,
                   vtkHoldfastGizmoRepresentation, vtkHoldfastGizmoWidget, vtkHoldfastOrientationRepresentation,
                   vtkHoldfastOrientationWidget, vtkHoldfastRegionRepresentation, vtkHoldfastRegionWidget,
                   vtkHoldfastRotationSphereStyle, vtkHoldfastSectionPlaneRepresentation, vtkHoldfastSurfaceCameraStyle,
                   vtkHoldfastSurfaceCurveInterpolator, vtkHoldfastSurfaceCurveRepresentation,
                   vtkHoldfastSurfaceCurveWidget, vtkHoldfastSurfaceHandleRepresentation, vtkHoldfastSurfacePointPlacer,
                   vtkHoldfastSurfacePointRepresentation, vtkHoldfastSurfacePointWidget,
                   vtkHoldfastSurfaceRulerRepresentation, vtkHoldfastSurfaceRulerWidget>();
}

}  // namespace
}  // namespace holdfast
