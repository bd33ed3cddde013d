// The window's story in numbered pictures: everything that a user does in it, as real events, on the project's own
// data.
//   holdfast_tour FOLDER        writes FOLDER/01_empty.png and so on; ends with 1 and says where a step failed

#include <QAction>
#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <QVTKOpenGLNativeWidget.h>
#include <fmt/format.h>
#include <vtkRenderer.h>

#include <holdfast/constraints/constraint_file.h>
#include <holdfast/view/camera_motion.h>
#include <holdfast/widgets/main_window.h>
#include <holdfast/widgets/viewport.h>

#include "support/source_tree.h"
#include "widgets/gestures.h"

namespace holdfast {
namespace {

class Tour {
 public:
  explicit Tour(std::filesystem::path folder) : folder_(std::move(folder))
  {
    std::filesystem::create_directories(folder_);
    window_.resize(1280, 800);
    require(test::showAndWait(window_), "the window comes up");
  }

  void empty() { picture("empty"); }

  void openBracket()
  {
    open("bracket.obj", "bracket.constraints.json");
    picture("bracket_with_measured_points");
  }

  void selectPoint()
  {
    choose("toolSelect");
    test::click(viewport(), placeOf(markOf("flange east")));
    picture("selected_point");
  }

  void dragPoint()
  {
    const QPointF tip = placeOf(markOf("flange east"));
    test::drag(viewport(), {tip, tip + QPointF(20, -30), tip + QPointF(30, -60)});
    settle();
    picture("dragged_point");
    trigger("undo");
    settle();
  }

  void dark()
  {
    window_.setAppearance(Appearance::Dark);
    settle();
    picture("dark");
    window_.setAppearance(Appearance::Light);
    settle();
  }

 private:
  static void require(bool holds, const std::string& what)
  {
    if (!holds) throw std::runtime_error(what);
  }

  Viewport& viewport() { return window_.viewport(); }
  Editor& editor() { return window_.editor(); }

  void trigger(const char* name)
  {
    auto* action = window_.findChild<QAction*>(name);
    require(action != nullptr, fmt::format("there is an action {}", name));
    action->trigger();
  }
  void choose(const char* name) { trigger(name); }

  void open(const std::string& mesh, const std::string& constraints)
  {
    NoProgress quiet;
    editor().open(loadMesh(test::dataFolder() + "/" + mesh, quiet),
                  {readConstraints(test::dataFolder() + "/" + constraints), {}});
    settle();
  }

  /// Until what is shown is what was asked for, and is drawn in full.
  void settle()
  {
    require(test::waitUntil([&] {
              return !editor().isOpen() ||
                     (editor().freshness() != Freshness::Solving && !viewport().isRenderPending());
            }),
            "the document is solved and drawn");
  }

  Vector3 markOf(const std::string& name)
  {
    const auto& constraints = editor().list().constraints;
    for (const ConstraintMark& mark : viewport().marks())
      if (constraints[mark.constraint].name == name) return mark.place;
    throw std::runtime_error("no constraint " + name);
  }

  QPointF placeOf(const Vector3& place)
  {
    return viewport().toPlace(toDisplay(viewport().renderer(), place).head<2>());
  }

  void picture(const std::string& name)
  {
    settle();
    QApplication::processEvents();
    const auto path = folder_ / fmt::format("{:02}_{}.png", ++count_, name);
    require(window_.grab().save(QString::fromStdString(path.string())), "written: " + path.string());
    std::printf("%s\n", path.c_str());
  }

  std::filesystem::path folder_;
  int count_ = 0;
  MainWindow window_;
};

int run(int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "usage: holdfast_tour FOLDER\n");
    return 2;
  }
  const QTemporaryDir home;
  qputenv("XDG_STATE_HOME", home.filePath("state").toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("holdfast-tour");
  std::setlocale(LC_NUMERIC, "C");
  try {
    Tour tour(argv[1]);
    tour.empty();
    tour.openBracket();
    tour.selectPoint();
    tour.dragPoint();
    tour.dark();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "holdfast_tour: this does not hold: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace holdfast

int main(int argc, char** argv)
{
  return holdfast::run(argc, argv);
}
