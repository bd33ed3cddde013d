#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <clocale>

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>

/// Windows need an application, one in a program. Settings and state go to places of the tests' own.
int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("holdfast-tests");
  // Qt takes the user's locale for the whole program; numbers of tests are written with points.
  std::setlocale(LC_NUMERIC, "C");
  return RUN_ALL_TESTS();
}
