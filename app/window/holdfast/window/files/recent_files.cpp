#include "holdfast/window/files/recent_files.h"

#include <QAction>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

constexpr const char* kKey = "recentFiles";
constexpr const char* kFolders = "folders";

QDir pictureFolder()
{
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/recent";
}

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

QImage fitted(const QImage& picture)
{
  const QImage smooth = picture.scaled(kRecentPictureSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QSize margin = (smooth.size() - kRecentPictureSize) / 2;
  return smooth.copy(QRect({margin.width(), margin.height()}, kRecentPictureSize));
}

QString recentPicture(const QString& path)
{
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
  return pictureFolder().filePath(name + ".png");
}

void keepRecentPicture(const QString& path, const QImage& picture)
{
  const QStringList recent = recentFiles();
  if (!recent.contains(path)) return;
  QDir folder = pictureFolder();
  folder.mkpath(".");
  for (const QFileInfo& kept : folder.entryInfoList({"*.png"}))
    if (std::none_of(recent.begin(), recent.end(),
                     [&](const QString& file) { return recentPicture(file) == kept.filePath(); }))
      QFile::remove(kept.filePath());
  fitted(picture).save(recentPicture(path));
}

QString inLastFolder(const QString& purpose, const QString& suggestion)
{
  const QString folder = QSettings().value(QString("%1/%2").arg(kFolders, purpose)).toString();
  if (folder.isEmpty() || !QFileInfo(folder).isDir()) return suggestion;
  return QFileInfo(suggestion).isDir() ? folder : folder + '/' + QFileInfo(suggestion).fileName();
}

void rememberFolder(const QString& purpose, const QString& path)
{
  if (!path.isEmpty()) QSettings().setValue(QString("%1/%2").arg(kFolders, purpose), QFileInfo(path).absolutePath());
}

void forgetSettings()
{
  QSettings settings;
  for (const QString& key : settings.allKeys())
    if (key != kKey) settings.remove(key);
}

void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open)
{
  menu.clear();
  menu.setToolTipsVisible(true);
  const QStringList all = recentFiles();
  for (int place = 0; place < all.size(); ++place) {
    const QString& path = all[place];
    const bool isThere = QFileInfo::exists(path);
    // Entries "&1" to "&9" by their digit, the last by 0. Ampersands of names are no mnemonics.
    const QString name = QFileInfo(path).fileName().replace('&', "&&");
    QAction* action =
        menu.addAction(QString("&%1  %2").arg((place + 1) % kMostRecentFiles).arg(name), [open, path] { open(path); });
    action->setEnabled(isThere);
    const QString native = QDir::toNativeSeparators(path);
    action->setStatusTip(isThere ? native : QObject::tr("File not found: %1").arg(native));
    action->setToolTip(plainTip(action->statusTip()));
  }
  if (all.isEmpty()) {
    menu.addAction(QObject::tr("No recent files"))->setEnabled(false);
    return;
  }
  menu.addSeparator();
  menu.addAction(QObject::tr("&Clear this list"), [] {
    QSettings().remove(kKey);
    pictureFolder().removeRecursively();
  });
}

}  // namespace holdfast
