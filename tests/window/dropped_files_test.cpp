#include <QApplication>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/window/table/constraint_table.h>

#include "dialogs.h"
#include "gestures.h"
#include "support/source_tree.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// What a file manager offers.
class Dragged {
 public:
  explicit Dragged(const QList<QUrl>& urls) { data_.setUrls(urls); }

  [[nodiscard]] static Dragged samples(const std::vector<const char*>& names)
  {
    QList<QUrl> urls;
    for (const char* const name : names)
      urls << QUrl::fromLocalFile(QString::fromStdString(test::dataFolder() + '/' + name));
    return Dragged(urls);
  }

  /// False where it is not taken. `proposed` is what the other side would have done with the files.
  bool enter(QWidget& over, Qt::DropAction proposed = Qt::CopyAction)
  {
    QDragEnterEvent event(over.rect().center(), Qt::CopyAction | Qt::MoveAction, &data_, Qt::LeftButton,
                          Qt::NoModifier);
    event.setDropAction(proposed);
    QApplication::sendEvent(&over, &event);
    action_ = event.dropAction();
    return event.isAccepted();
  }

  void drop(QWidget& on)
  {
    QDropEvent event(on.rect().center(), Qt::CopyAction | Qt::MoveAction, &data_, Qt::LeftButton, Qt::NoModifier);
    event.setDropAction(Qt::MoveAction);
    QApplication::sendEvent(&on, &event);
    action_ = event.dropAction();
  }

  [[nodiscard]] Qt::DropAction action() const { return action_; }

 private:
  QMimeData data_;
  Qt::DropAction action_ = Qt::IgnoreAction;
};

class FilesDroppedOnTheWindow : public test::WindowUser {
 protected:
  [[nodiscard]] std::vector<QWidget*> everywhere()
  {
    return {&viewport(), table().viewport(), &find<QToolBar>("toolBar"), window.statusBar()};
  }

  [[nodiscard]] bool hasOpened(const char* name)
  {
    return test::waitUntil([&] { return editor().isOpen() && editor().mesh().path.filename() == name; });
  }
};

TEST_F(FilesDroppedOnTheWindow, AreOpenedWhereverTheyFall)
{
  for (QWidget* const place : everywhere()) {
    Dragged mesh = Dragged::samples({"bracket.obj"});
    ASSERT_TRUE(mesh.enter(*place)) << place->objectName().toStdString();
    mesh.drop(*place);
    EXPECT_TRUE(hasOpened("bracket.obj")) << place->objectName().toStdString();
    editor().close();
  }
}

TEST_F(FilesDroppedOnTheWindow, StayWhereTheyAre)
{
  Dragged mesh = Dragged::samples({"bracket.obj"});
  ASSERT_TRUE(mesh.enter(viewport(), Qt::MoveAction));
  EXPECT_EQ(mesh.action(), Qt::CopyAction);
  mesh.drop(viewport());
  EXPECT_EQ(mesh.action(), Qt::CopyAction);
  EXPECT_TRUE(hasOpened("bracket.obj"));
}

TEST_F(FilesDroppedOnTheWindow, AreFilesOfThisComputer)
{
  EXPECT_FALSE(Dragged({QUrl("https://example.org/bracket.obj")}).enter(viewport()));
  EXPECT_FALSE(Dragged({}).enter(viewport()));
}

TEST_F(FilesDroppedOnTheWindow, ListsAreLookedAtBeforeTheyAreImported)
{
  open("bracket.obj");
  Dragged list = Dragged::samples({"bracket.measured.csv"});
  ASSERT_TRUE(list.enter(viewport()));
  list.drop(viewport());
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") != nullptr; }));
  QDialog& dialog = *test::findDialog("importDialog");
  auto& button = *dialog.findChild<QPushButton*>("import");
  ASSERT_TRUE(test::waitUntil([&] { return button.isEnabled(); }));
  EXPECT_TRUE(this->list().constraints.empty());
  test::clickButton(dialog, "import");
  EXPECT_EQ(this->list().constraints.size(), 23u);
}

TEST_F(FilesDroppedOnTheWindow, AListWithoutAMeshSaysWhatToDo)
{
  Dragged list = Dragged::samples({"bracket.measured.csv"});
  ASSERT_TRUE(list.enter(viewport()));
  QString said;
  const test::DialogAnswer answer("messageBox", [&](QDialog& dialog) {
    said = test::textOf(dialog);
    test::clickButton(dialog, "OK");
  });
  list.drop(viewport());
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("bracket.measured.csv") && said.contains("Open the mesh")) << said.toStdString();
}

TEST_F(FilesDroppedOnTheWindow, OfSeveralTheDocumentIsTakenAndTheOthersAreTold)
{
  Dragged files = Dragged::samples({"bracket.measured.csv", "plate_unsymmetric.off", "bracket.obj"});
  ASSERT_TRUE(files.enter(viewport()));
  files.drop(viewport());
  ASSERT_TRUE(hasOpened("plate_unsymmetric.off"));
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("2 more"))
      << window.statusBar()->currentMessage().toStdString();
}

}  // namespace
}  // namespace holdfast
