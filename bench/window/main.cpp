// How long the window takes to answer. Needs a display: tests/support/with_display.sh.
//   holdfast_window_bench [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]
// MESH: as in holdfast_bench.

#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>
#include <exception>
#include <iostream>

#include <QVTKOpenGLNativeWidget.h>

#include <holdfast/base/thread_priority.h>

#include "bench/run_benchmarks.h"
#include "bench/window/benchmarks.h"

int main(int argc, char** argv)
try {
  using namespace holdfast;
  letOthersComputeInBackground();
  // Settings and copies of unsaved work are not the user's.
  const QTemporaryDir home;
  qputenv("XDG_STATE_HOME", home.filePath("state").toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("holdfast-bench");
  std::setlocale(LC_NUMERIC, "C");
  return bench::runBenchmarks({{"drag in the window", bench::dragInTheWindow, {"35", "173"}}}, argc, argv);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
