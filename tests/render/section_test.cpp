#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/widgets/scene/sliced_drawing.h>

#include "render/drawn_window.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

constexpr int kCutWidth = 320;
constexpr int kCutHeight = 240;

/// A mesh with all that is cut with it, in a window that is never shown, seen along -z in a parallel projection.
class CutScene {
 public:
  explicit CutScene(Mesh mesh) : model_(makeModel(std::move(mesh), "mesh"))
  {
    addBackground(*renderer_);
    addLights(*renderer_);
    background_ = shown();
    contents.addTo(*renderer_);
    renderer_->GetActiveCamera()->ParallelProjectionOn();
    renderer_->ResetCamera();
    renderer_->GetActiveCamera()->SetClippingRange(0.1, 1000);
    slices_.emplace(*renderer_);
  }

  /// Everything that is drawn on a mesh: edges of polygons, the shape at rest as a surface, a selection, rotations.
  void showAll()
  {
    std::vector<Index> vertices(static_cast<std::size_t>(model_.mesh.vertexCount()));
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = static_cast<Index>(v);
    contents.setSelection(vertices);
    contents.setMeshEdges(MeshEdges::All);
    contents.setRestGhost(RestGhost::Surface);
    Positions moved = model_.mesh.positions;
    moved.col(1).array() += 0.1;
    moved.col(2).array() += 0.2;
    DeformResult deformation;
    deformation.positions = moved;
    deformation.rotations = Columns3::Ones(model_.solverMesh.unknownCount(), 3);
    contents.showShape(deformation);
    contents.setRotationDisplay(RotationDisplay::Arrows);
  }

  /// One of every kind of constraint at all vertices in turn, some of them disabled, some selected.
  void showMarks()
  {
    const Positions& positions = model_.mesh.positions;
    std::vector<ConstraintMark> marks;
    std::vector<Index> highlighted;
    for (Index v = 0; v < positions.rows(); ++v) {
      const auto kind = static_cast<MarkKind>(v % 6);
      const Vector3 place = positions.row(v);
      marks.push_back({place, place, v % 7 == 0 ? ConstraintStatus::Disabled : ConstraintStatus::Met, kind, v, place});
      if (v % 3 == 0) highlighted.push_back(v);
    }
    contents.setMarks(std::move(marks));
    contents.highlight(std::move(highlighted));
  }

  /// A picture, as rows of pixels of three colours.
  [[nodiscard]] std::vector<unsigned char> shown()
  {
    window_.window().Render();
    return pixels();
  }

  [[nodiscard]] std::vector<unsigned char> shownInSlices()
  {
    slices_->begin(contents);
    while (slices_->isUnderWay()) slices_->advance();
    return pixels();
  }

  [[nodiscard]] const std::vector<unsigned char>& background() const { return background_; }
  [[nodiscard]] int columnOf(double x) const { return static_cast<int>(toDisplay(*renderer_, {x, 0, 0}).x()); }
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] vtkCamera& camera() { return *renderer_->GetActiveCamera(); }

 private:
  [[nodiscard]] std::vector<unsigned char> pixels()
  {
    return test::pixelsOf(window_.window(), test::DrawnBuffer::Front);
  }

  Model model_;
  test::OffscreenWindow window_{{kCutWidth, kCutHeight}};
  vtkRenderer* renderer_ = &window_.renderer();
  std::vector<unsigned char> background_;
  std::optional<SlicedDrawing> slices_;

 public:
  SceneContents contents{model_};
};

/// How many pixels of the columns [first, last) differ.
int differing(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int first, int last)
{
  int count = 0;
  for (int y = 0; y < kCutHeight; ++y)
    for (int x = first; x < last; ++x) {
      const auto at = 3 * (static_cast<std::size_t>(y) * kCutWidth + x);
      count += a[at] != b[at] || a[at + 1] != b[at + 1] || a[at + 2] != b[at + 2] ? 1 : 0;
    }
  return count;
}

// Lines and glyphs reach some pixels beyond the place where they are cut.
constexpr int kMarginOfCut = 16;

/// The picture is that of nothing to the left of x, and that without a section to the right of it.
void expectCutAt(double x, CutScene& scene, const std::vector<unsigned char>& cut,
                 const std::vector<unsigned char>& whole)
{
  const int column = scene.columnOf(x);
  ASSERT_GT(column, 40);
  ASSERT_LT(column, kCutWidth - 40);
  EXPECT_EQ(differing(cut, scene.background(), 0, column - kMarginOfCut), 0);
  EXPECT_EQ(differing(cut, whole, column + kMarginOfCut, kCutWidth), 0);
  EXPECT_GT(differing(whole, scene.background(), 0, column - kMarginOfCut), 3000) << "otherwise nothing is proved";
}

