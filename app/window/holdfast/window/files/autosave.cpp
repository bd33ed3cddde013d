#include "holdfast/window/files/autosave.h"

#include <QWidget>
#include <utility>

#include <holdfast/window/files/recovery_dialog.h>

namespace holdfast {

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

Autosave::~Autosave() = default;

void Autosave::changed()
{
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
  auto* dialog = new RecoveryDialog(std::move(copies), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RecoveryDialog::recoverWanted, this, &Autosave::recover);
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
