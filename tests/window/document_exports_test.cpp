#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSpinBox>
#include <optional>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/field_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/window/files/document_exports.h>

#include "dialogs.h"
#include "files_window.h"
#include "gestures.h"
#include "support/constraint_lists.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using test::DialogAnswer;

class DocumentExportsTest : public ::testing::Test {
 protected:
  void SetUp() override
  {
    exports.setChooser(w.chooser());
    ASSERT_TRUE(w.open(w.sample("bracket.obj")));
    w.editor.edit("import", readConstraints(test::dataFolder() + "/bracket.constraints.json"));
    ASSERT_TRUE(w.waitForCurrent());
  }

  [[nodiscard]] bool waitForWritten()
  {
    return test::waitUntil([&] { return !exports.isWriting(); });
  }

  test::FilesWindow w;
  DocumentExports exports{w.editor, &w.window};
};

TEST_F(DocumentExportsTest, AMeshReadsBackBitForBit)
{
  w.answers = {w.path("out.ply")};
  // The other format keeps less, and says so.
  const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "OK"); });
  exports.exportMesh();
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven() || !exports.isWriting(); }));
  EXPECT_EQ(readMesh(w.path("out.ply")).mesh.positions, w.editor.positions());
  EXPECT_TRUE(w.questions[0].suggestion.endsWith("/bracket.deformed.obj")) << w.questions[0].suggestion.toStdString();
  EXPECT_EQ(w.questions[0].filters[0], "OBJ (*.obj)") << "the format of the mesh is proposed";
}

TEST_F(DocumentExportsTest, SinglePrecisionIsWarnedOfBeforeAnythingIsWritten)
{
  w.answers = {w.path("out.stl"), w.path("out.stl")};
  QString said;
  {
    const DialogAnswer answer("messageBox", [&](QDialog& box) {
      said = test::textOf(box);
      test::clickButton(box, "Cancel");
    });
    exports.exportMesh();
    ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven() && !exports.isWriting(); }));
  }
  EXPECT_TRUE(said.contains("single precision")) << said.toStdString();
  EXPECT_FALSE(fs::exists(w.path("out.stl")));

  // The next box comes when the file is written: whoever answers it waits before that.
  std::optional<DialogAnswer> notes;
  const DialogAnswer answer("messageBox", [&](QDialog& box) {
    test::clickButton(box, "goOn");
    notes.emplace("messageBox", [&](QDialog& next) { test::clickButton(next, "OK"); });
  });
  exports.exportMesh();
  ASSERT_TRUE(test::waitUntil([&] { return notes && notes->isGiven(); }));
  EXPECT_TRUE(fs::exists(w.path("out.stl")));
}

TEST_F(DocumentExportsTest, APictureAtOnceSaysWhyItIsNotWritten)
{
  fs::remove_all(w.editor.mesh().path.parent_path());
  QString said;
  const DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  exports.savePicture();
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven() && !exports.isWriting(); }));
  EXPECT_TRUE(said.contains("bracket.1.png")) << said.toStdString();
  EXPECT_TRUE(said.contains("No such file or directory")) << said.toStdString();
}

TEST_F(DocumentExportsTest, ResultsThatAreOlderThanTheConstraintsAreOnlyWrittenWithLeave)
{
  const Positions shown = w.editor.positions();
  w.holdVertex(3);
  w.editor.cancelSolving();
  w.answers = {w.path("out.obj")};
  {
    const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "Cancel"); });
    exports.exportMesh();
  }
  EXPECT_TRUE(w.questions.empty());
  const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "goOn"); });
  exports.exportMesh();
  ASSERT_TRUE(test::waitUntil([&] { return fs::exists(w.path("out.obj")); }));
  EXPECT_EQ(readMesh(w.path("out.obj")).mesh.positions, shown);
}

TEST_F(DocumentExportsTest, FieldsAreThoseOfTheDeformation)
{
  w.answers = {w.path("out.vtp")};
  exports.exportFields();
  ASSERT_TRUE(waitForWritten());
  const Model& model = *w.editor.model();
  const DeformResult& deformation = *w.editor.deformation();
  EXPECT_NE(deformation.positions, model.mesh.positions);
  EXPECT_TRUE(test::bytesOf(w.path("out.vtp")) ==
              fieldsToVtp(model.mesh, deformation.positions, fieldsOf(model, deformation), {}).bytes);
}

TEST_F(DocumentExportsTest, TheEndingOfAReportSaysItsForm)
{
  w.answers = {w.path("report.json"), w.path("table.csv")};
  exports.exportReport();
  ASSERT_TRUE(waitForWritten());
  exports.exportReport();
  ASSERT_TRUE(waitForWritten());
  EXPECT_EQ(test::bytesOf(w.path("report.json")), reportToJson(w.editor.deformation()->report));
  EXPECT_EQ(test::bytesOf(w.path("table.csv")), reportToCsv(w.editor.deformation()->report));
}

TEST_F(DocumentExportsTest, ConstraintsReadBackTheSame)
{
  w.answers = {w.path("out.json")};
  exports.exportConstraints();
  ASSERT_TRUE(waitForWritten());
  EXPECT_TRUE(test::areSame(readConstraints(w.path("out.json")), w.editor.list()));
}

TEST_F(DocumentExportsTest, AFailureToWriteIsExplained)
{
  w.answers = {w.path("no such folder") / "out.json"};
  QString said;
  const DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  exports.exportConstraints();
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("no such folder")) << said.toStdString();
}

