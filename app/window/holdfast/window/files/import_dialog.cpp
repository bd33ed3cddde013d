#include "holdfast/window/files/import_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include <holdfast/base/error.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr double kUsualShareOfDiagonal = 0.01;

}  // namespace

double usualImportTolerance(const Model& model)
{
  return QString::number(kUsualShareOfDiagonal * model.solverMesh.diagonal, 'g', 2).toDouble();
}

ImportDialog::ImportDialog(Editor& editor, std::filesystem::path path, QWidget* parent)
    : QDialog(parent),
      editor_(editor),
      path_(std::move(path)),
      summary_(new QLabel(tr("Looking for the places on the surface…"))),
      busy_(new QProgressBar),
      tolerance_(new NumberEdit),
      table_(new QTableView)
{
  setObjectName("importDialog");
  setWindowTitle(tr("Import %1").arg(textOf(path_.filename())));
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  makeTable();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(summary_);
  layout->addWidget(busy_);
  layout->addWidget(makeToleranceRow());
  layout->addWidget(table_, 1);
  layout->addWidget(makeButtons());
  table_->setFocus();
  resize(fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 30);
  connect(&model_, &ImportTableModel::ticksChanged, this, &ImportDialog::updateTexts);
  connect(&job_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
    showProblem(this, tr("“%1” cannot be imported.").arg(textOf(path_.filename())), error);
    reject();
  });
  connect(this, &QDialog::finished, &job_, &BackgroundJob::cancel);
  job_.start([this, path = path_, model = editor_.model(), state = editor_.history().state()](Progress& progress) {
    progress.step("reading");
    auto contents = std::make_shared<ImportContents>(readImport(path, state->list, *model));
    return [this, contents] { show(std::move(*contents)); };
  });
}

QWidget* ImportDialog::makeToleranceRow()
{
  tolerance_->setObjectName("tolerance");
  tolerance_->setAccessibleName(tr("Tolerance of the distance from the surface"));
  tolerance_->setNumber(usualImportTolerance(*editor_.model()));
  connect(tolerance_, &NumberEdit::entered, this, [this](double tolerance) {
    tolerance_->setNumber(tolerance);
    model_.setTolerance(tolerance);
  });
  connect(tolerance_, &NumberEdit::refused, summary_, &QLabel::setText);
  auto* before = new QLabel(tr("&Leave out points farther than"));
  before->setBuddy(tolerance_);
  const QString units = QString::fromStdString(editor_.list().units);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(before);
  layout->addWidget(tolerance_);
  layout->addWidget(new QLabel(units.isEmpty() ? tr("from the surface") : tr("%1 from the surface").arg(units)));
  layout->addStretch(1);
  return row;
}

void ImportDialog::makeTable()
{
  auto* sorted = new QSortFilterProxyModel(this);
  sorted->setSourceModel(&model_);
  sorted->setSortRole(ImportTableModel::kSortRole);
  table_->setObjectName("preview");
  table_->setAccessibleName(tr("Constraints of the file"));
  table_->setModel(sorted);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  setTableLook(*table_);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  // For visible rows only: there may be a hundred thousand.
  table_->horizontalHeader()->setResizeContentsPrecision(100);
  table_->setSortingEnabled(true);
  table_->sortByColumn(-1, Qt::AscendingOrder);
}

QWidget* ImportDialog::makeButtons()
{
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  import_ = named(buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole), "import");
  import_->setDefault(true);
  import_->setEnabled(false);
  buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
  const auto add = [&](const QString& text, const char* name, const auto& run) {
    QPushButton* button = named(buttons->addButton(text, QDialogButtonBox::ResetRole), name);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, run);
  };
  add(tr("Tick &all"), "tickAll", [this] { model_.tickAll(Qt::Checked); });
  add(tr("Tick &none"), "tickNone", [this] { model_.tickAll(Qt::Unchecked); });
  connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return buttons;
}

void ImportDialog::show(ImportContents contents)
{
  busy_->hide();
  model_.setContents(std::move(contents), tolerance_->typed().value_or(usualImportTolerance(*editor_.model())));
  table_->resizeColumnsToContents();
}

QString ImportDialog::summary() const
{
  const ImportPreview& preview = model_.contents().preview;
  const std::string& units = editor_.list().units.empty() ? model_.contents().list.units : editor_.list().units;
  QStringList parts;
  const auto add = [&](Index count, const QString& one, const QString& several) {
    if (count > 0) parts << (count == 1 ? one : several.arg(count));
  };
  const QString reach = tr(", %1 from the surface at most and %2 on average.")
                            .arg(lengthText(preview.maxDistance, units), lengthText(preview.meanDistance, units));
  add(static_cast<Index>(preview.points.size()), tr("One point") + reach, tr("%1 points") + reach);
  add(model_.farPoints(), tr("One lies farther away than below: is it in another unit or coordinate system?"),
      tr("%1 lie farther away than below: are they in another unit or coordinate system?"));
  add(preview.others, tr("One constraint by ids or regions of the mesh."),
      tr("%1 constraints by ids or regions of the mesh."));
  add(preview.takenNames, tr("One name is taken: its constraint gets another."),
      tr("%1 names are taken: their constraints get others."));
  return parts.join(' ');
}

void ImportDialog::updateTexts()
{
  const std::size_t count = model_.tickedRows().size();
  summary_->setText(summary());
  import_->setEnabled(count > 0);
  import_->setText(tr("&Import %1").arg(count));
}

QString ImportDialog::editName(std::size_t count) const
{
  const auto& contents = model_.contents();
  const bool arePoints = contents.preview.others == 0;
  const QString file = textOf(path_.filename());
  if (count == 1) return (arePoints ? tr("import a point from %1") : tr("import a constraint from %1")).arg(file);
  return (arePoints ? tr("import %1 points from %2") : tr("import %1 constraints from %2")).arg(count).arg(file);
}

void ImportDialog::accept()
{
  const std::vector<Index> rows = model_.tickedRows();
  if (rows.empty()) return;
  editor_.edit(editName(rows.size()), withImported(editor_.list(), model_.contents(), rows));
  QDialog::accept();
}

void ImportDialog::keyPressEvent(QKeyEvent* event)
{
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  // Enter ends the tolerance, not the dialog.
  if (isEnter && focusWidget() == tolerance_) return event->accept();
  QDialog::keyPressEvent(event);
}

void importConstraints(Editor& editor, QWidget* window, const FileChooser& chooser)
{
  const QString folder = QFileInfo(textOf(editor.mesh().path)).path();
  const QString path =
      chooser(window, {FileQuestion::Purpose::Read,
                       ImportDialog::tr("Import constraints"),
                       folder,
                       {ImportDialog::tr("Constraints and points (*.json *.csv *.holdfast)"),
                        ImportDialog::tr("Constraints (*.json)"), ImportDialog::tr("Points (*.csv)")}});
  if (path.isEmpty()) return;
  auto* dialog = new ImportDialog(editor, path.toStdString(), window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace holdfast
