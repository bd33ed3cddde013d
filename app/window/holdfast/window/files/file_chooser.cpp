#include "holdfast/window/files/file_chooser.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include <holdfast/widgets/files/any_mesh_file.h>

namespace holdfast {
namespace {

/// "holdfast" of "Sessions (*.holdfast)".
QString suffixOf(const QString& filter)
{
  static const QRegularExpression kPattern(R"(\*\.(\w+))");
  return kPattern.match(filter).captured(1);
}

}  // namespace

QString chooseFile(QWidget* window, const FileQuestion& question)
{
  QFileDialog dialog(window, question.title);
  dialog.setObjectName("fileDialog");
  const bool isWrite = question.purpose == FileQuestion::Purpose::Write;
  dialog.setAcceptMode(isWrite ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog.setFileMode(isWrite ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog.setNameFilters(question.filters);
  const QFileInfo suggestion(question.suggestion);
  dialog.setDirectory(suggestion.isDir() ? question.suggestion : suggestion.path());
  if (isWrite) {
    if (!suggestion.isDir()) dialog.selectFile(suggestion.fileName());
    const auto followFilter = [&](const QString& filter) { dialog.setDefaultSuffix(suffixOf(filter)); };
    followFilter(question.filters.value(0));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, followFilter);
  }
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.selectedFiles().value(0);
}

QStringList meshFilters()
{
  QStringList all;
  QStringList each;
  for (const std::string_view extension : anyMeshExtensions()) {
    const QString name = QString::fromUtf8(extension.data(), static_cast<int>(extension.size())).mid(1);
    all << "*." + name;
    each << QString("%1 (*.%2)").arg(name.toUpper(), name);
  }
  return QStringList{QCoreApplication::translate("holdfast::FileChooser", "Meshes (%1)").arg(all.join(' '))} + each;
}

}  // namespace holdfast
