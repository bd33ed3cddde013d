#include "holdfast/window/files/file_messages.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include <holdfast/base/error.h>
#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

struct FileMessages {
  Q_DECLARE_TR_FUNCTIONS(FileMessages)
};

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
  QStringList lines{FileMessages::tr("File: %1").arg(QString::fromStdString(location.file))};
  if (location.line > 0) lines << FileMessages::tr("Line: %1").arg(location.line);
  if (!location.element.empty()) lines << FileMessages::tr("Place: %1").arg(QString::fromStdString(location.element));
  return lines.join('\n');
}

/// What is wrong, what to do, and where.
QString explained(const std::exception_ptr& error)
{
  try {
    std::rethrow_exception(error);
  } catch (const InputError& input) {
    return asSentence(QString::fromStdString(input.reason())) + "\n\n" + placeOf(input.location());
  } catch (const std::bad_alloc&) {
    return FileMessages::tr("There is not enough memory for it; close other documents and programs.");
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
    setWindowTitle(QCoreApplication::applicationName());
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

MeshAnswer askAboutMesh(Box& box, QAbstractButton* use)
{
  QPushButton* const locate =
      named(box.addButton(FileMessages::tr("&Locate the mesh…"), QMessageBox::ActionRole), "locate");
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(locate);
  const QAbstractButton* const clicked = box.ask();
  if (clicked == locate) return MeshAnswer::Locate;
  return use != nullptr && clicked == use ? MeshAnswer::UseAllTheSame : MeshAnswer::Cancel;
}

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

SaveAnswer askToSave(QWidget* window, const QString& name, const QString& action)
{
  Box box(window, QMessageBox::Warning, FileMessages::tr("Save the changes to “%1” before %2?").arg(name, action),
          FileMessages::tr("Changes that are not saved are lost."));
  box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return SaveAnswer::Save;
  return answer == QMessageBox::Discard ? SaveAnswer::Discard : SaveAnswer::Cancel;
}

bool askToGoOn(QWidget* window, const QString& headline, const QString& explanation, const QString& goOn)
{
  Box box(window, QMessageBox::Warning, headline, explanation);
  QPushButton* const yes = named(box.addButton(goOn, QMessageBox::AcceptRole), "goOn");
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Cancel);
  return box.ask() == yes;
}

MeshAnswer askAboutMissingMesh(QWidget* window, const QString& session, const QString& explanation)
{
  Box box(window, QMessageBox::Warning, FileMessages::tr("The mesh of “%1” is not there.").arg(session),
          asSentence(explanation));
  return askAboutMesh(box, nullptr);
}

MeshAnswer askAboutChangedMesh(QWidget* window, const QString& session, const QString& explanation)
{
  Box box(window, QMessageBox::Warning, FileMessages::tr("The mesh of “%1” has changed.").arg(session),
          asSentence(explanation));
  QPushButton* const use =
      named(box.addButton(FileMessages::tr("&Use it all the same"), QMessageBox::AcceptRole), "useAllTheSame");
  return askAboutMesh(box, use);
}

}  // namespace holdfast
