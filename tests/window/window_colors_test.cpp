#include <QComboBox>
#include <QLineEdit>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/deform/fields.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

// Of 255. Tables of colours have steps, and the driver rounds.
constexpr int kTolerance = 3;

/// The twisted bar, with nothing beside its surface and without the shades of light, so that colours are those of the
/// map. Its panel of colours is in front.
class ColorsOfBar : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
    view.eye = {150, -260, 110};
    view.target = {0, 0, 50};
    look(view);
    openPanel("Colours");
    choose("restGhost", 0);
    find<QWidget>("constraintGlyphs").setFocus();
    key(Qt::Key_Space);
    ASSERT_FALSE(viewport().display().areConstraintsShown);
    viewport().contents()->mesh().edges().VisibilityOff();
    viewport().contents()->mesh().surface().GetProperty()->LightingOff();
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] const Model& model() { return *editor().model(); }

  void choose(const char* box, int entry)
  {
    chooseEntry(find<QComboBox>(box), entry);
    ASSERT_TRUE(settle());
  }

  void chooseField(ColorBy field) { choose("colorField", static_cast<int>(field)); }

  void typeNumber(const char* line, const char* text)
  {
    auto& edit = find<QLineEdit>(line);
    edit.selectAll();
    test::type(edit, text);
    test::pressKey(edit, Qt::Key_Return);
    ASSERT_TRUE(settle());
  }

  /// Without what is written over it: Qt's text may differ in a bit from time to time. While a button is held edges are
  /// not smoothed: each pixel has the colour of its own place.
  [[nodiscard]] QImage picture()
  {
    auto& overlay = *window.findChild<QWidget*>("overlay");
    overlay.hide();
    test::pressMouse(viewport(), {5, 5}, Qt::MiddleButton);
    viewport().scheduleRender();
    EXPECT_TRUE(settle());
    QImage image = viewport().grab().toImage().convertToFormat(QImage::Format_RGB32);
    test::releaseMouse(viewport(), {5, 5}, Qt::MiddleButton);
    overlay.show();
    return image;
  }

  /// What the core says of each vertex; lengths of vectors.
  [[nodiscard]] std::vector<double> known(const char* field)
  {
    for (const Field& found : fieldsOf(model(), *editor().deformation())) {
      if (found.name != field) continue;
      const std::size_t width = found.values.size() / static_cast<std::size_t>(model().mesh.vertexCount());
      std::vector<double> lengths;
      for (std::size_t k = 0; k < found.values.size(); k += width)
        lengths.push_back(width == 1 ? found.values[k]
                                     : Vector3(found.values[k], found.values[k + 1], found.values[k + 2]).norm());
      return lengths;
    }
    return {};
  }

  /// What the map of the scale on screen makes of `values` in a point of a triangle: of the place between the places of
  /// its corners on the scale, or, where some vertex has none, a mixture of its corners' colours.
  [[nodiscard]] Eigen::Vector3d expected(const std::vector<double>& values, const test::PlainSight& sight)
  {
    const ColorScale& scale = viewport().coloring()->scale;
    const bool isComplete = std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
    double share = 0;
    Eigen::Vector3d mixture = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const double corner = values[static_cast<std::size_t>(model().triangulation.triangles[sight.triangle][k])];
      const Color color = colorOf(scale, corner);
      share += sight.weights[k] * shareOf(scale, corner);
      mixture += sight.weights[k] * Eigen::Vector3d(color.red, color.green, color.blue);
    }
    if (!isComplete) return mixture;
    const Color color = mapColor(share, scale.map);
    return {color.red, color.green, color.blue};
  }

  /// Compares pixels away from the outline of the surface with the colours of `values`.
  void expectColorsOf(const std::vector<double>& values)
  {
    ASSERT_TRUE(viewport().coloring());
    ASSERT_EQ(static_cast<Index>(values.size()), model().mesh.vertexCount());
    const QImage image = picture();
    if (inside_.empty()) findInside(image.size());
    EXPECT_GT(inside_.size(), 100u);
    int worst = 0;
    for (const auto& [pixel, sight] : inside_) {
      const Eigen::Vector3d color = 255 * expected(values, sight);
      const QColor drawn = image.pixelColor(pixel);
      const Eigen::Vector3d difference = Eigen::Vector3d(drawn.red(), drawn.green(), drawn.blue()) - color;
      worst = std::max(worst, static_cast<int>(std::ceil(difference.cwiseAbs().maxCoeff())));
    }
    EXPECT_LE(worst, kTolerance);
  }

  /// Pixels all over the surface, and what is seen there. The bar and the view stay as they are.
  void findInside(const QSize& size)
  {
    for (int y = 40; y < size.height() - 40; y += 23)
      for (int x = 40; x < size.width() / 5 * 4; x += 11) {
        const Eigen::Vector2d screen(x + 0.5, size.height() - y - 0.5);
        if (isInside(screen)) inside_.emplace_back(QPoint(x, y), seen(screen));
      }
  }

  [[nodiscard]] test::PlainSight seen(const Eigen::Vector2d& screen)
  {
    return test::plainSight(view, screen, editor().positions(), model().triangulation.triangles);
  }

  /// Tells whether the surface is seen two pixels to all sides, too.
  [[nodiscard]] bool isInside(const Eigen::Vector2d& screen)
  {
    for (const Eigen::Vector2d& step : {Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 2), Eigen::Vector2d(-2, 2),
                                        Eigen::Vector2d(2, -2), Eigen::Vector2d(-2, -2)}) {
      const test::PlainSight sight = seen(screen + step);
      if (sight.triangle < 0 || sight.isDoubtful) return false;
    }
    return true;
  }

  /// The numbers that VTK colours by are the places of `values` in the table of the scale, point by point.
  void expectGivenToTheMapper(const std::vector<double>& values)
  {
    const MeshActor& mesh = viewport().contents()->mesh();
    auto* data = vtkPolyData::SafeDownCast(mesh.surface().GetMapper()->GetInput());
    vtkDataArray* shares = data->GetPointData()->GetScalars();
    ASSERT_NE(shares, nullptr);
    for (std::size_t k = 0; k < mesh.vertexOf().size(); ++k) {
      const double wanted =
          tablePlace(viewport().coloring()->scale, values[static_cast<std::size_t>(mesh.vertexOf()[k])]);
      const double given = shares->GetTuple1(static_cast<vtkIdType>(k));
      // Lengths of vectors are rounded here and there in ways of their own.
      if (std::isnan(wanted))
        ASSERT_TRUE(std::isnan(given)) << "point " << k;
      else
        ASSERT_DOUBLE_EQ(given, wanted) << "point " << k;
    }
  }

  test::PlainView view;

 private:
  std::vector<std::pair<QPoint, test::PlainSight>> inside_;
};

