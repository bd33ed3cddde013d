#include "window_user.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLineEdit>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <QtTest/QTest>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/table/constraint_table_model.h>

#include "gestures.h"

namespace holdfast::test {
namespace {

/// The bar and the place in it of the tab that begins with `title`; null for none.
std::pair<QTabBar*, int> findTab(QWidget& window, const char* title)
{
  for (QTabBar* bar : window.findChildren<QTabBar*>())
    for (int k = 0; bar->isVisible() && k < bar->count(); ++k)
      if (bar->tabText(k).startsWith(title)) return {bar, k};
  return {nullptr, -1};
}

}  // namespace

void WindowUser::SetUp()
{
  OpenWindow::SetUp();
  // Shortcuts are those of the window that has the keys.
  window.activateWindow();
  ASSERT_TRUE(waitUntil([this] { return window.isActiveWindow(); }));
}

void WindowUser::openPanel(const char* title)
{
  const auto [bar, place] = findTab(window, title);
  ASSERT_NE(bar, nullptr) << title;
  click(*bar, QPointF(bar->tabRect(place).center()));
  ASSERT_EQ(bar->currentIndex(), place);
  QApplication::processEvents();
}

QString WindowUser::tabOf(const char* title)
{
  const auto [bar, place] = findTab(window, title);
  return bar == nullptr ? QString() : bar->tabText(place);
}

QString WindowUser::shown(Index row, int column)
{
  return table().model()->index(static_cast<int>(row), column).data().toString();
}

void WindowUser::typeInto(Index row, int column, const char* text)
{
  const QModelIndex cell = table().model()->index(static_cast<int>(row), column);
  table().scrollTo(cell);
  doubleClick(*table().viewport(), QPointF(table().visualRect(cell).center()));
  auto* line = table().viewport()->findChild<QLineEdit*>();
  ASSERT_NE(line, nullptr) << "the cell cannot be edited";
  line->selectAll();
  type(*line, text);
  pressKey(*line, Qt::Key_Return);
  ASSERT_TRUE(waitUntil([this] { return table().viewport()->findChild<QLineEdit*>() == nullptr; }));
}

void WindowUser::chooseEntry(QComboBox& box, int entry)
{
  ASSERT_TRUE(box.isEnabled());
  const int steps = entry - box.currentIndex();
  for (int k = 0; k < std::abs(steps); ++k) pressKey(box, steps > 0 ? Qt::Key_Down : Qt::Key_Up);
  ASSERT_EQ(box.currentIndex(), entry);
}

QPointF WindowUser::seenAt(const Vector3& place)
{
  return inWidget(toDisplay(viewport().renderer(), place).head<2>());
}

QPointF WindowUser::seenAt(Index vertex)
{
  return seenAt(Vector3(editor().positions().row(vertex).transpose()));
}

Index WindowUser::freeVertex()
{
  const Positions& rest = editor().model()->mesh.positions;
  const double reach = editor().model()->solverMesh.diagonal / 50;
  for (Index v = 0; v < rest.rows(); v += 7) {
    const Vector3 place = rest.row(v).transpose();
    const auto& marks = viewport().marks();
    if (std::any_of(marks.begin(), marks.end(),
                    [&](const ConstraintMark& mark) { return (mark.rest - place).norm() < reach; }))
      continue;
    const DisplayPoint display = toDisplay(viewport().renderer(), editor().positions().row(v).transpose()).head<2>();
    const auto pick =
        SurfacePicker(viewport().surface())
            .pick(viewport().renderer(), std::floor(display.x()), std::floor(display.y()), PickKind::Vertex, 4);
    if (!pick) continue;
    const auto* at = std::get_if<AtVertex>(&pick->location);
    if (at != nullptr && at->vertex == v) return v;
  }
  throw std::runtime_error("no free vertex is seen");
}

void WindowUser::holdVertex(Index vertex)
{
  const auto before = list().constraints.size();
  trigger("toolPoint");
  pressKey(viewport(), Qt::Key_V);
  click(viewport(), seenAt(vertex));
  ASSERT_EQ(list().constraints.size(), before + 1);
  const auto* point = std::get_if<PointConstraint>(&list().constraints.back().what);
  ASSERT_NE(point, nullptr);
  const auto* at = std::get_if<AtVertex>(&point->at);
  ASSERT_NE(at, nullptr);
  ASSERT_EQ(at->vertex, vertex);
  ASSERT_TRUE(settle());
}

void WindowUser::key(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
  QTest::keyClick(&keyOwner(), key, modifiers);
}

void WindowUser::keys(const char* text)
{
  for (const char* letter = text; *letter != 0; ++letter) QTest::keyClick(&keyOwner(), *letter);
}

QWidget& WindowUser::keyOwner()
{
  // After a dialog the display takes a moment to give the keys back.
  static_cast<void>(waitUntil([] { return QApplication::focusWidget() != nullptr; }, std::chrono::seconds(2)));
  QWidget* const focus = QApplication::focusWidget();
  return focus != nullptr ? *focus : window;
}

bool WindowUser::tabTo(QWidget& widget)
{
  for (int k = 0; k < 100 && QApplication::focusWidget() != &widget; ++k) key(Qt::Key_Tab);
  return QApplication::focusWidget() == &widget;
}

void WindowUser::goToColumn(int column)
{
  const int last = ConstraintTableModel::ColumnCount;
  for (int k = 0; k < last; ++k) key(Qt::Key_Left);
  for (int k = 0; k < last && table().currentIndex().column() != column; ++k) key(Qt::Key_Right);
  ASSERT_EQ(table().currentIndex().column(), column);
}

void WindowUser::typeIntoCell(const char* text)
{
  key(Qt::Key_F2);
  ASSERT_NE(qobject_cast<QLineEdit*>(QApplication::focusWidget()), nullptr);
  key(Qt::Key_A, Qt::ControlModifier);
  keys(text);
  key(Qt::Key_Return);
  ASSERT_TRUE(waitUntil([this] { return QApplication::focusWidget() == &table(); }));
  ASSERT_TRUE(settle());
}

void WindowUser::answer(QMessageBox::StandardButton button)
{
  wasAsked_ = false;
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [this, timer, button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    QAbstractButton* wanted = box->button(button);
    if (wanted == nullptr) return;
    timer->deleteLater();
    wasAsked_ = true;
    clickOn(*wanted);
  });
  timer->start(5);
}

void WindowUser::chooseFile(const std::string& path)
{
  window.files().setChooser([path](QWidget*, const FileQuestion&) { return QString::fromStdString(path); });
}

}  // namespace holdfast::test
