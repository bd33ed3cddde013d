#pragma once
/// Shows what a job does in a small dialog of its own.

#include <QString>
#include <QWidget>

#include <holdfast/window/model/background_job.h>

namespace holdfast {

/// A job that is done sooner needs no dialog, which would only flash.
inline constexpr int kMillisecondsWithoutProgress = 300;

/// Shows the steps of `job`, which runs, once it takes longer than a moment. The small dialog can cancel the job. It
/// closes when the job ends, before anything is said of that. It hides while another dialog of `window` is open.
void showProgress(BackgroundJob& job, QWidget* window, const QString& title);

}  // namespace holdfast