struct FieldCase {
  ColorBy field;
  const char* title;  // of the legend
  const char* name;   // of the core's field
};

void PrintTo(const FieldCase& testCase, std::ostream* stream)
{
  *stream << testCase.name;
}

class EveryField : public ColorsOfBar, public ::testing::WithParamInterface<FieldCase> {};

TEST_P(EveryField, ColoursTheSurfaceByItsValues)
{
  chooseField(GetParam().field);
  ASSERT_TRUE(viewport().coloring());
  EXPECT_EQ(viewport().coloring()->scale.title, GetParam().title);
  const std::vector<double> values = known(GetParam().name);
  expectGivenToTheMapper(values);
  expectColorsOf(values);
}

INSTANTIATE_TEST_SUITE_P(
    Fields, EveryField,
    ::testing::Values(FieldCase{ColorBy::ConstraintResidual, "constraint residual\n[mm]", "constraint_residual"},
                      FieldCase{ColorBy::Rotation, "rotation |q|\n[rad]", "rotation_log"},
                      FieldCase{ColorBy::Angle, "rotation angle\n[degrees]", "rotation_angle_degrees"},
                      FieldCase{ColorBy::Displacement, "displacement\n[mm]", "displacement"},
                      FieldCase{ColorBy::Detail, "detail residual\n[1/mm]", "detail_residual"},
                      FieldCase{ColorBy::Force, "force", "constraint_force"}),
    [](const ::testing::TestParamInfo<FieldCase>& each) { return std::string(each.param.name); });

TEST_F(ColorsOfBar, DisplacementIsTheWayFromRest)
{
  chooseField(ColorBy::Displacement);
  const Positions way = editor().positions() - model().mesh.positions;
  for (Index v = 0; v < way.rows(); ++v)
    ASSERT_DOUBLE_EQ(viewport().coloring()->values[static_cast<std::size_t>(v)], way.row(v).norm()) << "vertex " << v;
}

