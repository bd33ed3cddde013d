#include "holdfast/window/files/document_exports.h"

#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_csv.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>
#include <holdfast/widgets/scene/scene.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/files/picture_dialog.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// How far a reader of coordinates in single precision misses constraints that are met here; 0 within the promise.
double missedInSinglePrecision(const Model& model, const DeformResult& deformation)
{
  const Positions stored = deformation.positions.cast<float>().cast<double>();
  Report report = deformation.report;
  const bool isMissed = setResiduals(report, deformation.details->system, deformation.details->diagnosis,
                                     rowResiduals(deformation.details->system, model.solverMesh.weld, stored))
                            .has_value();
  return isMissed ? report.solve.maxResidual : 0;
}

std::string pictureOf(const Model& model, const DeformResult& deformation, const SceneOptions& options,
                      const PictureView& view, const std::string& name)
{
  Scene scene(model, deformation, options);
  if (view.arrange) view.arrange(scene.contents());
  if (view.camera) {
    place(*scene.meshRenderer().GetActiveCamera(), *view.camera);
    scene.meshRenderer().ResetCameraClippingRange();
  }
  return toPng(draw(scene, name), name);
}

}  // namespace

DocumentExports::DocumentExports(Editor& editor, QWidget* window)
    : QObject(window), editor_(editor), window_(window), sheet_(job_, window)
{
  connect(&job_, &BackgroundJob::failed, this,
          [this](const std::exception_ptr& error) { showFailure(writing_, error); });
}

DocumentExports::~DocumentExports() = default;

void DocumentExports::exportMesh()
{
  if (!mayExportShown()) return;
  const QString ending = QString::fromStdString(editor_.mesh().path.extension().string());
  const QString path = ask(tr("Export the mesh"), ".deformed" + ending, meshFilters() << "VTK (*.vtk)");
  if (path.isEmpty()) return;
  make(path, [path, document = editor_.mesh().document, model = editor_.model(),
              deformation = editor_.deformation()](Progress& progress) {
    progress.step("writing the mesh");
    Made file{serializeAnyMesh(document, deformation->positions, path.toStdString())};
    if (file.contents.isSinglePrecision) file.missedBy = missedInSinglePrecision(*model, *deformation);
    return file;
  });
}

void DocumentExports::exportFields()
{
  if (!mayExportShown()) return;
  const QString path = ask(tr("Export fields"), ".fields.vtp", {tr("Fields over the mesh (*.vtp)")});
  if (path.isEmpty()) return;
  make(path, [model = editor_.model(), deformation = editor_.deformation()](Progress& progress) {
    progress.step("computing fields");
    const std::vector<Field> fields = fieldsOf(*model, *deformation);
    progress.step("writing fields");
    return Made{fieldsToVtp(model->mesh, deformation->positions, fields, {})};
  });
}

void DocumentExports::exportReport()
{
  if (!mayExportShown()) return;
  const QString path =
      ask(tr("Export the report"), ".report.json", {tr("Report (*.json)"), tr("Table of the constraints (*.csv)")});
  if (path.isEmpty()) return;
  const Report& report = editor_.deformation()->report;
  const bool isTable = path.endsWith(".csv", Qt::CaseInsensitive);
  write(path, [&] { return isTable ? reportToCsv(report) : reportToJson(report); });
}

void DocumentExports::exportConstraints()
{
  const QString path = ask(tr("Export the constraints"), ".constraints.json", {tr("Constraints (*.json)")});
  if (!path.isEmpty()) write(path, [&] { return constraintsToJson(editor_.list()); });
}

