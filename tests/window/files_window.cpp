#include "files_window.h"

#include <QCoreApplication>
#include <QSettings>

#include <holdfast/document/list_edits.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast::test {

OwnSettings::OwnSettings()
{
  QCoreApplication::setOrganizationName("holdfast-tests");
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QString::fromStdString(folder_.path().string()));
}

FilesWindow::FilesWindow()
{
  window.resize(640, 400);
  files.setChooser(chooser());
}

bool FilesWindow::open(const std::filesystem::path& path)
{
  files.open(QString::fromStdString(path.string()));
  return waitUntil([&] { return !files.isOpening(); }) && editor.isOpen() && waitForCurrent();
}

bool FilesWindow::waitForCurrent()
{
  return waitUntil([&] { return editor.solveState() == SolveState::Current; });
}

std::filesystem::path FilesWindow::sample(const std::string& name) const
{
  return folder.file(name, bytesOf(dataFolder() + '/' + name));
}

FileChooser FilesWindow::chooser()
{
  return [this](QWidget*, const FileQuestion& question) {
    questions.push_back(question);
    if (answers.empty()) return QString();
    QString answer = QString::fromStdString(answers.front().string());
    answers.erase(answers.begin());
    return answer;
  };
}

void FilesWindow::holdVertex(Index vertex)
{
  editor.edit("hold",
              added(editor.list(), {unusedName(editor.list(), "P"), true, PointConstraint{AtVertex{vertex}, Move{}}}));
}

}  // namespace holdfast::test
