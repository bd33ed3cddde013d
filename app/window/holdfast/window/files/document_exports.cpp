#include "holdfast/window/files/document_exports.h"

#include <QBuffer>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <filesystem>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/guide_files.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/field_file.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/scene.h>
#include <holdfast/window/controls/offscreen_window.h>
#include <holdfast/window/controls/open_dialog.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/files/progress_dialog.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/words/error.h>
#include <holdfast/words/lower_case.h>

namespace holdfast {
namespace {

struct PictureWish {
  PictureSize size;
  bool hasLegend = true;
  bool isTransparent = false;
};

/// Four bytes a pixel: what a picture on black and the same on white have in common, and how much of that covers.
QImage uncovered(const Picture& onBlack, const Picture& onWhite)
{
  QImage image(onBlack.size.width, onBlack.size.height, QImage::Format_ARGB32);
  std::size_t at = 0;
  for (int y = image.height(); y-- > 0;)
    for (int x = 0; x < image.width(); ++x, at += 3) {
      int light = 0;
      for (std::size_t c = at; c < at + 3; ++c) light = std::max(light, onWhite.pixels[c] - onBlack.pixels[c]);
      const int alpha = std::clamp(255 - light, 0, 255);
      const auto whole = [&](std::size_t c) { return alpha == 0 ? 0 : std::min(255, onBlack.pixels[c] * 255 / alpha); };
      image.setPixel(x, y, qRgba(whole(at), whole(at + 1), whole(at + 2), alpha));
    }
  return image;
}

QImage pictureOf(const Model& model, const DeformResult& deformation, const PictureWish& wish, const PictureView& view,
                 const std::string& name)
{
  SceneOptions options;
  options.size = wish.size;
  options.legend = Legend::Hidden;
  options.colorBy = ColorBy::None;
  options.coloring = view.coloring;
  options.window = newOffscreenWindow();
  Scene scene(model, deformation, options);
  if (view.arrange) view.arrange(scene.contents());
  if (view.camera) {
    place(*scene.meshRenderer().GetActiveCamera(), *view.camera);
    scene.meshRenderer().ResetCameraClippingRange();
  }
  QImage image;
  if (wish.isTransparent) {
    scene.setBackdrop({0, 0, 0});
    const Picture onBlack = draw(scene, name);
    scene.setBackdrop({1, 1, 1});
    image = uncovered(onBlack, draw(scene, name));
  } else {
    const Picture drawn = draw(scene, name);
    image =
        QImage(drawn.pixels.data(), drawn.size.width, drawn.size.height, 3 * drawn.size.width, QImage::Format_RGB888)
            .mirrored();
  }
  if (!wish.hasLegend || !view.paintLegend || image.width() < kLeastLegendWidth || image.height() < kLeastLegendHeight)
    return image;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  // Texts are as large beside the mesh as in the window.
  const double scale = std::max(0.5, image.height() / static_cast<double>(view.size.height()));
  painter.scale(scale, scale);
  view.paintLegend(painter, QRectF(0, 0, image.width() / scale, image.height() / scale));
  return image;
}

/// With as many pixels as the screen has there.
QImage pictureInWindow(const Model& model, const DeformResult& deformation, const PictureView& view,
                       const std::string& name)
{
  const QSize size = view.size * view.pixelRatio;
  return pictureOf(model, deformation, {{size.width(), size.height()}}, view, name);
}

/// How an exported picture is wanted; remembers the last answer in the user's settings.
std::optional<PictureWish> askForPicture(QWidget* window)
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
  const auto addCheck = [&](const QString& text, const QString& name, bool usual) {
    auto* box = named(new QCheckBox(text), name);
    box->setChecked(settings.value("picture/" + name, usual).toBool());
    form->addRow(QString(), box);
    return box;
  };
  QCheckBox* legend = addCheck(QObject::tr("With a &legend of the colours"), "legend", true);
  QCheckBox* transparent = addCheck(QObject::tr("&Transparent background"), "transparent", false);
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
  settings.setValue("picture/transparent", transparent->isChecked());
  return PictureWish{{width->value(), height->value()}, legend->isChecked(), transparent->isChecked()};
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
         Made file{serializeMeshFile(document, deformation->positions, path)};
         Report report = deformation->report;
         const std::optional<Positions>& stored = file.contents.stored;
         if (stored && setStoredResiduals(report, *deformation, *stored, model->solverMesh.weld))
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
       [report = editor_.report()](const std::string& path, Progress& /*progress*/) {
         const bool isTable = lowerCase(path).ends_with(".csv");
         return Made{{isTable ? reportToCsv(*report) : reportToJson(*report), {}}};
       });
}

