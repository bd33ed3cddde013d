#include "holdfast/window/files/recent_files.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace holdfast {
namespace {

constexpr const char* kKey = "recentFiles";

}  // namespace

QStringList recentFiles()
{
  return QSettings().value(kKey).toStringList().mid(0, kMostRecentFiles);
}

void addRecentFile(const QString& path)
{
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList all = recentFiles();
  all.removeAll(absolute);
  all.prepend(absolute);
  QSettings().setValue(kKey, QStringList(all.mid(0, kMostRecentFiles)));
}

void removeRecentFile(const QString& path)
{
  QStringList all = recentFiles();
  if (all.removeAll(QFileInfo(path).absoluteFilePath()) > 0) QSettings().setValue(kKey, all);
}

void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open)
{
  menu.clear();
  menu.setToolTipsVisible(true);
  const QStringList all = recentFiles();
  for (int place = 0; place < all.size(); ++place) {
    const QString path = all[place];
    const bool isThere = QFileInfo::exists(path);
    // Entries "&1" to "&9" by their digit, the last by 0. Ampersands of names are no mnemonics.
    const QString name = QFileInfo(path).fileName().replace('&', "&&");
    QAction* action =
        menu.addAction(QString("&%1  %2").arg((place + 1) % kMostRecentFiles).arg(name), [open, path] { open(path); });
    action->setEnabled(isThere);
    const QString native = QDir::toNativeSeparators(path);
    action->setToolTip(isThere ? native : QObject::tr("File not found: %1").arg(native));
    action->setStatusTip(action->toolTip());
  }
  if (all.isEmpty()) {
    menu.addAction(QObject::tr("No recent files"))->setEnabled(false);
    return;
  }
  menu.addSeparator();
  menu.addAction(QObject::tr("&Clear this list"), [] { QSettings().remove(kKey); });
}

}  // namespace holdfast
