#include "holdfast/window/files/bundled_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <array>

namespace holdfast {
namespace {

// From the program's folder: of bin/ of an installation, of build/PRESET/app/.
constexpr std::array kRoots{"../share/holdfast/", "../../../"};

bool isBundled(const QString& folder)
{
  const QDir program(QCoreApplication::applicationDirPath());
  return std::any_of(kRoots.begin(), kRoots.end(), [&](const char* root) {
    const QString samples = QFileInfo(program.filePath(QString(root) + "data")).canonicalFilePath();
    return !samples.isEmpty() && (folder == samples || folder.startsWith(samples + '/'));
  });
}

}  // namespace

QString bundledFile(const QString& path)
{
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* root : kRoots)
    if (QString file = QDir::cleanPath(program.filePath(root + path)); QFileInfo::exists(file)) return file;
  return {};
}

QString ownFolderBeside(const QString& file)
{
  const QFileInfo folder(QFileInfo(file).path());
  // Where the folder is gone, saving there says so to the user.
  const bool isForAll = folder.exists() && (!folder.isWritable() || isBundled(folder.canonicalFilePath()));
  if (!isForAll) return folder.filePath();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

std::vector<Example> examples()
{
  struct Row {
    QString title;
    const char* mesh;
    const char* constraints;
    const char* picture;
  };
  std::vector<Example> all;
  for (const Row& row :
       {Row{QObject::tr("Measured bracket"), "bracket.obj", "bracket", "bracket"},
        {QObject::tr("Twisted bar"), "bar.obj", "bar.twist_720", "twist"},
        {QObject::tr("Plate, three handles"), "plate_unsymmetric.off", "plate_unsymmetric.three_handles",
         "three_handles"},
        {QObject::tr("Head with rigid eyes"), "head.ply", "head.rigid_eyes", "rigid_eyes"},
        {QObject::tr("Plate with conflicts"), "plate_unsymmetric.off", "plate_unsymmetric.conflict", "conflicts"}}) {
    Example example{row.title, bundledFile(QString("data/%1").arg(row.mesh)),
                    bundledFile(QString("data/%1.constraints.json").arg(row.constraints)),
                    bundledFile(QString("docs/images/%1.png").arg(row.picture))};
    if (!example.mesh.isEmpty() && !example.constraints.isEmpty()) all.push_back(std::move(example));
  }
  return all;
}

}  // namespace holdfast
