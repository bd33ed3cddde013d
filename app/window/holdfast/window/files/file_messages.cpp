#include "holdfast/window/files/file_messages.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include <holdfast/io/mesh_file.h>
#include <holdfast/memory/available_memory.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

/// A whole sentence. Elsewhere reasons of the core follow a colon.
QString asSentence(const QString& reason)
{
  if (reason.isEmpty()) return {};
  QString sentence = reason.left(1).toUpper() + reason.mid(1);
  if (!sentence.endsWith('.') && !sentence.endsWith('?')) sentence += '.';
  return sentence;
}

QString placeOf(const InputLocation& location)
{
  QStringList lines{QObject::tr("File: %1").arg(QString::fromStdString(location.file))};
  if (location.line > 0) lines << QObject::tr("Line: %1").arg(location.line);
  if (!location.element.empty()) lines << QObject::tr("Place: %1").arg(QString::fromStdString(location.element));
  return lines.join('\n');
}

/// What is wrong, what to do, and where.
QString explained(const std::exception_ptr& error)
{
  try {
    std::rethrow_exception(error);
  } catch (const InputError& input) {
    return asSentence(QString::fromStdString(input.reason())) + "\n\n" + placeOf(input.location());
  } catch (const LackOfMemory& lack) {
    return asSentence(QString::fromUtf8(lack.what()));
  } catch (const std::bad_alloc&) {
    return QObject::tr("There is not enough memory for it; close other documents and programs.");
  } catch (const std::exception& other) {
    return asSentence(QString::fromUtf8(other.what()));
  }
}

/// A box over `window` whose text can be copied.
class Box : public QMessageBox {
 public:
  Box(QWidget* window, Icon icon, const QString& headline, const QString& explanation) : QMessageBox(window)
  {
    setObjectName("messageBox");
    setWindowTitle("Holdfast");
    setWindowModality(Qt::WindowModal);
    setIcon(icon);
    setText(QString("<b>%1</b>").arg(headline.toHtmlEscaped()));
    setTextFormat(Qt::RichText);
    setInformativeText(explanation.toHtmlEscaped().replace('\n', "<br>"));
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  }

  QAbstractButton* ask()
  {
    exec();
    return clickedButton();
  }
};

}  // namespace

QString textOf(const std::filesystem::path& path)
{
  return QString::fromStdString(path.string());
}

void showProblem(QWidget* window, const QString& headline, const std::exception_ptr& error)
{
  Box(window, QMessageBox::Critical, headline, explained(error)).exec();
}

void showProblem(QWidget* window, const QString& headline, const QString& reason)
{
  Box(window, QMessageBox::Critical, headline, asSentence(reason)).exec();
}

void showNotes(QWidget* window, const QString& headline, const QStringList& notes)
{
  QString text;
  for (const QString& note : notes) text += (text.isEmpty() ? "• " : "\n• ") + asSentence(note);
  Box(window, QMessageBox::Information, headline, text).exec();
}

QMessageBox::StandardButton askToSave(QWidget* window, const QString& name, const QString& action)
{
  Box box(window, QMessageBox::Warning, QObject::tr("Save this session?"),
          QObject::tr("“%1” has changes that are not saved; %2 loses them.").arg(name, action));
  box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn)
{
  Box box(window, QMessageBox::Warning, headline, explanation);
  QPushButton* const yes = named(box.addButton(goOn, QMessageBox::AcceptRole), "goOn");
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Cancel);
  return box.ask() == yes;
}

MeshAnswer askAboutSessionMesh(QWidget* window, const QString& session, const ResolvedMesh& mesh)
{
  const bool isMissing = mesh.state == MeshState::Missing;
  const QString headline =
      isMissing ? QObject::tr("The mesh of “%1” was not found.") : QObject::tr("The mesh of “%1” has changed.");
  Box box(window, QMessageBox::Warning, headline.arg(session), asSentence(QString::fromStdString(mesh.message)));
  const QAbstractButton* use = nullptr;
  if (!isMissing) use = named(box.addButton(QObject::tr("&Use it anyway"), QMessageBox::AcceptRole), "useAllTheSame");
  QPushButton* const locate = named(box.addButton(QObject::tr("&Locate the mesh…"), QMessageBox::ActionRole), "locate");
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(locate);
  const QAbstractButton* const clicked = box.ask();
  if (clicked == locate) return MeshAnswer::Locate;
  return use != nullptr && clicked == use ? MeshAnswer::UseAllTheSame : MeshAnswer::Cancel;
}

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
    // "holdfast" of "Sessions (*.holdfast)".
    const auto followFilter = [&](const QString& filter) {
      dialog.setDefaultSuffix(QRegularExpression(R"(\*\.(\w+))").match(filter).captured(1));
    };
    followFilter(question.filters.value(0));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, followFilter);
  }
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.selectedFiles().value(0);
}

QString formatsText()
{
  QStringList known{".holdfast"};
  for (const std::string_view extension : meshExtensions()) known << toText(extension);
  return QObject::tr("Sessions and meshes are %1.").arg(known.join(", "));
}

QStringList meshFilters()
{
  QStringList all;
  QStringList each;
  for (const std::string_view extension : meshExtensions()) {
    const QString name = toText(extension).mid(1);
    all << "*." + name;
    each << QString("%1 (*.%2)").arg(name.toUpper(), name);
  }
  return QStringList{QObject::tr("Meshes (%1)").arg(all.join(' '))} + each;
}

}  // namespace holdfast
