#include "holdfast/window/window/help_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/files/file_messages.h>

namespace holdfast {
void showHelp(QWidget* window)
{
  const auto tr = [](const char* text) { return QObject::tr(text); };
  QDialog dialog(window);
  dialog.setObjectName("helpDialog");
  dialog.setWindowTitle(tr("Ten gestures"));
  const std::pair<QString, QString> gestures[] = {
      {tr("Rotate the picture"), tr("Drag with the right button, or beside what the tool takes")},
      {tr("Shift it, go nearer"), tr("Drag with the middle button; turn the wheel")},
      {tr("Hold a point exactly"), tr("P, then click a vertex, an edge or a face; V, E and F choose which. "
                                      "K and two clicks keep the vector between two points")},
      {tr("Move it"), tr("Drag an arrow or a square of what is selected; Ctrl snaps; a typed number is exact")},
      {tr("Select a region"), tr("B paints, M draws a rectangle, L a line around, W takes a whole side; "
                                 "Shift adds, Ctrl takes away")},
      {tr("Say what it does"), tr("F fixes the region, H makes a handle, R a rigid feature")},
      {tr("Rotate a handle"), tr("Drag one of its rings, as many times round as you like, or type degrees over it")},
      {tr("Draw around a feature"), tr("C, click places around it, Enter; then R keeps it rigid")},
      {tr("Measured points"), tr("Ctrl+I imports a list, and shows how far each point is from the surface")},
      {tr("Take it back"), tr("Escape during a drag; Ctrl+Z afterwards")}};
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(8);
  grid->setColumnStretch(1, 1);
  int row = 0;
  for (const auto& [gesture, meaning] : gestures) {
    auto* what = new QLabel(QString("<b>%1</b>").arg(gesture));
    auto* how = new QLabel(meaning);
    how->setWordWrap(true);
    how->setMinimumWidth(380);
    grid->addWidget(what, row, 0, Qt::AlignTop);
    grid->addWidget(how, row, 1, Qt::AlignTop);
    ++row;
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(&dialog);
  layout->setContentsMargins(20, 18, 20, 14);
  layout->setSpacing(16);
  layout->addLayout(grid);
  layout->addWidget(buttons);
  dialog.exec();
}

void showManual(QWidget* window)
{
  const QString manual = bundledFile("docs/window.md");
  if (manual.isEmpty())
    return showProblem(window, QObject::tr("The manual is not there."),
                       QObject::tr("It is docs/window.md of the sources, share/holdfast/docs/window.md where the "
                                   "program is installed"));
  auto* dialog = named(new QDialog(window), "manual");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Manual"));
  auto* text = named(new QTextBrowser, "manualText", QObject::tr("Manual"));
  text->setOpenExternalLinks(true);
  text->setSource(QUrl::fromLocalFile(manual), QTextDocument::MarkdownResource);
  newLayout<QVBoxLayout>(dialog, 0, 0, {text});
  dialog->resize(text->fontMetrics().averageCharWidth() * 110, text->fontMetrics().height() * 45);
  dialog->show();
}

}  // namespace holdfast
