#pragma once
/// \file
/// The application of a program that opens windows: one in a program.

#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>
#include <memory>

#include <QVTKOpenGLNativeWidget.h>

#include <holdfast/memory/large_memory.h>
#include <holdfast/threads/thread_priority.h>

namespace holdfast::test {

/// Settings and copies of unsaved work go to places of its own, not to the user's.
class IsolatedApplication {
 public:
  IsolatedApplication(int& argc, char** argv, const QString& name)
  {
    letOthersComputeInBackground();  // this and the next as the window does
    keepFreedMemory();
    qputenv("XDG_STATE_HOME", home_.filePath("state").toUtf8());
    qputenv("XDG_CONFIG_HOME", home_.filePath("config").toUtf8());
    QStandardPaths::setTestModeEnabled(true);
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
    application_ = std::make_unique<QApplication>(argc, argv);
    QApplication::setApplicationName(name);
    // Qt takes the user's locale for the whole program; numbers are written with points.
    std::setlocale(LC_NUMERIC, "C");
  }

 private:
  QTemporaryDir home_;
  std::unique_ptr<QApplication> application_;
};

}  // namespace holdfast::test
