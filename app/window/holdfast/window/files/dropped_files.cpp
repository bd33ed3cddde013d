#include "holdfast/window/files/dropped_files.h"

#include <QMimeData>
#include <QUrl>
#include <algorithm>

namespace holdfast {
namespace {

bool isListFile(const QString& path)
{
  return path.endsWith(".csv", Qt::CaseInsensitive) || path.endsWith(".json", Qt::CaseInsensitive);
}

}  // namespace

QStringList localFiles(const QMimeData& data)
{
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  return paths;
}

DroppedFiles sorted(const QStringList& paths)
{
  const auto document = std::find_if_not(paths.begin(), paths.end(), isListFile);
  DroppedFiles files;
  files.isList = document == paths.end();
  files.taken = files.isList ? paths.front() : *document;
  files.leftAlone = paths;
  files.leftAlone.removeOne(files.taken);
  return files;
}

}  // namespace holdfast
