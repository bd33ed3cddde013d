#include "holdfast/window/files/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QProgressBar>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <array>
#include <utility>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/file_messages.h>
#include <holdfast/window/files/import_table.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// About a hundredth of the diagonal of the model's box: farther points are likely to be in another unit.
double usualTolerance(const Model& model)
{
  return QString::number(0.01 * model.solverMesh.diagonal, 'g', 2).toDouble();
}

// Lengths of units in mm, as a user's units may be called.
constexpr std::array<std::pair<const char*, double>, 5> kUnits{
    {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}, {"µm", 1e-3}}};

// In the order of the choices.
constexpr std::array kSeparatorChoices{',', ';', '\t', ' '};
constexpr std::array kDecimalSigns{'.', ','};

class ImportDialog : public QDialog {
 public:
  ImportDialog(Editor& editor, const std::filesystem::path& path, QWidget* parent)
      : QDialog(parent), editor_(editor), path_(path), file_(textOf(path.filename()))
  {
    setObjectName("importDialog");
    setWindowTitle(tr("Import %1").arg(file_));
    summary_ = newText("summary");
    summary_->setText(tr("Looking for the places on the surface…"));
    busy_ = new QProgressBar;
    busy_->setRange(0, 0);
    busy_->setTextVisible(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(newFormatRows());
    layout->addWidget(summary_);
    layout->addWidget(busy_);
    layout->addLayout(newToleranceRow());
    layout->addWidget(newTable(), 1);
    layout->addWidget(newButtons());
    table_->setFocus();
    resize(fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 30);
    connect(&model_, &QAbstractItemModel::dataChanged, this, &ImportDialog::updateTexts);
    connect(&model_, &QAbstractItemModel::modelReset, this, &ImportDialog::updateTexts);
    connect(&job_, &BackgroundJob::failed, this, [this](const std::exception_ptr& error) {
      reject();
      showProblem(parentWidget(), tr("“%1” cannot be imported.").arg(file_), error);
    });
    connect(this, &QDialog::finished, &job_, &BackgroundJob::cancel);
    read(std::nullopt);
  }

  void accept() override
  {
    const std::vector<Index> rows = model_.tickedConstraints();
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
  void read(const std::optional<PointTableFormat>& format)
  {
    busy_->show();
    job_.start(
        [this, path = path_, format, model = editor_.model(), state = editor_.history().state()](Progress& progress) {
          progress.step("reading");
          auto contents = std::make_shared<ImportContents>(readImport(path, format, state->list, *model));
          return [this, contents] {
            busy_->hide();
            model_.setContents(std::move(*contents), tolerance_->typed().value_or(usualTolerance(*editor_.model())));
            table_->resizeColumnsToContents();
            showFormat();
          };
        });
  }

  /// How a point list is written. Another choice reads it again.
  QWidget* newFormatRows()
  {
    formatRows_ = new QWidget;
    auto* rows = newLayout<QVBoxLayout>(formatRows_, 0, 6);
    const auto addChoice = [this](QHBoxLayout& row, const QString& title, const QString& name,
                                  const QStringList& choices) {
      auto* label = new QLabel(title);
      auto* box = named(new QComboBox, name, QString(title).remove('&'));
      box->addItems(choices);
      label->setBuddy(box);
      row.addWidget(label);
      row.addWidget(box);
      connect(box, qOverload<int>(&QComboBox::activated), this, [this] { read(chosenFormat()); });
      return box;
    };
    auto* writing = newLayout<QHBoxLayout>(nullptr, 0, 6);
    separator_ =
        addChoice(*writing, tr("&Separator"), "separator", {tr("comma"), tr("semicolon"), tr("tab"), tr("blanks")});
    decimalSign_ = addChoice(*writing, tr("&Decimal sign"), "decimalSign", {tr("point"), tr("comma")});
    const auto ofModel = std::ranges::find(kUnits, editor_.list().units, &std::pair<const char*, double>::first);
    units_ = addChoice(*writing, tr("&Unit"), "unit", {tr("as the model")});
    units_->setItemData(0, 1.0);
    for (const auto& [unit, length] : kUnits)
      if (ofModel == kUnits.end())
        units_->addItem(tr("%1, of a model in mm").arg(unit), length);
      else
        units_->addItem(unit, length / ofModel->second);
    writing->addStretch(1);
    auto* meaning = newLayout<QHBoxLayout>(nullptr, 0, 6);
    for (std::size_t k = 0; k < kPointColumns.size(); ++k)
      columns_[k] = addChoice(*meaning, toText(kPointColumns[k]).replace('_', ' '), "column" + QString::number(k), {});
    meaning->addStretch(1);
    rows->addLayout(writing);
    rows->addLayout(meaning);
    formatRows_->hide();
    return formatRows_;
  }

  void showFormat()
  {
    const std::optional<PointTable>& table = model_.contents().table;
    formatRows_->setVisible(table.has_value());
    if (!table) return;
    const auto placeOf = [](const auto& choices, char chosen) {
      return static_cast<int>(std::ranges::find(choices, chosen) - choices.begin());
    };
    separator_->setCurrentIndex(placeOf(kSeparatorChoices, table->format.separator));
    decimalSign_->setCurrentIndex(placeOf(kDecimalSigns, table->format.decimalSign));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      columns_[k]->clear();
      columns_[k]->addItem(tr("none"));
      for (const std::string& title : table->titles) columns_[k]->addItem(nameText(title));
      const auto& place = table->format.columns[k];
      columns_[k]->setCurrentIndex(place ? static_cast<int>(*place) + 1 : 0);
    }
  }

  /// Columns belong to a separator: another one finds its own.
  [[nodiscard]] std::optional<PointTableFormat> chosenFormat() const
  {
    PointTableFormat format = model_.contents().table->format;
    const char separator = kSeparatorChoices[static_cast<std::size_t>(separator_->currentIndex())];
    format.decimalSign = kDecimalSigns[static_cast<std::size_t>(decimalSign_->currentIndex())];
    format.scale = units_->currentData().toDouble();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const int chosen = columns_[k]->currentIndex();
      format.columns[k] = chosen > 0 ? std::optional(static_cast<std::size_t>(chosen - 1)) : std::nullopt;
    }
    if (std::exchange(format.separator, separator) != separator) format.columns = {};
    return format;
  }

