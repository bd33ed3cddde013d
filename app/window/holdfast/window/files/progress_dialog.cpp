#include "holdfast/window/files/progress_dialog.h"

#include <QEvent>
#include <QPointer>
#include <QProgressDialog>
#include <QTimer>
#include <algorithm>

#include <holdfast/window/controls/open_dialog.h>

namespace holdfast {
namespace {

/// One at a time is seen: that of the job that has run longest.
class ProgressDialog final : public QProgressDialog {
 public:
  ProgressDialog(BackgroundJob& job, QWidget* window, const QString& title)
      : QProgressDialog({}, QObject::tr("Cancel"), 0, 0, window), job_(&job)
  {
    setObjectName("progress");
    setWindowTitle(title);
    setWindowModality(Qt::NonModal);
    // Work goes on meanwhile: keys stay where they are typed.
    setAttribute(Qt::WA_ShowWithoutActivating);
    setMinimumWidth(fontMetrics().averageCharWidth() * 50);
    // Ends Qt's own delay, after which the dialog would come up over any other.
    reset();
    window->installEventFilter(this);
    connect(&job, &BackgroundJob::stepChanged, this, &QProgressDialog::setLabelText);
    connect(&job, &BackgroundJob::ended, this, &ProgressDialog::end);
    connect(this, &QProgressDialog::canceled, &job, &BackgroundJob::cancel);
    delay_.setSingleShot(true);
    connect(&delay_, &QTimer::timeout, this, [this] {
      isDue_ = true;
      showOrHide();
    });
    delay_.start(kMillisecondsWithoutProgress);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::WindowBlocked || event->type() == QEvent::WindowUnblocked) showOrHide();
    return QProgressDialog::eventFilter(watched, event);
  }

 private:
  void showOrHide() { setVisible(isDue_ && isWorking() && !isDialogOpen() && !isAnotherSeen()); }

  /// A message about the end may be shown before this dialog hears of it.
  [[nodiscard]] bool isWorking() const { return job_ != nullptr && job_->isRunning(); }

  [[nodiscard]] QList<QProgressDialog*> allOfWindow() const
  {
    return parent()->findChildren<QProgressDialog*>(objectName(), Qt::FindDirectChildrenOnly);
  }
  [[nodiscard]] bool isAnotherSeen() const
  {
    const auto all = allOfWindow();
    return std::any_of(all.begin(), all.end(),
                       [this](const QProgressDialog* other) { return other != this && other->isVisible(); });
  }

  /// The dialog may be the sender: its Cancel is what ends the work. It is deleted when the loop of events comes back
  /// to where it was shown; until then, perhaps during a message, it must not come up again.
  void end()
  {
    delay_.stop();
    isDue_ = false;
    reset();
    parent()->removeEventFilter(this);
    deleteLater();
    for (QProgressDialog* other : allOfWindow())
      if (other != this) static_cast<ProgressDialog*>(other)->showOrHide();
  }

  QPointer<BackgroundJob> job_;
  QTimer delay_;
  bool isDue_ = false;
};

}  // namespace

void showProgress(BackgroundJob& job, QWidget* window, const QString& title)
{
  new ProgressDialog(job, window, title);
}

}  // namespace holdfast
