// Job 5: every file that a document can leave, and the session that brings it back.

#include <QDialog>
#include <QImage>
#include <QSpinBox>
#include <QTreeWidget>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/io/mesh_file.h>

#include "support/constraint_lists.h"
#include "window/dialogs.h"
#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

class ExportsJob : public test::JobWindow {
 protected:
  /// Runs an export of the menu, which asks for a file.
  void exportTo(const char* action, const char* name)
  {
    window.exports().setChooser(
        [this, name](QWidget*, const FileQuestion&) { return QString::fromStdString(path(name).string()); });
    trigger(action);
    ASSERT_TRUE(test::waitUntil([this] { return !window.exports().isWriting(); }));
    ASSERT_TRUE(fs::exists(path(name))) << name;
  }

  void exportPicture()
  {
    const test::DialogAnswer answer("pictureDialog", [](QDialog& dialog) {
      dialog.findChild<QSpinBox*>("width")->setValue(400);
      dialog.findChild<QSpinBox*>("height")->setValue(300);
      test::clickButton(dialog, "export");
    });
    exportTo("exportPicture", "bracket.png");
  }

  void saveAs(const char* name)
  {
    chooseFile(path(name).string());
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
    ASSERT_FALSE(window.isWindowModified());
  }
};

TEST_F(ExportsJob, FilesAreExactAndTheSessionComesBack)
{
  static_cast<void>(sample("bracket.obj"));
  openFile(sample("bracket.holdfast"));
  editor().selectConstraints({*indexOf(list(), "flange east")});
  ASSERT_TRUE(settle());
  viewport().setFocus();
  keys("z1.25");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle());
  expectAllMet();
  // A probe, and a region under a name.
  key(Qt::Key_Q);
  const Index probed = freeVertex();
  test::click(viewport(), seenAt(probed));
  ASSERT_EQ(editor().measurements().probes.size(), 1u);
  key(Qt::Key_W);
  test::click(viewport(), seenAt(nearestVertex({50, 0, 12})));
  const std::vector<Index> region = editor().selectedVertices();
  key(Qt::Key_G, Qt::ControlModifier);
  ASSERT_EQ(editor().annotations().selections.size(), 1u);
  key(Qt::Key_Escape);
  ASSERT_TRUE(settle());

  exportTo("exportMesh", "bracket.deformed.obj");
  EXPECT_EQ(readMesh(path("bracket.deformed.obj")).mesh.positions, editor().positions());
  exportTo("exportReport", "report.json");
  EXPECT_EQ(nlohmann::json::parse(test::bytesOf(path("report.json"))).at("constraints").size(),
            list().constraints.size());
  exportTo("exportConstraints", "constraints.json");
  EXPECT_TRUE(test::areSame(readConstraints(path("constraints.json")), list()));
  exportPicture();
  const QImage picture(QString::fromStdString(path("bracket.png").string()));
  EXPECT_EQ(picture.size(), QSize(400, 300));
  saveAs("done.holdfast");

  const Positions before = editor().positions();
  const ConstraintList constraints = list();
  key(Qt::Key_W, Qt::ControlModifier);
  ASSERT_FALSE(editor().isOpen()) << "nothing is unsaved";
  openFile(path("done.holdfast"));
  EXPECT_EQ(editor().positions(), before);
  EXPECT_TRUE(test::areSame(list(), constraints));
  ASSERT_EQ(editor().measurements().probes.size(), 1u);
  EXPECT_EQ(std::get<AtVertex>(editor().measurements().probes[0]).vertex, probed);
  openPanel("Selections");
  auto& saved = find<QTreeWidget>("selectionTree");
  ASSERT_EQ(saved.topLevelItemCount(), 1);
  saved.setFocus();
  key(Qt::Key_Return);
  EXPECT_EQ(editor().selectedVertices(), region);
  EXPECT_FALSE(window.isWindowModified());
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
