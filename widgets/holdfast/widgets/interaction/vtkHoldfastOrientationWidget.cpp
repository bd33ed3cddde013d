#include "holdfast/widgets/interaction/vtkHoldfastOrientationWidget.h"

#include <cmath>

#include <vtkCameraInterpolator.h>

using namespace holdfast;

namespace {

// Pixels of the window at a ratio of 1, as VTK has it.
constexpr double kSizePixels = 120;
constexpr double kPaddingPixels = 10;

}  // namespace

vtkStandardNewMacro(vtkHoldfastOrientationWidget);

void vtkHoldfastOrientationWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkHoldfastOrientationWidget::SetPixelRatio(double ratio)
{
  const int size = static_cast<int>(std::lround(kSizePixels * ratio));
  const int padding = static_cast<int>(std::lround(kPaddingPixels * ratio));
  this->Drawn().SetSize(size, size);
  this->Drawn().SetPadding(padding, padding);
  this->SquareResize();
}