TEST_F(ColorsOfBar, TheTopIsTurnedByWhatItsHandleSays)
{
  chooseField(ColorBy::Angle);
  Index top = 0;
  model().mesh.positions.col(2).maxCoeff(&top);
  EXPECT_NEAR(viewport().coloring()->values[static_cast<std::size_t>(top)], 90, 1e-9);
  EXPECT_NEAR(viewport().coloring()->scale.high, 90, 1e-9);
}

TEST_F(ColorsOfBar, WhereNothingIsConstrainedIsGrey)
{
  for (const ColorBy field : {ColorBy::ConstraintResidual, ColorBy::Force}) {
    chooseField(field);
    const QImage image = picture();
    // The middle of the bar: between its foot and its top nothing is held.
    const Vector3 shown = view.shown({0, 0, 50});
    const QColor drawn = image.pixelColor(static_cast<int>(shown.x()), image.height() - static_cast<int>(shown.y()));
    const int grey = static_cast<int>(std::lround(255 * kNoValueColor.red));
    EXPECT_EQ(drawn, QColor(grey, grey, grey)) << drawn.name().toStdString();
  }
}

TEST_F(ColorsOfBar, OneColourHasNoLegend)
{
  chooseField(ColorBy::None);
  EXPECT_FALSE(viewport().coloring());
  const QImage image = picture();
  const Vector3 shown = view.shown({0, 0, 50});
  const QColor drawn = image.pixelColor(static_cast<int>(shown.x()), image.height() - static_cast<int>(shown.y()));
  const QColor plain = QColor::fromRgbF(kPlainColor.red, kPlainColor.green, kPlainColor.blue);
  EXPECT_LE(std::abs(drawn.red() - plain.red()), 1);
  EXPECT_LE(std::abs(drawn.blue() - plain.blue()), 1);
}

TEST_F(ColorsOfBar, EveryMapDrawsItsOwnColours)
{
  chooseField(ColorBy::Rotation);
  std::vector<QImage> pictures;
  for (int map = 0; map < find<QComboBox>("colorMap").count() - 1; ++map) {
    choose("colorMap", map + 1);
    EXPECT_EQ(static_cast<int>(viewport().coloring()->scale.map), map);
    expectColorsOf(known("rotation_log"));
    const QImage drawn = picture();
    for (const QImage& other : pictures) EXPECT_NE(drawn, other) << "map " << map;
    pictures.push_back(drawn);
  }
}

TEST_F(ColorsOfBar, SignedFieldsAreWhiteAtZeroUntilAMapIsChosen)
{
  chooseField(ColorBy::DisplacementX);
  EXPECT_TRUE(isTwoSided(viewport().coloring()->scale.map));
  chooseField(ColorBy::Displacement);
  EXPECT_FALSE(isTwoSided(viewport().coloring()->scale.map));
  choose("colorMap", 1);
  chooseField(ColorBy::DisplacementX);
  EXPECT_EQ(viewport().coloring()->scale.map, ColorMap::BlueGreenYellow);
  choose("colorMap", 0);
  EXPECT_TRUE(isTwoSided(viewport().coloring()->scale.map));
}

TEST_F(ColorsOfBar, AFixedRangeIsTheOneThatIsTyped)
{
  chooseField(ColorBy::Displacement);
  const QImage automatic = picture();
  choose("colorRangeKind", 1);
  EXPECT_EQ(picture(), automatic) << "what is on screen stays until other ends are typed";
  typeNumber("colorHigh", "12.5");
  EXPECT_EQ(viewport().coloring()->scale.high, 12.5);
  EXPECT_NE(picture(), automatic);
  expectColorsOf(known("displacement"));
}

TEST_F(ColorsOfBar, ALogarithmicRangeHasPowersOfTen)
{
  chooseField(ColorBy::Displacement);
  choose("colorRangeKind", 2);
  EXPECT_EQ(viewport().coloring()->scale.scaling, Scaling::Logarithmic);
  expectColorsOf(known("displacement"));
}

TEST_F(ColorsOfBar, TheSameSettingsDrawTheSamePicture)
{
  chooseField(ColorBy::Rotation);
  const QImage once = picture();
  chooseField(ColorBy::Detail);
  EXPECT_NE(picture(), once);
  chooseField(ColorBy::Rotation);
  EXPECT_EQ(picture(), once);
}

}  // namespace
}  // namespace holdfast
