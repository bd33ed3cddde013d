#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>
#include <string_view>

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>

#include <holdfast/base/thread_priority.h>

#include "kept_window.h"

/// Windows need an application, one in a program. Settings and state go to places of the tests' own.
int main(int argc, char** argv)
{
  holdfast::letOthersComputeInBackground();
  ::testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir home;
  qputenv("XDG_STATE_HOME", home.filePath("state").toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("holdfast-tests");
  // Qt takes the user's locale for the whole program; numbers of tests are written with points.
  std::setlocale(LC_NUMERIC, "C");
  if (argc == 3 && std::string_view(argv[1]) == holdfast::test::kWorkUntilKilled)
    return holdfast::test::workUntilKilled(argv[2]);
  return RUN_ALL_TESTS();
}