void DocumentExports::exportPicture()
{
  if (!mayExportShown()) return;
  PictureDialog dialog(window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = ask(tr("Export a picture"), ".png", {tr("Pictures (*.png)")});
  if (path.isEmpty()) return;
  const PictureView view = pictureView_();
  SceneOptions options;
  options.size = dialog.size();
  options.colorBy = ColorBy::None;
  options.legend = dialog.legend();
  options.units = editor_.deformedState()->list.units;
  options.coloring = view.coloring;
  write(path, [&] { return pictureOf(*editor_.model(), *editor_.deformation(), options, view, path.toStdString()); });
}

bool DocumentExports::mayExportShown()
{
  const auto& deformation = editor_.deformation();
  const bool isSolved = deformation != nullptr && deformation->report.solve.status != SolveStatus::Failed;
  if (editor_.solveState() == SolveState::Current && isSolved) return true;
  if (!isSolved) {
    const QString reason = deformation != nullptr ? QString::fromStdString(deformation->report.solve.message)
                           : editor_.solveState() == SolveState::Solving
                               ? tr("The constraints are being solved for the first time; wait until that is done.")
                               : editor_.error();
    showProblem(window_, tr("There is no result to export."),
                reason.isEmpty() ? tr("Solve the constraints first.") : reason);
    return false;
  }
  return askToGoOn(window_, tr("What is shown is older than the constraints."),
                   editor_.solveState() == SolveState::Solving
                       ? tr("They have changed since and are being solved. The file would hold what you see now.")
                       : tr("They have changed since and are not solved. The file would hold what you see now."),
                   tr("&Export what is shown"));
}

QString DocumentExports::ask(const QString& title, const QString& ending, const QStringList& filters)
{
  const QFileInfo mesh(QString::fromStdString(editor_.mesh().path.string()));
  const QString suggestion = mesh.path() + '/' + mesh.completeBaseName() + ending;
  QStringList sorted = filters;
  const auto own = std::find_if(sorted.begin(), sorted.end(), [&](const QString& filter) {
    return filter.contains("*." + QFileInfo(suggestion).suffix() + ')', Qt::CaseInsensitive);
  });
  if (own != sorted.end()) std::rotate(sorted.begin(), own, own + 1);
  return chooser_(window_, {FileQuestion::Purpose::Write, title, suggestion, sorted});
}

void DocumentExports::make(const QString& path, std::function<Made(Progress&)> maker)
{
  writing_ = path;
  sheet_.setTitle(tr("Writing %1").arg(QFileInfo(path).fileName()));
  job_.start([this, path, maker = std::move(maker)](Progress& progress) {
    auto file = std::make_shared<Made>(maker(progress));
    return [this, path, file] { made(path, file); };
  });
}

void DocumentExports::made(const QString& path, const std::shared_ptr<Made>& file)
{
  const QString name = QFileInfo(path).fileName();
  if (file->missedBy > 0 && !askToGoOn(window_, tr("“%1” would not be exact.").arg(name),
                                       tr("This format stores coordinates in single precision: readers of the file "
                                          "find constraints missed by up to %1 %2. PLY, OBJ and OFF keep every digit.")
                                           .arg(roundedText(file->missedBy),
                                                QString::fromStdString(editor_.isOpen() ? editor_.list().units : "")),
                                       tr("&Export all the same")))
    return;
  write(path, std::shared_ptr<const Serialized>(file, &file->contents));
}

void DocumentExports::write(const QString& path, const std::function<std::string()>& text)
{
  try {
    write(path, std::make_shared<const Serialized>(Serialized{text(), {}}));
  } catch (const std::exception&) {
    showFailure(path, std::current_exception());
  }
}

void DocumentExports::write(const QString& path, std::shared_ptr<const Serialized> contents)
{
  writing_ = path;
  job_.start([this, path, contents = std::move(contents)](Progress& progress) {
    progress.step("writing to the disk");
    OutputFile(path.toStdString(), contents->bytes).commit();
    return [this, path, notes = contents->notes] { written(path, notes); };
  });
}

void DocumentExports::written(const QString& path, const std::vector<std::string>& notes)
{
  const QString name = QFileInfo(path).fileName();
  Q_EMIT done(tr("wrote %1").arg(name));
  if (notes.empty()) return;
  QStringList texts;
  for (const std::string& note : notes) texts << QString::fromStdString(note);
  showNotes(window_, tr("“%1” is written.").arg(name), texts);
}

void DocumentExports::showFailure(const QString& path, const std::exception_ptr& error)
{
  showProblem(window_, tr("“%1” cannot be written.").arg(QFileInfo(path).fileName()), error);
}

}  // namespace holdfast
