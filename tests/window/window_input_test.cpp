// Wheel, letters and words reach what the user means by them, and nothing else.

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTreeWidget>
#include <QWheelEvent>
#include <array>
#include <set>

#include <QtTest/QTest>
#include <gmock/gmock.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/tools/tool_box.h>
#include <holdfast/window/tools/tools.h>

#include "dialogs.h"
#include "files_window.h"
#include "gestures.h"
#include "support/source_tree.h"
#include "window_user.h"

namespace holdfast {
namespace {

// Each with fields of its own.
constexpr std::array kPanelsWithFields{"Selected", "Colours", "Solution", "Conflicts"};

class InputInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
  }

  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  /// Delivers notches as the display does: to what is under the cursor, and on to what that lies in while nothing takes
  /// them.
  static void turnWheelOver(QWidget& widget, int notches)
  {
    const QPointF middle = QRectF(widget.rect()).center();
    QWheelEvent wheel(middle, widget.mapToGlobal(middle.toPoint()), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &wheel);
  }

  [[nodiscard]] std::string valueOf(const QWidget& widget)
  {
    if (const auto* choices = qobject_cast<const QComboBox*>(&widget)) return choices->currentText().toStdString();
    if (const auto* number = qobject_cast<const QSpinBox*>(&widget)) return number->text().toStdString();
    return std::to_string(static_cast<const QSlider&>(widget).value());
  }

  /// Boxes of choices, numbers and sliders that are seen now.
  [[nodiscard]] std::vector<QWidget*> editedByWheel()
  {
    std::vector<QWidget*> all;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
      const bool isOne = qobject_cast<QComboBox*>(widget) != nullptr ||
                         qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
                         qobject_cast<QSlider*>(widget) != nullptr;
      if (isOne && widget->isVisible() && widget->isEnabled()) all.push_back(widget);
    }
    return all;
  }

  /// The letter that Alt goes to a widget with; empty for none.
  [[nodiscard]] static QString letterOf(const QString& text) { return QKeySequence::mnemonic(text).toString(); }
};

TEST_F(InputInWindow, TheWheelEditsNothingThatHasNotTheKeys)
{
  editor().selectConstraints({*indexOf(list(), "flange east")});
  std::size_t tried = 0;
  for (const char* panel : kPanelsWithFields) {
    openPanel(panel);
    viewport().setFocus();
    for (QWidget* widget : editedByWheel()) {
      const auto before = editor().history().state();
      const std::string value = valueOf(*widget);
      for (const int notches : {1, -1, -3}) turnWheelOver(*widget, notches);
      EXPECT_EQ(valueOf(*widget), value) << widget->objectName().toStdString();
      EXPECT_EQ(editor().history().state(), before) << widget->objectName().toStdString();
      EXPECT_NE(widget->focusPolicy(), Qt::WheelFocus) << widget->objectName().toStdString();
      ++tried;
    }
  }
  EXPECT_GT(tried, 12u);
}

TEST_F(InputInWindow, TheWheelEditsWhatHasTheKeys)
{
  openPanel("Colours");
  auto& bands = find<QSpinBox>("colorBands");
  bands.setFocus();
  ASSERT_TRUE(bands.hasFocus());
  turnWheelOver(bands, 3);
  EXPECT_EQ(bands.value(), 4);
}

TEST_F(InputInWindow, LettersOfMenusReachNoField)
{
  std::set<QString> menus;
  for (const QAction* menu : window.menuBar()->actions()) menus.insert(letterOf(menu->text()));
  ASSERT_GE(menus.size(), 6u);
  for (const QLabel* label : window.findChildren<QLabel*>())
    if (label->buddy() != nullptr) {
      EXPECT_FALSE(menus.contains(letterOf(label->text()))) << label->text().toStdString();
    }
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
    EXPECT_FALSE(menus.contains(button->shortcut().toString())) << button->text().toStdString();
}

TEST_F(InputInWindow, AltAndALetterOpensItsMenuFromEveryPanel)
{
  editor().selectConstraints({0});
  for (const char* panel : kPanelsWithFields) {
    openPanel(panel);
    for (const Qt::Key letter : {Qt::Key_V, Qt::Key_E, Qt::Key_C, Qt::Key_S, Qt::Key_F, Qt::Key_H}) {
      viewport().setFocus();
      key(letter, Qt::AltModifier);
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_NE(menu, nullptr) << panel << ", " << static_cast<char>(letter);
      EXPECT_EQ(letterOf(menu->title()), QString("Alt+") + QChar(letter));
      menu->close();
      // The bar would keep the keys for its next menu.
      window.menuBar()->setActiveAction(nullptr);
    }
  }
}

TEST_F(InputInWindow, ThePaletteRunsNothingInThePlaceOfWhatIsGreyed)
{
  // "Show the selection" and "Hide the selection" are called so; other commands speak of a selection.
  const auto run = [this](const char* words) {
    const auto before = editor().history().state();
    const test::DialogAnswer look("commandDialog", [&](QDialog& dialog) {
      auto& rows = *dialog.findChild<QTreeWidget*>("commandList");
      auto& text = *dialog.findChild<QLineEdit*>("commandText");
      test::type(text, words);
      EXPECT_GT(rows.topLevelItemCount(), 0);
      EXPECT_EQ(rows.currentItem(), nullptr) << rows.currentItem()->text(0).toStdString();
      test::pressKey(text, Qt::Key_Return);
      EXPECT_TRUE(dialog.isVisible());
      dialog.reject();
    });
    trigger("commands");
    EXPECT_EQ(editor().history().state(), before);
  };
  editor().selectConstraints({});
  editor().selectVertices({});
  run("fix the selection");
  run("grow");
  run("delete");
  run("redo");
}

