#include "holdfast/window/files/autosave.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QListWidget>
#include <QLocale>
#include <utility>

#include <holdfast/window/controls/panel_parts.h>

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

QString originOf(const Recoverable& copy)
{
  if (!copy.original.empty()) return native(copy.original);
  if (!copy.mesh.empty()) return QObject::tr("never saved; of the mesh %1").arg(native(copy.mesh));
  return QObject::tr("cannot be read: %1").arg(native(copy.path));
}

class RecoveryDialog : public QDialog {
 public:
  RecoveryDialog(std::vector<Recoverable> copies, std::function<void(const Recoverable&)> open, QWidget* parent)
      : QDialog(parent), copies_(std::move(copies)), open_(std::move(open))
  {
    setObjectName("recoveryDialog");
    setWindowTitle(tr("Recover unsaved work"));
    auto* text = new QLabel(tr(
        "Holdfast ended before this work was saved. Recovered work opens as it was; the original files are not touched "
        "until you save."));
    text->setWordWrap(true);
    list_ = named(new QListWidget, "copies", tr("Unsaved work"));
    list_->setAlternatingRowColors(true);
    for (const Recoverable& copy : copies_) {
      const QString of = originOf(copy);
      auto* item =
          new QListWidgetItem(tr("%1, kept %2\n%3").arg(QString::fromStdString(copy.name), timeOf(copy), of), list_);
      item->setToolTip(plainTip(of));
    }
    list_->setCurrentRow(0);

    auto* buttons = new QDialogButtonBox;
    QPushButton* recover = named(buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole), "recover");
    recover->setDefault(true);
    QPushButton* discard = named(buttons->addButton(tr("&Discard…"), QDialogButtonBox::DestructiveRole), "discard");
    QPushButton* later = named(buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole), "later");
    connect(recover, &QPushButton::clicked, this, &RecoveryDialog::recoverChosen);
    connect(discard, &QPushButton::clicked, this, &RecoveryDialog::discardChosen);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(list_, &QListWidget::itemDoubleClicked, this, &RecoveryDialog::recoverChosen);
    connect(list_, &QListWidget::currentRowChanged, this, [recover, discard](int row) {
      for (QPushButton* button : {recover, discard}) button->setEnabled(row >= 0);
    });

    auto* layout = new QVBoxLayout(this);
    for (QWidget* widget : std::initializer_list<QWidget*>{text, list_, buttons}) layout->addWidget(widget);
    resize(fontMetrics().averageCharWidth() * 80, fontMetrics().height() * 18);
    list_->setFocus();
  }

 private:
  void recoverChosen()
  {
    const int row = list_->currentRow();
    if (row < 0) return;
    accept();
    open_(copies_[row]);
  }

  void discardChosen()
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

  std::vector<Recoverable> copies_;
  std::function<void(const Recoverable&)> open_;
  QListWidget* list_ = nullptr;
};

}  // namespace

QDialog* newRecoveryDialog(std::vector<Recoverable> copies, std::function<void(const Recoverable&)> recover,
                           QWidget* parent)
{
  return new RecoveryDialog(std::move(copies), std::move(recover), parent);
}

Autosave::Autosave(Editor& editor, DocumentFiles& files, std::filesystem::path folder, QWidget* window)
    : QObject(window),
      editor_(editor),
      files_(files),
      window_(window),
      folder_(std::move(folder)),
      copy_(std::make_shared<RecoveryFile>(folder_))
{
  delay_.setSingleShot(true);
  delay_.setInterval(kAutosaveDelay);
  connect(&delay_, &QTimer::timeout, this, &Autosave::writeNow);
  connect(&editor_, &Editor::opened, this, [this] {
    recovered_.clear();
    removeCopy();
  });
  connect(&editor_, &Editor::stateChanged, this, &Autosave::changed);
  connect(&editor_, &Editor::saved, this, &Autosave::changed);
  connect(&job_, &BackgroundJob::failed, this, &Autosave::showFailure);
}

void Autosave::changed()
{
  if (!editor_.isOpen()) return;  // the document was closed while its copy was written
  if (editor_.history().isSaved()) {
    discardRecovered();
    return removeCopy();
  }
  // A further change does not start it anew: work without a rest is kept, too.
  if (!delay_.isActive()) delay_.start();
}

void Autosave::writeNow()
{
  if (!editor_.isOpen() || editor_.history().isSaved()) return;
  // One copy after the other: they share the file. A gesture ends with a change.
  if (job_.isRunning()) return delay_.start();
  if (editor_.history().isInGesture() || editor_.history().state() == kept_) return;
  const auto state = editor_.history().state();
  const std::filesystem::path original = files_.sessionPath();
  job_.start([this, copy = copy_, state, original,
              session = files_.emptySessionAt(original.empty() ? editor_.mesh().path : original)](Progress&) mutable {
    session.document = *state;
    copy->write(std::move(session), original);
    return [this, state] { written(state); };
  });
}

void Autosave::written(const std::shared_ptr<const DocumentState>& state)
{
  hasFailed_ = false;
  kept_ = state;
  if (std::exchange(isObsolete_, false)) return removeCopy(), changed();
  discardRecovered();
  Q_EMIT kept();
}

void Autosave::removeCopy()
{
  delay_.stop();
  isObsolete_ = job_.isRunning();
  if (isObsolete_) return;
  copy_->clear();
  kept_.reset();
}

void Autosave::showFailure(const std::exception_ptr& error)
{
  isObsolete_ = false;
  if (std::exchange(hasFailed_, true)) return;
  try {
    std::rethrow_exception(error);
  } catch (const std::exception& problem) {
    Q_EMIT failed(QString::fromUtf8(problem.what()));
  }
}

void Autosave::discardRecovered()
{
  for (const Recoverable& copy : recovered_) discard(copy);
  recovered_.clear();
}

void Autosave::offerRecovery()
{
  std::vector<Recoverable> copies = recoverable(folder_);
  if (copies.empty()) return;
  QDialog* dialog = newRecoveryDialog(
      std::move(copies), [this](const Recoverable& copy) { recover(copy); }, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void Autosave::recover(const Recoverable& copy)
{
  files_.recover(copy, [this, copy] {
    recovered_.push_back(copy);
    writeNow();
  });
}

}  // namespace holdfast
