#include <QDialog>
#include <QTableView>
#include <QTimer>
#include <chrono>

#include <holdfast/window/files/autosave.h>
#include <holdfast/window/files/import_dialog.h>
#include <holdfast/window/window/main_window.h>

#include "chapters.h"
#include "support/source_tree.h"
#include "window/gestures.h"

namespace holdfast::tour {

void dialogs(TourWindow& tour)
{
  tour.open("bracket.obj");
  QDialog& import = *newImportDialog(tour.editor(), test::dataFolder() + "/bracket.measured.csv", &tour.window);
  require(test::showAndWait(import), "the import dialog comes up");
  const auto* table = import.findChild<QTableView*>("preview");
  require(test::waitUntil([&] { return table->model()->rowCount() > 0; }), "the points are read");
  tour.pictureOf(import, "import_of_measured_points");
  import.accept();
  tour.picture("imported_points");

  using namespace std::chrono_literals;
  const auto now = std::chrono::system_clock::now();
  QDialog& recovery = *newRecoveryDialog(
      {{"1.holdfast", "/home/ada/parts/housing.holdfast", "/home/ada/parts/housing.obj", now - 4min, "housing"},
       {"2.holdfast", "", "/home/ada/scans/crown_right.ply", now - 26h, "crown_right"},
       {"3.holdfast", "", "", now - 90h, "3"}},
      [](const Recoverable&) {}, &tour.window);
  require(test::showAndWait(recovery), "the recovery dialog comes up");
  tour.pictureOf(recovery, "what_a_crash_has_left");
  recovery.close();

  QTimer::singleShot(500ms, &tour.window, [&] {
    auto* picture = tour.window.findChild<QDialog*>("pictureDialog");
    require(picture != nullptr, "the picture dialog comes up");
    tour.pictureOf(*picture, "export_of_a_picture");
    picture->reject();
  });
  tour.window.exports().exportPicture();
}

}  // namespace holdfast::tour
