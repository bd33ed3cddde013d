#include "window/jobs/job_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <algorithm>

#include <holdfast/widgets/camera/camera_state.h>

#include "support/source_tree.h"
#include "window/gestures.h"

namespace holdfast::test {
namespace {

// The axes stand there.
constexpr int kCornerPixels = 160;

// Glyphs, arrows and lines may stand out of the surface by so much.
constexpr int kMarginPixels = 140;

constexpr Index kSampledVertices = 500;

/// The backdrop changes from row to row alone, and the first pixels of a row show it.
bool isBackdrop(const QImage& picture, int x, int y)
{
  const QColor here = picture.pixelColor(x, y);
  const QColor there = picture.pixelColor(1, y);
  constexpr int kNear = 6;
  return std::abs(here.red() - there.red()) < kNear && std::abs(here.green() - there.green()) < kNear &&
         std::abs(here.blue() - there.blue()) < kNear;
}

/// A vertex on the outline may be drawn one pixel aside.
bool isDrawnAt(const QImage& picture, const QPoint& pixel)
{
  for (const int dx : {-1, 0, 1})
    for (const int dy : {-1, 0, 1}) {
      const QPoint near = pixel + QPoint(dx, dy);
      if (picture.rect().contains(near) && !isBackdrop(picture, near.x(), near.y())) return true;
    }
  return false;
}

double shareOfBackdrop(const QImage& picture, const QRect& area, const QRect& without)
{
  int count = 0;
  int all = 0;
  for (int y = area.top(); y <= area.bottom(); y += 3)
    for (int x = area.left(); x <= area.right(); x += 3) {
      if (without.contains(x, y)) continue;
      ++all;
      if (isBackdrop(picture, x, y)) ++count;
    }
  return all == 0 ? 1 : static_cast<double>(count) / all;
}

QString pathOfPicture()
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const QDir folder(QCoreApplication::applicationDirPath() + "/jobs");
  EXPECT_TRUE(folder.mkpath("."));
  return folder.filePath(QString("%1.%2.png").arg(test->test_suite_name(), test->name()).replace('/', '_'));
}

}  // namespace

void JobWindow::TearDown()
{
  if (editor().isOpen()) editor().markSaved(editor().history().state());
}

void JobWindow::waitForKeys()
{
  ASSERT_TRUE(waitUntil([this] { return window.isActiveWindow(); }));
}

void JobWindow::openFile(const std::filesystem::path& path)
{
  chooseFile(path.string());
  waitForKeys();
  key(Qt::Key_O, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return !window.files().isOpening(); }, std::chrono::minutes(3)));
  ASSERT_TRUE(editor().isOpen());
  ASSERT_TRUE(settle(std::chrono::minutes(3)));
  viewport().setFocus();
}

std::filesystem::path JobWindow::sample(const std::string& name) const
{
  return folder.file(name, bytesOf(dataFolder() + '/' + name));
}

void JobWindow::dragWith(Qt::Key tool, const std::vector<QPointF>& way)
{
  viewport().setFocus();
  key(tool);
  drag(viewport(), way);
}

Index JobWindow::constrainBy(Qt::Key tool, const std::vector<QPointF>& way, Qt::Key kind)
{
  const auto before = list().constraints.size();
  dragWith(tool, way);
  // What an outline selects on a large mesh is found in several turns of the event loop.
  EXPECT_TRUE(waitUntil([this] { return !editor().selectedVertices().empty(); }));
  key(kind);
  EXPECT_EQ(list().constraints.size(), before + 1);
  EXPECT_TRUE(settle(std::chrono::minutes(3)));
  return static_cast<Index>(before);
}

Vector3 JobWindow::restOf(Index vertex)
{
  return editor().model()->mesh.positions.row(vertex).transpose();
}

Vector3 JobWindow::nowOf(Index vertex)
{
  return editor().positions().row(vertex).transpose();
}

const std::vector<Index>& JobWindow::verticesOf(Index constraint)
{
  const auto* fixed = std::get_if<FixedConstraint>(&list().constraints[constraint].what);
  const Selection& select =
      fixed != nullptr ? fixed->select : std::get<HandleConstraint>(list().constraints[constraint].what).select;
  return std::get<VertexIds>(select.what).ids;
}

void JobWindow::expectAllMet()
{
  ASSERT_TRUE(editor().isCurrent());
  const auto& report = editor().deformation()->report;
  EXPECT_EQ(report.solve.status, SolveStatus::Ok);
  EXPECT_LE(report.solve.maxResidualRelative, 1e-12);
  for (const ConstraintOutcome& outcome : report.constraints)
    EXPECT_TRUE(outcome.status == ConstraintStatus::Met || outcome.status == ConstraintStatus::Disabled)
        << outcome.name;
}

void JobWindow::expectPicture()
{
  moveMouse(viewport(), {3, 3});
  ASSERT_TRUE(settle(std::chrono::minutes(3)));
  EXPECT_TRUE(window.grab().save(pathOfPicture()));
  const QImage picture = viewport().grabFramebuffer();
  ASSERT_EQ(picture.size(), viewport().size());
  QRect shown;
  int seen = 0;
  int inside = 0;
  const Index step = std::max<Index>(1, editor().positions().rows() / kSampledVertices);
  for (Index v = 0; v < editor().positions().rows(); v += step) {
    const QPoint pixel = seenAt(v).toPoint();
    shown |= QRect(pixel, QSize(1, 1));
    if (!picture.rect().contains(pixel)) continue;
    ++inside;
    if (isDrawnAt(picture, pixel)) ++seen;
  }
  ASSERT_GT(inside, 20) << "the mesh is in the picture";
  EXPECT_GT(seen, 0.97 * inside);
  // A row of the picture begins with the backdrop only where the mesh leaves it free.
  ASSERT_GT(shown.left(), 5);
  const QRect below = picture.rect().adjusted(0, kCornerPixels, 0, 0);
  const QRect near = shown.adjusted(-kMarginPixels, -kMarginPixels, kMarginPixels, kMarginPixels);
  EXPECT_GT(shareOfBackdrop(picture, below, near), 0.97);
}

}  // namespace holdfast::test
