#include "holdfast/window/files/recovery_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/file_messages.h>

namespace holdfast {
namespace {

QString native(const std::filesystem::path& path)
{
  return QDir::toNativeSeparators(QString::fromStdString(path.string()));
}

QString timeOf(const Recoverable& copy)
{
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(copy.time.time_since_epoch());
  return QLocale().toString(QDateTime::fromMSecsSinceEpoch(time.count()), QLocale::ShortFormat);
}

/// What the copy is of.
QString originOf(const Recoverable& copy)
{
  if (!copy.original.empty()) return native(copy.original);
  if (!copy.mesh.empty()) return RecoveryDialog::tr("never saved; of the mesh %1").arg(native(copy.mesh));
  return RecoveryDialog::tr("cannot be read: %1").arg(native(copy.path));
}

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<Recoverable> copies, QWidget* parent)
    : QDialog(parent), copies_(std::move(copies)), list_(new QListWidget)
{
  setObjectName("recoveryDialog");
  setWindowTitle(tr("Recover unsaved work"));
  auto* text = new QLabel(
      tr("Holdfast ended before this work was saved. Recovered work opens as it was; the files that it is of are not "
         "touched until you save."));
  text->setWordWrap(true);
  list_->setObjectName("copies");
  list_->setAccessibleName(tr("Unsaved work"));
  list_->setAlternatingRowColors(true);
  for (const Recoverable& copy : copies_) {
    const QString of = originOf(copy);
    auto* item =
        new QListWidgetItem(tr("%1, kept %2\n%3").arg(QString::fromStdString(copy.name), timeOf(copy), of), list_);
    item->setToolTip(of);
  }
  list_->setCurrentRow(0);

  auto* buttons = new QDialogButtonBox;
  recover_ = named(buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole), "recover");
  recover_->setDefault(true);
  discard_ = named(buttons->addButton(tr("&Discard…"), QDialogButtonBox::DestructiveRole), "discard");
  QPushButton* later = named(buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole), "later");
  connect(recover_, &QPushButton::clicked, this, &RecoveryDialog::recover);
  connect(discard_, &QPushButton::clicked, this, &RecoveryDialog::discardChosen);
  connect(later, &QPushButton::clicked, this, &QDialog::reject);
  connect(list_, &QListWidget::itemDoubleClicked, this, &RecoveryDialog::recover);
  connect(list_, &QListWidget::currentRowChanged, this, &RecoveryDialog::updateButtons);

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
  layout->addWidget(list_);
  layout->addWidget(buttons);
  resize(fontMetrics().averageCharWidth() * 80, fontMetrics().height() * 18);
  list_->setFocus();
}

void RecoveryDialog::recover()
{
  const int row = list_->currentRow();
  if (row < 0) return;
  accept();
  Q_EMIT recoverWanted(copies_[row]);
}

void RecoveryDialog::discardChosen()
{
  const int row = list_->currentRow();
  if (row < 0) return;
  const QString name = QString::fromStdString(copies_[row].name);
  if (!askToGoOn(this, tr("Discard the unsaved work on “%1”?").arg(name), tr("It cannot be brought back."),
                 tr("&Discard")))
    return;
  discard(copies_[row]);
  copies_.erase(copies_.begin() + row);
  delete list_->takeItem(row);
  if (copies_.empty()) reject();
}

void RecoveryDialog::updateButtons()
{
  recover_->setEnabled(list_->currentRow() >= 0);
  discard_->setEnabled(list_->currentRow() >= 0);
}

}  // namespace holdfast
