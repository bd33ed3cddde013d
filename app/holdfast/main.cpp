// holdfast: the window.

#include <QApplication>
#include <QMessageBox>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QScreen>
#include <QSurfaceFormat>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <QVTKOpenGLNativeWidget.h>

#include <holdfast/memory/large_memory.h>
#include <holdfast/threads/thread_priority.h>
#include <holdfast/version.h>
#include <holdfast/widgets/scene/display_check.h>
#include <holdfast/window/window/main_window.h>

namespace holdfast {
namespace {

// The codes are those of holdfast-batch.
constexpr int kUsage = 2;
constexpr int kNoDisplay = 3;

// VTK needs this version.
constexpr QPair<int, int> kLeastOpenGl(3, 2);

/// Reports what no code has caught, a mistake of ours or of the machine; the document is still there.
class Application : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override
  {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      QMessageBox::critical(
          activeWindow(), tr("Holdfast"),
          tr("Something went wrong that should not have: %1\n\nYour document is still open. Please save it under "
             "another name and report this.")
              .arg(QString::fromUtf8(error.what())));
      return true;
    }
  }
};

/// Ends the process where Qt finds nothing to draw on.
bool hasOpenGl(int argc, char** argv)
{
  const QGuiApplication application(argc, argv);
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  return context.create() && context.makeCurrent(&surface) && context.format().version() >= kLeastOpenGl;
}

/// Tells whether Qt can draw as it is asked to, or on a Wayland compositor that it does not look for by itself.
bool findOpenGl(int argc, char** argv)
{
  const auto isThere = [&] { return succeedsInChild([&] { return hasOpenGl(argc, argv); }); };
  if (isThere()) return true;
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) return false;
  qputenv("QT_QPA_PLATFORM", "wayland");
  return isThere();
}

std::string valueOf(const char* variable)
{
  const char* const value = std::getenv(variable);
  return std::string(variable) + (value == nullptr ? " is not set" : " is \"" + std::string(value) + '"');
}

int refuseToStart()
{
  std::fprintf(
      stderr,
      "holdfast: the window needs an X server or a Wayland compositor with OpenGL %d.%d, and Qt finds none: %s, "
      "%s. Set one of them, or run under xvfb-run\nholdfast: holdfast-batch works without a window.\n",
      kLeastOpenGl.first, kLeastOpenGl.second, valueOf("DISPLAY").c_str(), valueOf("WAYLAND_DISPLAY").c_str());
  return kNoDisplay;
}

int run(int argc, char** argv)
{
  letOthersComputeInBackground();
  keepFreedMemory();
  std::string file;
  CLI::App app("Deforms triangle meshes under exact positional constraints.", "holdfast");
  app.set_version_flag("--version", "holdfast " HOLDFAST_VERSION);
  app.add_option("FILE", file, "a mesh (.obj, .ply, .off, .stl, .vtp) or a session (.holdfast)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  if (!findOpenGl(argc, argv)) return refuseToStart();
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  Application application(argc, argv);
  QApplication::setApplicationName("holdfast");
  QApplication::setOrganizationName("holdfast");
  QApplication::setApplicationVersion(HOLDFAST_VERSION);
  // Qt takes the user's locale for the whole program; numbers in files are written with points.
  std::setlocale(LC_NUMERIC, "C");

  MainWindow window;
  window.resize(window.screen()->availableSize().boundedTo({1600, 1000}) * 0.95);
  window.remember();
  window.warmUp();
  window.show();
  if (!file.empty()) QTimer::singleShot(0, &window, [&] { window.files().open(QString::fromStdString(file)); });
  return QApplication::exec();
}

}  // namespace
}  // namespace holdfast

int main(int argc, char** argv)
{
  return holdfast::run(argc, argv);
}
