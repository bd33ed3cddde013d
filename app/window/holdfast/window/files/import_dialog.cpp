#include "holdfast/window/files/import_dialog.h"

#include <QAbstractTableModel>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QProgressBar>
#include <QSortFilterProxyModel>
#include <utility>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/document/point_lists.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// About a hundredth of the diagonal of the model's box: farther points are likely to be in another unit.
double usualTolerance(const Model& model)
{
  return QString::number(0.01 * model.solverMesh.diagonal, 'g', 2).toDouble();
}

/// The constraints of a file, and what they would be in a document.
struct ImportContents {
  ConstraintList list;
  ImportPreview preview;
  std::vector<std::string> newNames;  ///< one for each constraint of the list: what the document will call it
};

ImportContents readImport(const std::filesystem::path& path, const ConstraintList& present, const Model& model)
{
  ImportContents contents;
  contents.list = readConstraints(path);
  contents.preview = previewImport(contents.list, present, model);
  const ConstraintList all = pasted(present, contents.list);
  for (std::size_t k = present.constraints.size(); k < all.constraints.size(); ++k)
    contents.newNames.push_back(all.constraints[k].name);
  return contents;
}

/// One row for each constraint of the file, in its order.
class ImportTable : public QAbstractTableModel {
 public:
  enum Column { Name, Kind, Place, Goal, Distance, Where };

  /// What rows are sorted by: numbers of distances, texts of the others.
  static constexpr int kSortRole = Qt::UserRole;

  [[nodiscard]] const ImportContents& contents() const { return contents_; }

  void setContents(ImportContents contents, double tolerance)
  {
    beginResetModel();
    contents_ = std::move(contents);
    points_.assign(contents_.list.constraints.size(), nullptr);
    for (const ImportedPoint& point : contents_.preview.points) points_[point.index] = &point;
    isTicked_.resize(points_.size());
    tickNear(tolerance);
    endResetModel();
  }

  /// Ticks and unticks by the distance alone: what the user has ticked before is forgotten.
  void setTolerance(double tolerance)
  {
    tickNear(tolerance);
    reportChange();
  }

  void tickAll(bool isTicked)
  {
    isTicked_.assign(isTicked_.size(), isTicked);
    reportChange();
  }

  [[nodiscard]] std::vector<Index> tickedRows() const
  {
    std::vector<Index> rows;
    for (std::size_t row = 0; row < isTicked_.size(); ++row)
      if (isTicked_[row]) rows.push_back(static_cast<Index>(row));
    return rows;
  }

  [[nodiscard]] Index farPoints() const
  {
    Index count = 0;
    for (int row = 0; row < rowCount(); ++row) count += isFar(row) ? 1 : 0;
    return count;
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
  {
    return parent.isValid() ? 0 : static_cast<int>(points_.size());
  }

  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override
  {
    return parent.isValid() ? 0 : Where + 1;
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
  {
    if (!index.isValid()) return {};
    const int row = index.row();
    const int column = index.column();
    if (role == Qt::DisplayRole) return text(row, column);
    if (role == Qt::ToolTipRole) return toolTip(row, column);
    if (role == Qt::CheckStateRole && column == Name) return isTicked_[row] ? Qt::Checked : Qt::Unchecked;
    if (role == Qt::ForegroundRole && isFar(row))
      return statusColor(ConstraintStatus::Conflicting, QGuiApplication::palette());
    if (role != kSortRole) return {};
    if (column != Distance) return text(row, column);
    return points_[row] == nullptr ? -1.0 : points_[row]->distance;
  }

  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override
  {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
      return QAbstractTableModel::headerData(section, orientation, role);
    return QStringList{
        tr("Name"), tr("Kind"), tr("Place"), tr("Target"), tr("Distance"), tr("On the surface")}[section];
  }

  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override
  {
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == Name ? usual | Qt::ItemIsUserCheckable : usual;
  }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override
  {
    if (!index.isValid() || role != Qt::CheckStateRole || index.column() != Name) return false;
    isTicked_[index.row()] = value.toInt() == Qt::Checked;
    Q_EMIT dataChanged(index, index, {role});
    return true;
  }

 private:
  [[nodiscard]] const Constraint& constraint(int row) const { return contents_.list.constraints[row]; }

  [[nodiscard]] bool isFar(int row) const { return points_[row] != nullptr && points_[row]->distance > tolerance_; }

  void tickNear(double tolerance)
  {
    tolerance_ = tolerance;
    for (int row = 0; row < rowCount(); ++row) isTicked_[row] = !isFar(row);
  }

  void reportChange()
  {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Where));
  }

  [[nodiscard]] QString text(int row, int column, bool isExact = false) const
  {
    const ImportedPoint* point = points_[row];
    const auto number = [&](const auto& value) { return isExact ? exactText(value) : roundedText(value); };
    switch (column) {
      case Name: {
        const QString name = nameText(constraint(row).name);
        const std::string& newName = contents_.newNames[row];
        return constraint(row).name == newName ? name : tr("%1 → %2").arg(name, nameText(newName));
      }
      case Kind:
        return kindText(constraint(row));
      case Place:
        return point == nullptr ? QString() : number(point->place);
      case Goal:
        return point == nullptr ? QString()
                                : number(placeOf(std::get<PointConstraint>(constraint(row).what), point->place));
      case Distance:
        return point == nullptr ? QString() : number(point->distance);
      default:
        return point == nullptr ? whereText(constraint(row)) : locationText(point->at);
    }
  }

