#pragma once
/// \file
/// The lines between glyphs: to targets that are not reached, and between both places of a relative constraint.

#include <vector>

#include <vtkNew.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/color/color_map.h>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace holdfast {

enum class LineStyle { Solid, Dashed };

struct GlyphLine {
  Vector3 from;  ///< model units
  Vector3 to;
  Color color;
  LineStyle style = LineStyle::Solid;
};

/// Lines of one width, without shading.
class GlyphLines {
 public:
  GlyphLines();
  ~GlyphLines();
  GlyphLines(const GlyphLines&) = delete;
  GlyphLines& operator=(const GlyphLines&) = delete;

  /// In the place of all that there were. O(lines).
  void set(const std::vector<GlyphLine>& lines);

  /// In pixels of the window.
  void setWidth(double pixels);

  [[nodiscard]] vtkActor& actor() const { return *actor_; }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
};

}  // namespace holdfast
