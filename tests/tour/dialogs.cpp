#include <QTableView>
#include <chrono>

#include <holdfast/window/files/import_dialog.h>
#include <holdfast/window/files/picture_dialog.h>
#include <holdfast/window/files/recovery_dialog.h>

#include "chapters.h"
#include "support/source_tree.h"
#include "window/gestures.h"

namespace holdfast::tour {

void dialogs(Stage& stage)
{
  stage.open("bracket.obj");
  ImportDialog import(stage.editor(), test::dataFolder() + "/bracket.measured.csv", &stage.window());
  require(test::showAndWait(import), "the import dialog comes up");
  const auto* table = import.findChild<QTableView*>("preview");
  require(test::waitUntil([&] { return table->model()->rowCount() > 0; }), "the points are read");
  stage.pictureOf(import, "import_of_measured_points");
  import.accept();
  stage.picture("imported_points");

  using namespace std::chrono_literals;
  const auto now = std::chrono::system_clock::now();
  RecoveryDialog recovery(
      {{"1.holdfast", "/home/ada/parts/housing.holdfast", "/home/ada/parts/housing.obj", now - 4min, "housing"},
       {"2.holdfast", "", "/home/ada/scans/crown_right.ply", now - 26h, "crown_right"},
       {"3.holdfast", "", "", now - 90h, "3"}},
      &stage.window());
  require(test::showAndWait(recovery), "the recovery dialog comes up");
  stage.pictureOf(recovery, "what_a_crash_has_left");
  recovery.close();

  PictureDialog picture(&stage.window());
  require(test::showAndWait(picture), "the picture dialog comes up");
  stage.pictureOf(picture, "export_of_a_picture");
}

}  // namespace holdfast::tour