  [[nodiscard]] QString toolTip(int row, int column) const
  {
    const QString exact = text(row, column, true);
    if (column == Distance && isFar(row))
      return tr("%1: farther from the surface than the tolerance. The point may be in another unit or coordinate "
                "system.")
          .arg(exact);
    if (column == Name && constraint(row).name != contents_.newNames[row])
      return tr("The name is taken: the constraint will be called “%1”.").arg(nameText(contents_.newNames[row]));
    return exact;
  }

  ImportContents contents_;
  std::vector<const ImportedPoint*> points_;  // of the rows; null for what is no `near` point
  std::vector<bool> isTicked_;
  double tolerance_ = 0;
};

class ImportDialog : public QDialog {
 public:
  ImportDialog(Editor& editor, const std::filesystem::path& path, QWidget* parent)
      : QDialog(parent), editor_(editor), file_(textOf(path.filename()))
  {
    setObjectName("importDialog");
    setWindowTitle(tr("Import %1").arg(file_));
    summary_ = newText("summary");
    summary_->setText(tr("Looking for the places on the surface…"));
    auto* busy = new QProgressBar;
    busy->setRange(0, 0);
    busy->setTextVisible(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(summary_);
    layout->addWidget(busy);
    layout->addLayout(newToleranceRow());
    layout->addWidget(newTable(), 1);
    layout->addWidget(newButtons());
    table_->setFocus();
    resize(fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 30);
    connect(&model_, &QAbstractItemModel::dataChanged, this, &ImportDialog::updateTexts);
    connect(&model_, &QAbstractItemModel::modelReset, this, &ImportDialog::updateTexts);
    connect(&job_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
      showProblem(this, tr("“%1” cannot be imported.").arg(file_), error);
      reject();
    });
    connect(this, &QDialog::finished, &job_, &BackgroundJob::cancel);
    job_.start([this, path, busy, model = editor_.model(), state = editor_.history().state()](Progress& progress) {
      progress.step("reading");
      auto contents = std::make_shared<ImportContents>(readImport(path, state->list, *model));
      return [this, busy, contents] {
        busy->hide();
        model_.setContents(std::move(*contents), tolerance_->typed().value_or(usualTolerance(*editor_.model())));
        table_->resizeColumnsToContents();
      };
    });
  }

  void accept() override
  {
    const std::vector<Index> rows = model_.tickedRows();
    if (rows.empty()) return;
    ConstraintList imported = extracted(model_.contents().list, rows);
    for (std::size_t k = 0; k < rows.size(); ++k) imported.constraints[k].name = model_.contents().newNames[rows[k]];
    editor_.edit(editName(rows.size()), pasted(editor_.list(), std::move(imported)));
    QDialog::accept();
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override
  {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    // Enter ends the tolerance, not the dialog.
    if (isEnter && focusWidget() == tolerance_) return event->accept();
    QDialog::keyPressEvent(event);
  }

 private:
  QLayout* newToleranceRow()
  {
    tolerance_ = named(new NumberEdit, "tolerance", tr("Tolerance of the distance from the surface"));
    tolerance_->setNumber(usualTolerance(*editor_.model()));
    connect(tolerance_, &NumberEdit::entered, &model_, &ImportTable::setTolerance);
    connect(tolerance_, &NumberEdit::refused, summary_, &QLabel::setText);
    auto* before = new QLabel(tr("&Leave out points farther than"));
    before->setBuddy(tolerance_);
    const QString units = QString::fromStdString(editor_.list().units);
    auto* row = new QHBoxLayout;
    row->addWidget(before);
    row->addWidget(tolerance_);
    row->addWidget(new QLabel(units.isEmpty() ? tr("from the surface") : tr("%1 from the surface").arg(units)));
    row->addStretch(1);
    return row;
  }

  QWidget* newTable()
  {
    auto* sorted = new QSortFilterProxyModel(this);
    sorted->setSourceModel(&model_);
    sorted->setSortRole(ImportTable::kSortRole);
    table_ = named(new QTableView, "preview", tr("Constraints of the file"));
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
    return table_;
  }

  QWidget* newButtons()
  {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    import_ = named(buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole), "import");
    import_->setDefault(true);
    import_->setEnabled(false);
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    for (const auto& [text, name, isTicked] :
         {std::tuple(tr("Tick &all"), "tickAll", true), {tr("Tick &none"), "tickNone", false}}) {
      QPushButton* button = named(buttons->addButton(text, QDialogButtonBox::ResetRole), name);
      button->setAutoDefault(false);
      connect(button, &QPushButton::clicked, this, [this, isTicked = isTicked] { model_.tickAll(isTicked); });
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
  }

  [[nodiscard]] QString summary() const
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

  void updateTexts()
  {
    const std::size_t count = model_.tickedRows().size();
    summary_->setText(summary());
    import_->setEnabled(count > 0);
    import_->setText(tr("&Import %1").arg(count));
  }

  [[nodiscard]] QString editName(std::size_t count) const
  {
    const bool arePoints = model_.contents().preview.others == 0;
    if (count == 1) return (arePoints ? tr("import a point from %1") : tr("import a constraint from %1")).arg(file_);
    return (arePoints ? tr("import %1 points from %2") : tr("import %1 constraints from %2")).arg(count).arg(file_);
  }

  Editor& editor_;
  QString file_;
  ImportTable model_;
  QLabel* summary_ = nullptr;
  NumberEdit* tolerance_ = nullptr;
  QTableView* table_ = nullptr;
  QPushButton* import_ = nullptr;
  BackgroundJob job_;
};

}  // namespace

QDialog* newImportDialog(Editor& editor, const std::filesystem::path& path, QWidget* parent)
{
  return new ImportDialog(editor, path, parent);
}

}  // namespace holdfast
