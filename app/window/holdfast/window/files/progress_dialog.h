#pragma once
/// What a job does, in a small dialog of its own.

#include <QString>
#include <QWidget>

#include <holdfast/window/model/background_job.h>

namespace holdfast {

/// What is done sooner needs no dialog, which would only flash.
inline constexpr int kMillisecondsWithoutProgress = 300;

/// The steps of `job`, which runs, in a small dialog that can cancel it, once it takes longer than a moment. It goes
/// with the job's end, before anything is said of that, and hides while another dialog of `window` is open.
void showProgress(BackgroundJob& job, QWidget* window, const QString& title);

}  // namespace holdfast