/// The picture that comes of the dialog with this width and height.
QImage exportedPicture(DocumentExports& exports, test::FilesWindow& w, const char* name, bool isTransparent = false)
{
  w.answers = {w.path(name)};
  const DialogAnswer answer("pictureDialog", [isTransparent](QDialog& dialog) {
    dialog.findChild<QCheckBox*>("transparent")->setChecked(isTransparent);
    dialog.findChild<QSpinBox*>("width")->setValue(300);
    dialog.findChild<QSpinBox*>("height")->setValue(200);
    test::clickButton(dialog, "export");
  });
  exports.exportPicture();
  EXPECT_TRUE(test::waitUntil([&] { return !exports.isWriting(); }));
  return QImage(QString::fromStdString(w.path(name).string()));
}

TEST_F(DocumentExportsTest, APictureHasTheSizeAndTheCameraThatAreAskedFor)
{
  const QImage usual = exportedPicture(exports, w, "usual.png");
  EXPECT_EQ(usual.size(), QSize(300, 200));
  EXPECT_EQ(exportedPicture(exports, w, "again.png"), usual);

  exports.setPictureView([&] {
    PictureView view;
    view.camera = Camera{{0, -1000, 0}, {0, 0, 0}, {0, 0, 1}, 100, true};
    return view;
  });
  EXPECT_NE(exportedPicture(exports, w, "other.png"), usual);
}

TEST_F(DocumentExportsTest, APictureHasTheColoursThatAreShown)
{
  const QImage grey = exportedPicture(exports, w, "grey.png");
  exports.setPictureView([&] {
    PictureView view;
    view.coloring = coloringOf(*w.editor.model(), *w.editor.deformation(), ColorBy::Displacement, "mm");
    return view;
  });
  EXPECT_NE(exportedPicture(exports, w, "coloured.png"), grey);
}

TEST_F(DocumentExportsTest, APictureMayBeTransparentBesideTheMesh)
{
  const QImage usual = exportedPicture(exports, w, "usual.png");
  const QImage transparent = exportedPicture(exports, w, "transparent.png", true);
  EXPECT_TRUE(test::isOpaque(usual));
  EXPECT_EQ(qAlpha(transparent.pixel(2, 2)), 0);
  int opaque = 0;
  for (int y = 0; y < usual.height(); ++y)
    for (int x = 0; x < usual.width(); ++x) {
      if (qAlpha(transparent.pixel(x, y)) != 255) continue;
      ++opaque;
      ASSERT_EQ(transparent.pixelColor(x, y), usual.pixelColor(x, y)) << x << ", " << y;
    }
  EXPECT_GT(opaque, 2000);
}

TEST_F(DocumentExportsTest, APictureHasTheLegendOfTheWindowAtItsScale)
{
  exports.setPictureView([&] {
    PictureView view;
    view.size = {600, 400};
    view.paintLegend = [](QPainter& painter, const QRectF& area) {
      painter.fillRect(QRectF(area.right() - 100, area.bottom() - 60, 100, 60), Qt::red);
    };
    return view;
  });
  const QImage picture = exportedPicture(exports, w, "legend.png");
  EXPECT_EQ(picture.pixelColor(299, 199), QColor(Qt::red));
  EXPECT_EQ(picture.pixelColor(251, 171), QColor(Qt::red)) << "half as large as in the window";
  EXPECT_NE(picture.pixelColor(248, 171), QColor(Qt::red));
}

TEST_F(DocumentExportsTest, APictureIsSavedWithoutAQuestionByANameOfItsOwn)
{
  PictureView view;
  view.size = {300, 200};
  view.pixelRatio = 1.5;
  exports.setPictureView([&] { return view; });
  for (const char* name : {"bracket.1.png", "bracket.2.png"}) {
    exports.savePicture();
    ASSERT_TRUE(waitForWritten());
    const QImage picture(QString::fromStdString(w.path(name).string()));
    EXPECT_EQ(picture.size(), QSize(450, 300)) << name;
    EXPECT_TRUE(test::isOpaque(picture));
  }
  EXPECT_TRUE(w.questions.empty());
  fs::create_directory(w.path("elsewhere"));
  w.answers = {w.path("elsewhere") / "report.json"};
  exports.exportReport();
  ASSERT_TRUE(waitForWritten());
  exports.savePicture();
  ASSERT_TRUE(waitForWritten());
  EXPECT_TRUE(fs::exists(w.path("elsewhere") / "bracket.1.png")) << "the folder of the last export";
}

TEST_F(DocumentExportsTest, ACopiedPictureHasThePixelsOfTheScreen)
{
  exports.setPictureView([&] {
    PictureView view;
    view.size = {300, 200};
    view.pixelRatio = 1.5;
    view.paintLegend = [](QPainter& painter, const QRectF& area) {
      painter.fillRect(QRectF(area.right() - 100, area.bottom() - 60, 100, 60), Qt::red);
    };
    return view;
  });
  QGuiApplication::clipboard()->clear();
  exports.copyPicture();
  const QImage copied = QGuiApplication::clipboard()->image();
  ASSERT_EQ(copied.size(), QSize(450, 300));
  EXPECT_EQ(copied.pixelColor(301, 211), QColor(Qt::red)) << "the legend is as large beside the mesh";
  EXPECT_NE(copied.pixelColor(298, 211), QColor(Qt::red));
}

}  // namespace
}  // namespace holdfast