TEST(Section, CutsAllThatIsDrawnOfTheMesh)
{
  CutScene scene(test::grid(12, 9));
  scene.showAll();
  scene.showMarks();
  const auto whole = scene.shown();
  for (const double x : {4.1, 7.3}) {
    scene.contents.setSection(SectionPlane{{x, 0, 0}, {2, 0, 0}});
    expectCutAt(x, scene, scene.shown(), whole);
  }
  scene.contents.setSection(std::nullopt);
  EXPECT_EQ(scene.shown(), whole);
}

TEST(Section, CutsLargeMeshesInFullDetailInSlicesAndInCoarseDetail)
{
  CutScene scene(test::grid(260, 200));
  scene.showAll();
  ASSERT_GT(scene.contents.mesh().surfaceSlices().count(), 1);
  for (const Detail detail : {Detail::Full, Detail::Coarse}) {
    scene.contents.setSection(std::nullopt);
    scene.contents.setDetail(detail);
    const auto whole = scene.shown();
    scene.contents.setSection(SectionPlane{{100, 0, 0}, {1, 0, 0}});
    expectCutAt(100, scene, scene.shown(), whole);
  }
  const auto inSlices = scene.shownInSlices();
  scene.contents.setDetail(Detail::Full);
  EXPECT_EQ(inSlices, scene.shown());
}

TEST(Section, ShowsTheInsideOfASolidInBothDetails)
{
  CutScene scene(test::icosphere(6));
  scene.contents.lookFrom({0, 0, 10});
  scene.contents.setRestGhost(RestGhost::Hidden);
  const int solid = differing(scene.shown(), scene.background(), 0, kCutWidth);
  scene.contents.setSection(SectionPlane{{0, 0, 0}, {0, 0, -1}});
  for (const Detail detail : {Detail::Full, Detail::Coarse}) {
    scene.contents.setDetail(detail);
    scene.contents.lookFrom({0, 0, 10});
    const auto opened = scene.shown();
    EXPECT_GT(differing(opened, scene.background(), 0, kCutWidth), 0.98 * solid) << "the far half, from inside";
    scene.contents.setSection(SectionPlane{{0, 0, -3}, {0, 0, -1}});
    EXPECT_EQ(scene.shown(), scene.background()) << "all is cut away";
    scene.contents.setSection(SectionPlane{{0, 0, 0}, {0, 0, -1}});
  }
}

TEST(Section, LeavesTheMeshAsItIs)
{
  CutScene scene(test::grid(12, 9));
  const auto before = scene.contents.mesh().points().GetMTime();
  scene.contents.setSection(SectionPlane{{4, 0, 0}, {1, 0, 0}});
  static_cast<void>(scene.shown());
  EXPECT_EQ(scene.contents.mesh().points().GetMTime(), before);
}

TEST(Section, ShowsBothEndsOfARelativeConstraintForThemselves)
{
  CutScene scene(test::grid(12, 9));
  const auto markBetween = [](const Vector3& place, const Vector3& other) {
    ConstraintMark mark{place, place, ConstraintStatus::Met, MarkKind::Relative, 0, place};
    mark.other = other;
    return mark;
  };
  const Vector3 left(2, 4, 0.5);
  const Vector3 right(10, 4, 0.5);
  scene.contents.setSection(SectionPlane{{6, 0, 0}, {1, 0, 0}});
  const auto without = scene.shown();
  const auto changedAround = [&](double x) {
    const int column = scene.columnOf(x);
    return differing(scene.shown(), without, column - 6, column + 6);
  };
  for (const auto& [place, other] : {std::pair{left, right}, std::pair{right, left}}) {
    scene.contents.setMarks({markBetween(place, other)});
    EXPECT_GT(changedAround(10), 40);
    EXPECT_LT(changedAround(2), 30) << "the line, and no ball";
    EXPECT_GT(changedAround(2), 0);
  }
  scene.contents.setMarks({markBetween(left, {3, 4, 0.5})});
  EXPECT_EQ(scene.shown(), without);
}

}  // namespace
}  // namespace holdfast
