#include "holdfast/window/files/document_exports.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/base/lower_case.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>
#include <holdfast/widgets/scene/scene.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

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

/// The size of an exported picture, and whether it has a legend; remembers the last answer in the user's settings.
std::optional<SceneOptions> askForPicture(QWidget* window)
{
  QSettings settings;
  QDialog dialog(window);
  dialog.setObjectName("pictureDialog");
  dialog.setWindowTitle(QObject::tr("Export a picture"));
  auto* form = new QFormLayout;
  const auto addSide = [&](const QString& title, const QString& name, int usual) {
    auto* box = named(new QSpinBox, name);
    box->setRange(kLeastPictureSide, kLargestPictureSide);
    box->setValue(settings.value("picture/" + name, usual).toInt());
    box->setSingleStep(10);
    box->setAccelerated(true);
    box->setSuffix(QObject::tr(" px"));
    form->addRow(title, box);
    return box;
  };
  QSpinBox* width = addSide(QObject::tr("&Width"), "width", 1920);
  QSpinBox* height = addSide(QObject::tr("&Height"), "height", 1200);
  auto* legend = named(new QCheckBox(QObject::tr("With a &legend of the colours")), "legend");
  legend->setChecked(settings.value("picture/legend", true).toBool());
  form->addRow(QString(), legend);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  named(buttons->addButton(QObject::tr("&Export…"), QDialogButtonBox::AcceptRole), "export")->setDefault(true);
  buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);

  auto* layout = new QVBoxLayout(&dialog);
  layout->setSizeConstraint(QLayout::SetFixedSize);
  layout->setSpacing(2 * layout->spacing());
  layout->addWidget(new QLabel(QObject::tr("The picture is drawn from where you look at the mesh now.")));
  layout->addLayout(form);
  layout->addWidget(buttons);
  width->setFocus();
  width->selectAll();
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  settings.setValue("picture/width", width->value());
  settings.setValue("picture/height", height->value());
  settings.setValue("picture/legend", legend->isChecked());
  SceneOptions options;
  options.size = {width->value(), height->value()};
  options.legend = legend->isChecked() ? Legend::Shown : Legend::Hidden;
  return options;
}

}  // namespace

void DocumentExports::exportMesh()
{
  if (!mayExportShown()) return;
  const QString ending = QString::fromStdString(editor_.mesh().path.extension().string());
  make(tr("Export the mesh"), ".deformed" + ending, meshFilters() << "VTK (*.vtk)",
       [document = editor_.mesh().document, model = editor_.model(), deformation = editor_.deformation()](
           const std::string& path, Progress& progress) {
         progress.step("writing the mesh");
         Made file{serializeAnyMesh(document, deformation->positions, path)};
         Report report = deformation->report;
         if (file.contents.isSinglePrecision && setRoundedResiduals(report, *deformation, model->solverMesh.weld))
           file.missedBy = report.solve.maxResidual;
         return file;
       });
}

void DocumentExports::exportFields()
{
  if (!mayExportShown()) return;
  make(tr("Export fields"), ".fields.vtp", {tr("Fields over the mesh (*.vtp)")},
       [model = editor_.model(), deformation = editor_.deformation()](const std::string& /*path*/, Progress& progress) {
         progress.step("computing fields");
         const std::vector<Field> fields = fieldsOf(*model, *deformation);
         progress.step("writing fields");
         return Made{fieldsToVtp(model->mesh, deformation->positions, fields, {})};
       });
}

void DocumentExports::exportReport()
{
  if (!mayExportShown()) return;
  make(tr("Export the report"), ".report.json", {tr("Report (*.json)"), tr("Table of the constraints (*.csv)")},
       [deformation = editor_.deformation()](const std::string& path, Progress& /*progress*/) {
         const bool isTable = lowerCase(path).ends_with(".csv");
         return Made{{isTable ? reportToCsv(deformation->report) : reportToJson(deformation->report), {}}};
       });
}

void DocumentExports::exportConstraints()
{
  make(tr("Export the constraints"), ".constraints.json", {tr("Constraints (*.json)")},
       [state = editor_.history().state()](const std::string& /*path*/, Progress& /*progress*/) {
         return Made{{constraintsToJson(state->list), {}}};
       });
}

void DocumentExports::exportPicture()
{
  if (!mayExportShown()) return;
  std::optional<SceneOptions> options = askForPicture(window_);
  if (!options) return;
  const QString path = ask(tr("Export a picture"), ".png", {tr("Pictures (*.png)")});
  if (path.isEmpty()) return;
  writing_ = path;
  const PictureView view = pictureView_();
  options->colorBy = ColorBy::None;
  options->units = editor_.deformedState()->list.units;
  options->coloring = view.coloring;
  try {
    write({pictureOf(*editor_.model(), *editor_.deformation(), *options, view, path.toStdString()), {}});
  } catch (const std::exception&) {
    showFailure(std::current_exception());
  }
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
  const QString path =
      chooser_(window_, {FileQuestion::Purpose::Write, title, inLastFolder("export", suggestion), sorted});
  rememberFolder("export", path);
  return path;
}

void DocumentExports::make(const QString& title, const QString& ending, const QStringList& filters, Maker maker)
{
  const QString path = ask(title, ending, filters);
  if (path.isEmpty()) return;
  writing_ = path;
  job_.start([this, path = path.toStdString(), maker = std::move(maker)](Progress& progress) {
    return [this, file = std::make_shared<Made>(maker(path, progress))] {
      if (mayMiss(file->missedBy)) write(std::move(file->contents));
    };
  });
  showProgress(job_, window_, tr("Writing %1").arg(name()));
}

bool DocumentExports::mayMiss(double length)
{
  if (length == 0) return true;
  return askToGoOn(window_, tr("“%1” would not be exact.").arg(name()),
                   tr("This format stores coordinates in single precision: readers of the file find constraints missed "
                      "by up to %1. PLY, OBJ and OFF keep every digit.")
                       .arg(lengthText(length, editor_.isOpen() ? editor_.list().units : "")),
                   tr("&Export anyway"));
}

void DocumentExports::write(Serialized contents)
{
  job_.start([this, path = writing_, contents = std::move(contents)](Progress& progress) {
    progress.step("writing to the disk");
    OutputFile(path.toStdString(), contents.bytes).commit();
    return [this, notes = contents.notes] {
      Q_EMIT done(tr("wrote %1").arg(name()));
      QStringList texts;
      for (const std::string& note : notes) texts << QString::fromStdString(note);
      if (!texts.empty()) showNotes(window_, tr("“%1” is written.").arg(name()), texts);
    };
  });
  showProgress(job_, window_, tr("Writing %1").arg(name()));
}

}  // namespace holdfast
