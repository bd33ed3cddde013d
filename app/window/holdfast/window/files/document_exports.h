#pragma once
/// Writes what goes out of the open document besides sessions: meshes, fields, reports, constraints and pictures.

#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QSize>
#include <QWidget>
#include <functional>
#include <optional>
#include <string>

#include <holdfast/document/session_file.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/scene/scene_contents.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Says how a picture shows the document. By default it shows it as `Scene` does.
struct PictureView {
  std::optional<Camera> camera;
  std::optional<Coloring> coloring;                  ///< none: one colour
  std::function<void(SceneContents&)> arrange = {};  ///< switches other parts on or off; may be empty
  /// Paints the legend into this area as the window does; may be empty.
  std::function<void(QPainter&, const QRectF&)> paintLegend = {};
  QSize size = {640, 480};  ///< of the view in the window, in its own pixels
  double pixelRatio = 1;    ///< of the screen's pixels to these
};

/// Writes what is shown. It asks before if that is older than the constraints, or if a file loses precision. Files are
/// complete or absent. A box over `window` reports failures. Exports need an open document.
class DocumentExports : public QObject {
  Q_OBJECT

 public:
  DocumentExports(Editor& editor, QWidget* window) : QObject(window), editor_(editor), window_(window)
  {
    connect(&job_, &BackgroundJob::failed, this, &DocumentExports::showFailure);
  }

  void setChooser(FileChooser chooser) { chooser_ = std::move(chooser); }
  void setPictureView(std::function<PictureView()> view) { pictureView_ = std::move(view); }

  void exportMesh();
  void exportFields();
  void exportReport();
  void exportConstraints();
  void exportPicture();
  /// Writes the picture as it is in the window, without asking for a name. The file is beside the mesh or in the folder
  /// of the last export. Its name is the first of NAME.1.png, NAME.2.png ... that is not there.
  void savePicture();
  /// Puts the picture as it is in the window into the clipboard.
  void copyPicture();
  [[nodiscard]] bool isWriting() const noexcept { return job_.isRunning(); }

 Q_SIGNALS:
  /// An export is done. `what` is for the status line: "wrote bracket.ply".
  void done(const QString& what);

 private:
  struct Made {
    Serialized contents;
    double missedBy = 0;  // model units: by how much a reader misses constraints; 0 within the promise
  };
  using Maker = std::function<Made(const std::string& path, Progress& progress)>;

  [[nodiscard]] bool mayExportShown();
  [[nodiscard]] QString suggested(const QString& ending) const;
  [[nodiscard]] QString ask(const QString& title, const QString& ending, const QStringList& filters);
  void make(const QString& title, const QString& ending, const QStringList& filters, Maker maker);
  [[nodiscard]] bool mayMiss(double length);
  void writePicture(const QString& path, const std::function<QImage()>& draw);
  void write(Serialized contents);
  void showFailure(const std::exception_ptr& error);
  [[nodiscard]] QString name() const { return QFileInfo(writing_).fileName(); }

  Editor& editor_;
  QWidget* window_;
  FileChooser chooser_ = chooseFile;
  std::function<PictureView()> pictureView_ = [] { return PictureView{}; };
  BackgroundJob job_;
  QString writing_;  // the latest file
};

}  // namespace holdfast
