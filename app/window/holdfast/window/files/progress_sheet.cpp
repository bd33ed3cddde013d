#include "holdfast/window/files/progress_sheet.h"

#include <QProgressDialog>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/background_job.h>

namespace holdfast {
namespace {

// What is done sooner needs no dialog, which would only flash.
constexpr int kMomentMilliseconds = 300;

}  // namespace

ProgressSheet::ProgressSheet(BackgroundJob& job, QWidget* window) : job_(job), window_(window)
{
  delay_.setSingleShot(true);
  delay_.setInterval(kMomentMilliseconds);
  connect(&delay_, &QTimer::timeout, this, &ProgressSheet::show);
  connect(&job, &BackgroundJob::started, this, [this] {
    step_.clear();
    delay_.start();
  });
  connect(&job, &BackgroundJob::stepChanged, this, [this](const QString& step) {
    step_ = step;
    if (dialog_) dialog_->setLabelText(step);
  });
  connect(&job, &BackgroundJob::ended, this, [this] {
    delay_.stop();
    // The dialog may be the sender: its Cancel is what ended the work.
    if (dialog_) dialog_->deleteLater();
    dialog_.clear();
  });
}

ProgressSheet::~ProgressSheet()
{
  delete dialog_;
}

void ProgressSheet::show()
{
  dialog_ = named(new QProgressDialog(step_, tr("Cancel"), 0, 0, window_), "progress");
  dialog_->setWindowTitle(title_);
  dialog_->setWindowModality(Qt::NonModal);
  dialog_->setMinimumWidth(dialog_->fontMetrics().averageCharWidth() * 50);
  connect(dialog_.data(), &QProgressDialog::canceled, &job_, &BackgroundJob::cancel);
  dialog_->show();
}

}  // namespace holdfast