TEST_F(InputInWindow, ThePaletteRunsTheOneOfEqualsThatCanBeRun)
{
  // Two are called "delete": in the menu, and in the table.
  editor().selectConstraints({0});
  const auto count = list().constraints.size();
  const test::DialogAnswer look("commandDialog", [](QDialog& dialog) {
    auto& text = *dialog.findChild<QLineEdit*>("commandText");
    test::type(text, "delete");
    EXPECT_NE(dialog.findChild<QTreeWidget*>("commandList")->currentItem(), nullptr);
    test::pressKey(text, Qt::Key_Return);
  });
  trigger("commands");
  EXPECT_EQ(list().constraints.size(), count - 1);
}

TEST_F(InputInWindow, TheFilterOfADocumentGoesWithIt)
{
  auto& words = find<QLineEdit>("constraintFilter");
  auto& status = find<QComboBox>("constraintStatusFilter");
  test::type(words, "flange");
  status.setCurrentIndex(4);
  ASSERT_LT(table().model()->rowCount(), static_cast<int>(list().constraints.size()));
  open("plate_unsymmetric.off", "plate_unsymmetric.three_handles.constraints.json");
  EXPECT_EQ(words.text(), "");
  EXPECT_EQ(status.currentIndex(), 0);
  EXPECT_EQ(table().model()->rowCount(), static_cast<int>(list().constraints.size()));
}

TEST_F(InputInWindow, AProbeAloneIsNoUnsavedChange)
{
  editor().selectConstraints({});
  viewport().setFocus();
  ASSERT_FALSE(window.isWindowModified());
  key(Qt::Key_Q);
  test::click(viewport(), seenAt(freeVertex()));
  ASSERT_EQ(editor().measurements().probes.size(), 1u);
  EXPECT_FALSE(window.isWindowModified());
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(editor().isOpen()) << "nothing was asked";
}

TEST_F(InputInWindow, AProbeBesideAnEditIsSavedWithIt)
{
  editor().selectConstraints({});
  viewport().setFocus();
  const Index vertex = freeVertex();
  key(Qt::Key_Q);
  test::click(viewport(), seenAt(vertex));
  editor().edit("switch", withEnabled(list(), {0}, Enabling::Disabled));
  EXPECT_TRUE(window.isWindowModified());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window.isWindowModified());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(editor().measurements().probes.empty());
  EXPECT_FALSE(window.isWindowModified());
}

TEST_F(InputInWindow, TheCircleOfTheBrushGoesDuringDragsOfOtherThings)
{
  editor().selectConstraints({});
  viewport().setFocus();
  key(Qt::Key_B);
  const QPointF place = seenAt(freeVertex());
  const auto circle = [this] {
    const auto* brush = dynamic_cast<const ToolOf<vtkHoldfastRegionWidget>*>(&window.findChild<ToolBox*>()->current());
    return brush == nullptr ? std::size_t{0} : brush->widget().GetRegionRepresentation()->GetOutline().size();
  };
  test::moveMouse(viewport(), place);
  EXPECT_GT(circle(), 8u);
  test::pressMouse(viewport(), place, Qt::RightButton);
  for (const double x : {4.0, 9.0, 20.0}) test::moveMouse(viewport(), place + QPointF(x, 0), Qt::RightButton);
  EXPECT_EQ(circle(), 0u);
  test::releaseMouse(viewport(), place + QPointF(20, 0), Qt::RightButton);
  ASSERT_TRUE(settle());

  editor().selectConstraints({*indexOf(list(), "flange east")});
  ASSERT_TRUE(settle());
  const QPointF arrow = onArrow(2);
  test::moveMouse(viewport(), seenAt(freeVertex()));
  ASSERT_GT(circle(), 8u);
  test::moveMouse(viewport(), arrow);
  ASSERT_TRUE(window.gizmo().isTouched());
  test::pressMouse(viewport(), arrow);
  for (const double y : {5.0, 12.0, 30.0}) test::moveMouse(viewport(), arrow - QPointF(0, y), Qt::LeftButton);
  EXPECT_EQ(circle(), 0u);
  test::releaseMouse(viewport(), arrow - QPointF(0, 30));
}

TEST_F(InputInWindow, ARangeOfOneUnitInTheLastPlaceIsShown)
{
  openPanel("Colours");
  find<QComboBox>("colorField").setCurrentIndex(static_cast<int>(ColorBy::Displacement));
  find<QComboBox>("colorRangeKind").setCurrentIndex(1);
  for (const auto& [low, high] : {std::pair("1", "1.0000000000000002"), {"-1.0000000000000002", "-1"}})
    for (const auto& [name, text] : {std::pair("colorLow", low), {"colorHigh", high}, {"colorLow", low}}) {
      auto& line = find<QLineEdit>(name);
      line.selectAll();
      test::type(line, text);
      test::pressKey(line, Qt::Key_Return);
    }
  ASSERT_TRUE(settle());
  EXPECT_EQ(std::get<FixedRange>(viewport().colors().range).high, -1);
  EXPECT_FALSE(viewport().legendBox().isEmpty());
}

TEST(SavedPlaces, OfTheUsersOwnFilesLieBesideThem)
{
  test::FilesWindow w;
  const QFileInfo mesh(QString::fromStdString(w.sample("bar.obj").string()));
  EXPECT_EQ(ownFolderBeside(mesh.filePath()), mesh.path());
  EXPECT_EQ(ownFolderBeside("/no such folder/part.obj"), "/no such folder") << "what is wrong there is told";
}

}  // namespace
}  // namespace holdfast