void DocumentExports::exportConstraints()
{
  make(tr("Export the constraints"), ".constraints.json", {tr("Constraints (*.json)")},
       [state = editor_.history().state()](const std::string& path, Progress& /*progress*/) {
         const std::filesystem::path folder = std::filesystem::path(path).parent_path();
         return Made{{constraintsToJson(withGuidePathsFrom(state->list, folder)), {}}};
       });
}

void DocumentExports::exportPicture()
{
  if (!mayExportShown()) return;
  const std::optional<PictureWish> wish = askForPicture(window_);
  if (!wish) return;
  const QString path = ask(tr("Export a picture"), ".png", {tr("Pictures (*.png)")});
  if (path.isEmpty()) return;
  writePicture(path, [&] {
    return pictureOf(*editor_.model(), *editor_.deformation(), *wish, pictureView_(), path.toStdString());
  });
}

void DocumentExports::savePicture()
{
  if (!mayExportShown()) return;
  const auto numbered = [this](int number) { return suggested(QString(".%1.png").arg(number)); };
  int number = 1;
  while (QFileInfo::exists(numbered(number))) ++number;
  const QString path = numbered(number);
  writePicture(path, [&] {
    return pictureInWindow(*editor_.model(), *editor_.deformation(), pictureView_(), path.toStdString());
  });
}

void DocumentExports::writePicture(const QString& path, const std::function<QImage()>& draw)
{
  writing_ = path;
  try {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!draw().save(&buffer, "PNG"))
      throw OutputError(path.toStdString(), "Qt cannot write PNG; install its plug-ins");
    write({bytes.toStdString(), {}});
  } catch (const std::exception&) {
    showFailure(std::current_exception());
  }
}

void DocumentExports::copyPicture()
{
  if (!mayExportShown()) return;
  writing_ = tr("the picture");
  try {
    QGuiApplication::clipboard()->setImage(
        pictureInWindow(*editor_.model(), *editor_.deformation(), pictureView_(), "the picture"));
    Q_EMIT done(tr("copied the picture"));
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

QString DocumentExports::suggested(const QString& ending) const
{
  const QFileInfo mesh(textOf(editor_.mesh().path));
  return inLastFolder("export", ownFolderBeside(mesh.filePath()) + '/' + mesh.completeBaseName() + ending);
}

QString DocumentExports::ask(const QString& title, const QString& ending, const QStringList& filters)
{
  const QString suggestion = suggested(ending);
  QStringList sorted = filters;
  const auto own = std::find_if(sorted.begin(), sorted.end(), [&](const QString& filter) {
    return filter.contains("*." + QFileInfo(suggestion).suffix() + ')', Qt::CaseInsensitive);
  });
  if (own != sorted.end()) std::rotate(sorted.begin(), own, own + 1);
  QString path = chooser_(window_, {FileQuestion::Purpose::Write, title, suggestion, sorted});
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
      whenNoDialogIsOpen(*this, [this, file] {
        if (mayMiss(file->missedBy)) write(std::move(file->contents));
      });
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
                       .arg(lengthText(length, {editor_.lengthStyle().units})),
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
      if (texts.empty()) return;
      whenNoDialogIsOpen(
          *this, [this, texts, written = name()] { showNotes(window_, tr("“%1” is written.").arg(written), texts); });
    };
  });
  showProgress(job_, window_, tr("Writing %1").arg(name()));
}

void DocumentExports::showFailure(const std::exception_ptr& error)
{
  whenNoDialogIsOpen(*this, [this, error, failed = name()] {
    showProblem(window_, tr("“%1” cannot be written.").arg(failed), error);
  });
}

}  // namespace holdfast
