#include "tour_window.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "support/source_tree.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

namespace fs = std::filesystem;

/// Until nothing more is waiting to be done.
void handleEvents()
{
  for (int round = 0; round < 4; ++round) QApplication::processEvents();
}

void replaceText(QLineEdit& line, const char* text)
{
  line.setFocus();
  line.selectAll();
  test::type(line, text);
  test::pressKey(line, Qt::Key_Return);
}

}  // namespace

void require(bool holds, const std::string& what)
{
  if (!holds) throw std::runtime_error(what);
}

int picturesIn(const fs::path& folder)
{
  std::error_code ignored;
  return static_cast<int>(std::count_if(fs::directory_iterator(folder, ignored), fs::directory_iterator(),
                                        [](const auto& entry) { return entry.path().extension() == ".png"; }));
}

TourWindow::TourWindow(fs::path folder, int picturesBefore) : folder_(std::move(folder)), count_(picturesBefore)
{
  fs::create_directories(folder_);
  show(1280, 800);
}

void TourWindow::picture(const std::string& name)
{
  pictureOf(window, name);
}

void TourWindow::pictureOf(QWidget& widget, const std::string& name)
{
  settle();
  const fs::path path = folder_ / fmt::format("{:02}_{}.png", ++count_, name);
  require(widget.grab().save(QString::fromStdString(path.string())), "written: " + path.string());
  std::printf("%s\n", path.c_str());
}

void TourWindow::settle()
{
  handleEvents();
  require(!editor().isOpen() || DrivenWindow::settle(), "the document is solved and drawn");
  handleEvents();
}

void TourWindow::open(const std::string& mesh, const std::string& constraints)
{
  DrivenWindow::open(mesh, constraints);
  settle();
}

void TourWindow::openSession(const std::string& session)
{
  window.files().open(QString::fromStdString(test::dataFolder() + "/" + session));
  require(test::waitUntil([&] { return !window.files().isOpening() && editor().isOpen(); }), session + " is opened");
  settle();
}

void TourWindow::resize(int width, int height)
{
  window.resize(width, height);
  require(test::waitUntil([&] { return window.size() == QSize(width, height); }), "the window has its size");
  settle();
}

void TourWindow::trigger(const char* name)
{
  DrivenWindow::trigger(name);
  settle();
}

void TourWindow::clickVertices(const char* tool, const std::vector<Vector3>& places)
{
  trigger(tool);
  for (const Vector3& place : places) test::click(viewport(), shownVertex(nearestVertex(place)));
  settle();
}

void TourWindow::ask(const char* action, const std::function<void(QWidget&)>& see)
{
  bool wasSeen = false;
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog || !dialog->isVisible()) return;
    watch.stop();
    see(*dialog);
    wasSeen = true;
    dialog->close();
  });
  watch.start(0);
  trigger(action);
  require(wasSeen, std::string("a dialog comes of ") + action);
}

void TourWindow::raise(const char* dock)
{
  auto& panel = find<QDockWidget>(dock);
  panel.raise();
  // Those behind others in their stack stand outside the window.
  require(test::waitUntil([&] { return panel.isVisible() && window.rect().intersects(panel.geometry()); }),
          std::string("in front: ") + dock);
  settle();
}

void TourWindow::choose(const char* comboBox, int index)
{
  auto& box = find<QComboBox>(comboBox);
  box.setCurrentIndex(index);
  Q_EMIT box.activated(index);
  settle();
}

void TourWindow::check(const char* checkBox, Qt::CheckState state)
{
  find<QCheckBox>(checkBox).setCheckState(state);
  settle();
}

void TourWindow::enter(const char* line, const char* text)
{
  replaceText(find<QLineEdit>(line), text);
  settle();
}

void TourWindow::enterCell(QAbstractItemView& table, int row, int column, const char* text)
{
  const QModelIndex cell = table.model()->index(row, column);
  table.scrollTo(cell);
  table.selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
  test::pressKey(table, Qt::Key_F2);
  auto* line = table.viewport()->findChild<QLineEdit*>();
  require(line != nullptr, "the cell can be edited");
  replaceText(*line, text);
  require(test::waitUntil([&] { return table.viewport()->findChild<QLineEdit*>() == nullptr; }), "the cell takes it");
  settle();
}

void TourWindow::select(const std::string& constraint)
{
  const auto row = indexOf(editor().list(), constraint);
  require(row.has_value(), "there is a constraint " + constraint);
  editor().selectConstraints({*row});
  settle();
}

QPointF TourWindow::shownVertex(Index vertex)
{
  return shownAt(editor().positions().row(vertex).transpose());
}

QPointF TourWindow::shownMark(const std::string& constraint)
{
  for (const ConstraintMark& mark : viewport().marks())
    if (editor().list().constraints[mark.constraint].name == constraint) return shownAt(mark.place);
  throw std::runtime_error("there is a mark of " + constraint);
}

QPointF TourWindow::onArrow(int axis)
{
  require(window.gizmo().widget().GetEnabled() != 0, "the gizmo stands");
  return DrivenWindow::onArrow(axis);
}

}  // namespace holdfast::tour