  QLayout* newToleranceRow()
  {
    tolerance_ = named(new NumberEdit, "tolerance", tr("Tolerance of the distance from the surface"));
    tolerance_->setNumber(usualTolerance(*editor_.model()));
    connect(tolerance_, &NumberEdit::entered, &model_, &ImportTable::setTolerance);
    connect(tolerance_, &NumberEdit::refused, summary_, &QLabel::setText);
    connect(tolerance_, &NumberEdit::righted, this, &ImportDialog::updateTexts);
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
    // The widths fit a hundred rows: there may be a hundred thousand.
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
    LengthStyle style = editor_.lengthStyle();
    if (style.units.empty()) style.units = model_.contents().list.units;
    QStringList parts;
    const auto add = [&](Index count, const QString& one, const QString& several) {
      if (count > 0) parts << (count == 1 ? one : several.arg(count));
    };
    if (const auto& table = model_.contents().table; table && table->doubt)
      parts << tr("It is not certain what the columns mean: %1.").arg(toText(table->doubt->reason));
    const QString reach = tr(", %1 from the surface at most and %2 on average.")
                              .arg(lengthText(preview.maxDistance, style), lengthText(preview.meanDistance, style));
    add(model_.faultyRows(), tr("One row has a fault: it is marked, and left out unless it is ticked."),
        tr("%1 rows have faults: they are marked, and left out unless they are ticked."));
    add(static_cast<Index>(preview.points.size()), tr("One point") + reach, tr("%1 points") + reach);
    add(model_.farPoints(),
        tr("One lies farther away than the tolerance below: is it in another unit or coordinate system?"),
        tr("%1 lie farther away than the tolerance below: are they in another unit or coordinate system?"));
    add(preview.others, tr("One constraint by ids or regions of the mesh."),
        tr("%1 constraints by ids or regions of the mesh."));
    add(preview.takenNames, tr("One name is taken: its constraint gets another."),
        tr("%1 names are taken: their constraints get others."));
    return parts.join(' ');
  }

  void updateTexts()
  {
    const std::size_t count = model_.tickedConstraints().size();
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
  std::filesystem::path path_;
  QString file_;
  ImportTable model_;
  QWidget* formatRows_ = nullptr;
  QComboBox* separator_ = nullptr;
  QComboBox* decimalSign_ = nullptr;
  QComboBox* units_ = nullptr;
  std::array<QComboBox*, kPointColumns.size()> columns_{};
  QProgressBar* busy_ = nullptr;
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
